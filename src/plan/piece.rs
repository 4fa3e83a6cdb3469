//! A piece of work that a test, or the way to it, may or may not do.

use super::evidence::Saving;
use super::form::Form;
use super::situation::Situation;

/// A piece of work.
pub struct Piece {
    /// Its name in plans.
    pub name: &'static str,
    /// What the situation says about it.
    pub look: fn(&Situation) -> Look,
    /// Whether a form does it. `None` where no form differs by it: the look decides alone.
    pub done_by: Option<fn(&Form) -> bool>,
    /// Two forms, with it and without it, whose times side by side say what it costs; `{level}` stands for
    /// the machine's lowest level.
    pub pair: Option<[&'static str; 2]>,
}

/// What the situation says about a piece.
#[derive(Clone, Debug, PartialEq)]
pub enum Look {
    /// It must be done.
    Needed(String),
    /// It may be left out.
    Spare(String),
    /// It may be left out, and that was measured otherwise than by two forms.
    Measured(String, Saving),
    /// It may be left out or done, whichever is faster.
    Open(String),
}

impl Look {
    /// Why.
    pub fn because(&self) -> &str {
        match self {
            Look::Needed(because)
            | Look::Spare(because)
            | Look::Measured(because, _)
            | Look::Open(because) => because,
        }
    }

    /// Whether it may be left out.
    pub fn is_spare(&self) -> bool {
        !matches!(self, Look::Needed(_))
    }

    /// Whether a form that does it does more than it has to.
    pub fn is_waste(&self) -> bool {
        matches!(self, Look::Spare(_) | Look::Measured(..))
    }
}

impl Piece {
    /// Whether a form does without it.
    pub fn is_left_out_by(&self, form: &Form) -> bool {
        self.done_by.is_some_and(|done_by| !done_by(form))
    }

    /// The ids of its pair on a machine whose lowest level is that.
    pub fn pair_at(&self, level: &str) -> Option<[String; 2]> {
        self.pair.map(|pair| pair.map(|id| id.replace("{level}", level)))
    }
}
