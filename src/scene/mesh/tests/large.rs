//! Large files: none is trusted with memory.

use super::*;
use crate::workload::Pcg;

/// Bytes of noise: enough that a loader that reserves, or squares, would not end.
const NOISE: usize = 1 << 20;

fn noise(from: u8, to: u8) -> Vec<u8> {
    let mut pcg = Pcg::new(3);
    let width = u64::from(to - from) + 1;
    (0..NOISE).map(|_| from + pcg.below(width) as u8).collect()
}

#[test]
fn much_noise_is_refused() {
    for bytes in [noise(0, 255), noise(b' ', b'~'), noise(b'\n', b'9')] {
        for file in ["a.obj", "a.ply", "a.stl", "a"] {
            let text = refusal(file, bytes.clone());
            assert!(text.len() < 400, "{}", text.len());
            for start in ["ply\nformat ascii 1.0\n", "solid \n"] {
                let bytes = [start.as_bytes(), &bytes].concat();
                assert!(refusal(file, bytes).len() < 400);
            }
        }
    }
}
