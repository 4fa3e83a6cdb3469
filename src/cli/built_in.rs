//! The experiments that are compiled in.

use super::failure::Failure;
use crate::experiment::Experiment;

/// The experiments under `configs/`, as file name and text; made by the build script.
mod embedded {
    include!(concat!(env!("OUT_DIR"), "/configs.rs"));
}

/// An experiment's file name and text.
pub type Source = (String, String);

/// The files that are compiled in.
pub fn built_in_sources() -> Vec<Source> {
    let owned = |(name, text): &(&str, &str)| (format!("configs/{name}"), (*text).to_owned());
    embedded::CONFIGS.iter().map(owned).collect()
}

/// The experiments that are compiled in, with their files.
///
/// # Errors
/// None, unless a file was compiled in that no test has read.
pub fn built_in() -> Result<Vec<(String, Experiment)>, Failure> {
    let parse = |(name, text): Source| Ok((name.clone(), Experiment::parse(&name, &text)?));
    built_in_sources().into_iter().map(parse).collect()
}
