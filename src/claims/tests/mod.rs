//! Claims judged by rows that were made up, with a known answer.

mod cases;
mod conditions;
mod every;
mod made;
mod refused;
mod selection;
