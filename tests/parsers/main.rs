//! Whatever the bytes, every reader of the program has an answer: all files that the fuzzer keeps, all that it has ever
//! failed on, and damage to each of them that is the same in every run. `tests/fuzz/run.sh` looks for new ones.
#![cfg(feature = "cli")]

mod doors;
mod mutation;

use mutation::damaged;
use ray_test::workload::Pcg;
use std::path::Path;

/// Says, if a door panics, what was before it.
struct Before<'a> {
    what: &'a str,
    bytes: &'a [u8],
}

impl Drop for Before<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("{}: {}", self.what, self.bytes.escape_ascii());
        }
    }
}

/// The files of a target, by name.
fn files(target: &str) -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    for kind in ["corpus", "found"] {
        let folder =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz").join(kind).join(target);
        for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            let name = format!("{kind}/{target}/{}", entry.file_name().display());
            files.push((name, std::fs::read(entry.path()).expect("a file of ours")));
        }
    }
    files.sort();
    files
}

/// Opens a door for each file, and for so many damaged ones in all.
fn open(target: &str, damages: usize) {
    let (_, door) = doors::ALL.iter().find(|(name, _)| *name == target).expect("a target");
    let files = files(target);
    assert!(files.len() > 1, "the files of {target} are gone");
    for (what, bytes) in &files {
        let _before = Before { what, bytes };
        door(bytes);
    }
    let mut pcg = Pcg::new(2026);
    for turn in 0..damages {
        let (what, bytes) = &files[turn % files.len()];
        let other = &files[pcg.below(files.len() as u64) as usize].1;
        let bytes = damaged(bytes, other, &mut pcg);
        let _before = Before { what: &format!("{what}, damaged"), bytes: &bytes };
        door(&bytes);
    }
}

macro_rules! targets {
    ($($name:ident: $damages:literal,)*) => {
        $(
            #[test]
            fn $name() {
                open(stringify!($name), $damages);
            }
        )*

        #[test]
        fn every_door_is_opened() {
            let opened = [$(stringify!($name)),*];
            assert!(doors::ALL.iter().all(|(name, _)| opened.contains(name)));
            assert_eq!(opened.len(), doors::ALL.len());
        }
    };
}

// As many as take about a second.
targets! {
    arguments: 2000,
    config: 500,
    cases: 2000,
    rays: 2000,
    stored: 1000,
    rows_json: 300,
    report: 20,
    obj: 2000,
    ply: 2000,
    stl: 2000,
    papers: 2000,
}
