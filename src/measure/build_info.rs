//! How this program was built, as its build script saw it.

use serde::{Deserialize, Serialize};

/// Compiler, flags and origin of a binary.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct BuildInfo {
    /// Version of this package.
    pub version: String,
    /// Commit it was built from, with `-dirty` behind it if files differed; `None` without git.
    pub commit: Option<String>,
    /// `rustc --version`.
    pub compiler: Option<String>,
    /// Target triple.
    pub target: Option<String>,
    /// Profile of cargo that it derives from: `release` or `debug`.
    pub profile: Option<String>,
    /// Optimisation level: 0 to 3, s or z.
    pub opt_level: Option<String>,
    /// Further flags of the compiler.
    pub flags: Option<String>,
    /// Whether assertions of debug builds are in it; times of such a build mean nothing.
    pub debug_assertions: bool,
    /// Width of a pointer, bits.
    pub pointer_bits: u32,
}

impl BuildInfo {
    /// Of the program that is running.
    pub fn of_this_program() -> Self {
        let known = |text: &str| (!text.is_empty()).then(|| text.to_owned());
        BuildInfo {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            commit: known(env!("RAY_TEST_BUILD_COMMIT")),
            compiler: known(env!("RAY_TEST_BUILD_RUSTC")),
            target: known(env!("RAY_TEST_BUILD_TARGET")),
            profile: known(env!("RAY_TEST_BUILD_PROFILE")),
            opt_level: known(env!("RAY_TEST_BUILD_OPT_LEVEL")),
            flags: known(env!("RAY_TEST_BUILD_RUSTFLAGS")),
            debug_assertions: cfg!(debug_assertions),
            pointer_bits: usize::BITS,
        }
    }

    /// One word for the column that tells builds apart, such as `x86_64-unknown-linux-gnu/o3`;
    /// flags add a hash of themselves.
    pub fn label(&self) -> String {
        let target = self.target.as_deref().unwrap_or("unknown");
        let level = self.opt_level.as_deref().unwrap_or("unknown");
        match &self.flags {
            Some(flags) => {
                let hash = super::machine::fnv1a(flags.as_bytes()) as u32;
                format!("{target}/o{level}/{hash:08x}")
            }
            None => format!("{target}/o{level}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn compiler_and_target_are_known() {
        let build = BuildInfo::of_this_program();
        assert!(build.compiler.is_some_and(|c| c.starts_with("rustc ")));
        assert!(build.target.is_some_and(|t| t.contains(std::env::consts::ARCH)));
        assert!(build.opt_level.is_some());
    }

    #[test]
    fn label_tells_flags_apart() {
        let plain = BuildInfo {
            target: Some("t".into()),
            opt_level: Some("3".into()),
            flags: None,
            ..BuildInfo::of_this_program()
        };
        let with = |flags: &str| BuildInfo { flags: Some(flags.into()), ..plain.clone() }.label();
        assert_eq!(plain.label(), "t/o3");
        assert!(with("-C a").starts_with("t/o3/"));
        assert_ne!(with("-C a"), with("-C b"));
    }
}
