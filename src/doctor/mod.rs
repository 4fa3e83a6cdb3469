//! Can this machine measure, and how finely: the noise between identical pieces of code, the
//! predictor's memory, and whether the verdicts hold what they promise.
//!
//! ```text
//! Ward (reference, copies, chain) --noise--> A/A floor per order
//!                                 --predictor--> capacity    --advice--> plain sentences
//!                                 --trials--> false alarms, injected slow-downs
//! ```

mod advice;
mod examination;
mod noise;
mod oracle;
mod predictor;
mod slowed;
mod trials;
mod ward;

pub use advice::advice;
pub use examination::Examination;
pub use noise::{Noise, noise};
pub use oracle::{OracleSpeed, oracle_speed};
pub use predictor::{Predictor, predictor};
pub use slowed::Slowed;
pub use trials::{AaTrials, InjectedTrial, InjectedTrials, aa_trials, injected_trials};
pub use ward::{DoctorError, Ward};
