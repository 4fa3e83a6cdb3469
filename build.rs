//! Tells the program how it was built: compiler, flags, commit. Nothing here can fail the build;
//! what cannot be found out is left empty.

use std::env;
use std::path::Path;
use std::process::Command;

fn main() {
    for source in ["src", "configs", "Cargo.toml", "Cargo.lock"] {
        if Path::new(source).exists() {
            println!("cargo:rerun-if-changed={source}");
        }
    }
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=RUSTFLAGS");
    println!("cargo:rerun-if-env-changed=CARGO_ENCODED_RUSTFLAGS");

    let compiler = env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    export("RUSTC", output(&compiler, &["--version"]));
    for name in ["TARGET", "PROFILE", "OPT_LEVEL"] {
        export(name, env::var(name).ok());
    }
    // Flags are separated by 0x1f there, since they may hold spaces.
    let flags = env::var("CARGO_ENCODED_RUSTFLAGS").ok();
    export("RUSTFLAGS", flags.map(|f| f.replace('\u{1f}', " ")));
    export("COMMIT", commit());
    embed_configs();
}

/// Lists the files for the program to carry with it: a new one needs no line of code.
/// A list that cannot be written fails the build where it is included, with its path.
fn embed_configs() {
    embed("configs", "CONFIGS", "configs.rs");
    embed("configs/published", "PAPERS", "papers.rs");
}

/// Writes a list of the TOML files of a folder, with their texts.
fn embed(folder: &str, name: &str, list: &str) {
    let here = env::var("CARGO_MANIFEST_DIR").unwrap_or_default();
    let folder = Path::new(&here).join(folder);
    let entries = std::fs::read_dir(&folder).into_iter().flatten().flatten();
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut names: Vec<String> = names.filter(|name| name.ends_with(".toml")).collect();
    names.sort();
    let item = |name: &String| {
        let path = folder.join(name);
        format!("    ({name:?}, include_str!({:?})),\n", path.display().to_string())
    };
    let items: String = names.iter().map(item).collect();
    let text = format!("pub const {name}: &[(&str, &str)] = &[\n{items}];\n");
    if let Ok(out) = env::var("OUT_DIR") {
        let _ = std::fs::write(Path::new(&out).join(list), text);
    }
}

/// The commit of this package's own repository, `-dirty` behind it if files differ from it.
fn commit() -> Option<String> {
    let top = output("git", &["rev-parse", "--show-toplevel"])?;
    let here = env::var("CARGO_MANIFEST_DIR").ok()?;
    // A copy inside of somebody else's repository has a commit that says nothing of it.
    if Path::new(&top).canonicalize().ok()? != Path::new(&here).canonicalize().ok()? {
        return None;
    }
    if let Some(log) = output("git", &["rev-parse", "--git-path", "logs/HEAD"])
        && Path::new(&log).exists()
    {
        println!("cargo:rerun-if-changed={log}");
    }
    let commit = output("git", &["rev-parse", "HEAD"])?;
    // Without locks: a build must not get in the way of a git command that runs beside it.
    let status = ["--no-optional-locks", "status", "--porcelain", "--untracked-files=no"];
    let differs = output("git", &status).is_some();
    Some(if differs { commit + "-dirty" } else { commit })
}

/// What a command prints, trimmed; `None` if it fails or prints nothing.
fn output(command: &str, arguments: &[&str]) -> Option<String> {
    let done = Command::new(command).args(arguments).output().ok()?;
    let text = String::from_utf8(done.stdout).ok()?.trim().to_owned();
    (done.status.success() && !text.is_empty()).then_some(text)
}

fn export(name: &str, value: Option<String>) {
    let line = value.unwrap_or_default().replace('\n', " ");
    println!("cargo:rustc-env=RAY_TEST_BUILD_{name}={line}");
}
