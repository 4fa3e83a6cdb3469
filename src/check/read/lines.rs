//! An input line by line.

use super::error::ReadError;
use std::io::{BufRead, Read};

/// Longest line, bytes: far more than a case needs, and no more than one wants in memory.
const LONGEST: u64 = 1 << 20;

/// What some editors put before the first line of UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

/// Lines that are not blank, with their numbers.
pub struct Lines<R> {
    input: R,
    file: String,
    number: u64,
    bytes: Vec<u8>,
}

impl<R: BufRead> Lines<R> {
    /// `file` is what messages call the input.
    pub fn new(input: R, file: &str) -> Self {
        Lines { input, file: file.to_owned(), number: 0, bytes: Vec::new() }
    }

    /// The next line that is not blank, without what ends it.
    pub fn advance(&mut self) -> Result<Option<&str>, ReadError> {
        loop {
            self.bytes.clear();
            let mut limited = self.input.by_ref().take(LONGEST);
            let read = limited.read_until(b'\n', &mut self.bytes);
            if read.map_err(|source| ReadError::Io { file: self.file.clone(), source })? == 0 {
                return Ok(None);
            }
            self.number += 1;
            if self.bytes.len() as u64 == LONGEST && !self.bytes.ends_with(b"\n") {
                return Err(self.bad("", format!("allowed: lines of less than {LONGEST} bytes")));
            }
            if self.number == 1 && self.bytes.starts_with(MARK) {
                self.bytes.drain(..MARK.len());
            }
            if !self.bytes.iter().all(u8::is_ascii_whitespace) {
                break;
            }
        }
        match std::str::from_utf8(&self.bytes) {
            Ok(line) => Ok(Some(line.trim_end_matches(['\n', '\r']))),
            Err(_) => Err(self.bad("", "not UTF-8; allowed: UTF-8".into())),
        }
    }

    /// An error at the present line.
    pub fn bad(&self, place: &str, message: String) -> ReadError {
        let (file, place) = (self.file.clone(), place.to_owned());
        ReadError::Line { file, line: self.number, place, message }
    }

    /// An error of the file as a whole.
    pub fn whole(&self, message: String) -> ReadError {
        ReadError::Whole { file: self.file.clone(), message }
    }
}
