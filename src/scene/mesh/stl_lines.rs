//! The lines of an STL file of text, one at a time.

use super::Dropped;
use std::cell::Cell;
use std::io::{self, Read, Seek, SeekFrom};

/// What the loader wants a first line to look like, whatever the name of the solid.
const FIRST: &[u8] = b"solid \n";

/// Longest line, bytes.
const LONGEST: usize = 1 << 20;

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
    /// Bytes of the present line that were handed out, and whether it is at its end.
    length: usize,
    is_over: bool,
    /// The loader rounds to f32 itself and does not say; so numbers are looked at here.
    pub(super) rounded: Dropped,
}

impl<'a> Lines<'a> {
    /// From the first word of a solid on, blank lines before it skipped; `None` where something else
    /// begins, at the line that `number` then says.
    pub(super) fn new(bytes: &'a [u8], number: &'a Cell<u64>) -> Option<Self> {
        let all = bytes.trim_ascii_start();
        let blank = &bytes[..bytes.len() - all.len()];
        let lines = blank.iter().filter(|byte| **byte == b'\n').count();
        let before = number.get() + lines as u64;
        number.set(before + 1);
        if !all.starts_with(b"solid") {
            return None;
        }
        let rounded = Dropped::default();
        let mut lines =
            Lines { all, rest: all, first: &[], number, before, length: 0, is_over: true, rounded };
        lines.start();
        Some(lines)
    }

    fn start(&mut self) {
        let end = self.all.iter().position(|byte| *byte == b'\n');
        self.rest = &self.all[end.map_or(self.all.len(), |end| end + 1)..];
        self.number.set(self.before + 1);
        self.first = FIRST;
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
        // A line that is longer than the loader's buffer goes out in pieces.
        let most = &self.rest[..self.rest.len().min(buffer.len())];
        let end = most.iter().position(|byte| *byte == b'\n');
        let (piece, rest) = self.rest.split_at(end.map_or(most.len(), |end| end + 1));
        self.rest = rest;
        self.length = if self.is_over { piece.len() } else { self.length + piece.len() };
        self.is_over = end.is_some() || rest.is_empty();
        if self.length > LONGEST {
            self.number.set(self.number.get() + 1);
            let message = format!("the line has more than {LONGEST} bytes");
            return Err(io::Error::new(io::ErrorKind::InvalidData, message));
        }
        self.number.set(self.number.get() + u64::from(self.is_over && !piece.is_empty()));
        self.look(piece);
        buffer[..piece.len()].copy_from_slice(piece);
        Ok(piece.len())
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
