//! Small damage to a file, drawn from a seed.

use ray_test::workload::Pcg;

/// Numbers and marks that readers get wrong.
const WORDS: [&str; 24] = [
    "-1",
    "0",
    "-0",
    "1e999",
    "-1e999",
    "1e-999",
    "NaN",
    "inf",
    "-inf",
    "18446744073709551615",
    "18446744073709551616",
    "-9223372036854775808",
    "4294967296",
    "2147483648",
    "16777217",
    "1e38",
    "3.5e38",
    "5e-324",
    "\"",
    "\n",
    ",",
    "{",
    "]",
    "\u{fffd}",
];

/// A file with one to four changes; `other` is where pieces come from.
pub fn damaged(bytes: &[u8], other: &[u8], pcg: &mut Pcg) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..=pcg.below(4) {
        change(&mut bytes, other, pcg);
    }
    bytes
}

fn change(bytes: &mut Vec<u8>, other: &[u8], pcg: &mut Pcg) {
    let at = below(pcg, bytes.len() + 1);
    let end = (at + 1 + below(pcg, 24)).min(bytes.len());
    match pcg.below(7) {
        0 if at < end => bytes[at] = pcg.bits() as u8,
        1 if at < end => drop(bytes.drain(at..end)),
        2 => bytes.truncate(at),
        3 if at < end => {
            let piece = bytes[at..end].to_vec();
            bytes.splice(at..at, piece);
        }
        4 if !other.is_empty() => {
            let from = below(pcg, other.len());
            let to = (from + 1 + below(pcg, 60)).min(other.len());
            bytes.splice(at..at, other[from..to].iter().copied());
        }
        _ => word(bytes, at, pcg),
    }
}

/// Puts a word in place of the number or the word that stands there.
fn word(bytes: &mut Vec<u8>, at: usize, pcg: &mut Pcg) {
    let is_part = |byte: &u8| byte.is_ascii_alphanumeric() || b"+-._".contains(byte);
    let begin = bytes[..at].iter().rposition(|byte| !is_part(byte)).map_or(0, |place| place + 1);
    let length = bytes[at..].iter().position(|byte| !is_part(byte));
    let end = length.map_or(bytes.len(), |length| at + length);
    let word = WORDS[below(pcg, WORDS.len())];
    bytes.splice(begin..end, word.bytes());
}

fn below(pcg: &mut Pcg, count: usize) -> usize {
    pcg.below(count as u64) as usize
}
