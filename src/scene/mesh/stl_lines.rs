//! The lines of an STL file of text, one at a time.

use super::Dropped;
use std::cell::Cell;
use std::io::{self, Read, Seek, SeekFrom};

/// What the loader wants a first line to look like, whatever the name of the solid.
const FIRST: &[u8] = b"solid \n";

/// Hands out one line a call and counts them. The loader's own buffer asks for the next only when
/// it has used up the last, so the count is the line that the loader is at.
pub(super) struct Lines<'a> {
    all: &'a [u8],
    /// What was not handed out yet.
    pub(super) rest: &'a [u8],
    /// What of the first line was not handed out.
    first: &'a [u8],
    /// Lines handed out, those of earlier solids included.
    number: &'a Cell<u64>,
    before: u64,
    /// The loader rounds to f32 itself and does not say; so numbers are looked at here.
    pub(super) rounded: Dropped,
}

impl<'a> Lines<'a> {
    /// From the first word of a solid on, blank lines before it skipped.
    pub(super) fn new(bytes: &'a [u8], number: &'a Cell<u64>) -> Self {
        let solid = bytes.trim_ascii_start();
        let blank = &bytes[..bytes.len() - solid.len()];
        let lines = blank.iter().filter(|byte| **byte == b'\n').count();
        number.set(number.get() + lines as u64);
        let rounded = Dropped::default();
        let before = number.get();
        let mut lines = Lines { all: solid, rest: solid, first: &[], number, before, rounded };
        lines.start();
        lines
    }

    fn start(&mut self) {
        self.number.set(self.before);
        self.rest = self.all;
        if self.all.starts_with(b"solid") {
            self.next_line();
            self.first = FIRST;
        }
    }

    fn next_line(&mut self) -> &'a [u8] {
        let end = self.rest.iter().position(|byte| *byte == b'\n');
        let (line, rest) = self.rest.split_at(end.map_or(self.rest.len(), |end| end + 1));
        self.rest = rest;
        self.number.set(self.number.get() + u64::from(!line.is_empty()));
        line
    }

    /// Looks at the numbers of a vertex.
    fn look(&mut self, line: &[u8]) {
        let Ok(text) = str::from_utf8(line) else { return };
        if let Some(numbers) = text.trim_ascii_start().strip_prefix("vertex") {
            let numbers = numbers.split_ascii_whitespace().map_while(|number| number.parse().ok());
            numbers.for_each(|number| self.rounded.rounds(number));
        }
    }
}

impl Read for Lines<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if !self.first.is_empty() {
            return self.first.read(buffer);
        }
        let rest = self.rest;
        let number = self.number.get();
        let line = self.next_line();
        if line.len() > buffer.len() {
            // A line that is longer than the loader's buffer goes out in pieces.
            self.rest = rest;
            self.number.set(number);
            return self.rest.read(buffer);
        }
        self.look(line);
        buffer[..line.len()].copy_from_slice(line);
        Ok(line.len())
    }
}

impl Seek for Lines<'_> {
    /// The loader looks at the first line and goes back to the start; nothing else is needed.
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        if position != SeekFrom::Start(0) {
            return Err(io::Error::from(io::ErrorKind::Unsupported));
        }
        self.start();
        Ok(0)
    }
}
