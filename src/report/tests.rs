//! The report of invented results.
