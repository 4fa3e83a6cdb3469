//! Whatever the bytes, there is a mesh or a message.

use super::*;
use crate::workload::Pcg;

/// Inputs of each kind.
const COUNT: u64 = 3000;

fn sound(file: &str, bytes: Vec<u8>) -> bool {
    let Ok(mesh) = read(file, bytes) else { return false };
    let count = mesh.vertices.len();
    assert!(mesh.triangles.iter().flatten().all(|corner| (*corner as usize) < count));
    assert!(mesh.vertices.iter().all(|vertex| vertex.is_finite()));
    assert!(!mesh.triangles.is_empty());
    true
}

#[test]
fn noise_is_refused() {
    let mut pcg = Pcg::new(1);
    let starts: [&[u8]; 6] =
        [b"", b"ply\n", b"solid \n", b"v 0 0 0\nf ", b"ply\nformat ascii 1.0\n", b"\0"];
    for index in 0..COUNT {
        let mut bytes = starts[index as usize % starts.len()].to_vec();
        let length = pcg.below(200);
        bytes.extend((0..length).map(|_| pcg.bits() as u8));
        for file in ["a.obj", "a.ply", "a.stl", "a"] {
            assert!(!sound(file, bytes.clone()), "{bytes:?}");
        }
    }
}

#[test]
fn damaged_files_are_sound_or_refused() {
    let mut pcg = Pcg::new(2);
    let files = files();
    // Characters that mean something, so that some of the damage is read as a number.
    let letters = b"0123456789-+.eE/ \n\r#vfx";
    let (mut good, mut bad) = (0, 0);
    for _ in 0..COUNT {
        let (file, bytes) = &files[pcg.below(files.len() as u64) as usize];
        let mut bytes = bytes.clone();
        for _ in 0..=pcg.below(3) {
            let at = pcg.below(bytes.len() as u64) as usize;
            match pcg.below(4) {
                0 => bytes[at] = pcg.bits() as u8,
                1 => bytes[at] = letters[pcg.below(letters.len() as u64) as usize],
                2 => drop(bytes.remove(at)),
                _ => bytes.insert(at, letters[pcg.below(letters.len() as u64) as usize]),
            }
        }
        if sound(file, bytes) { good += 1 } else { bad += 1 }
    }
    assert!(good > 300 && bad > 300, "{good} {bad}");
}
