//! The lines of an OBJ file that make its mesh, one at a time.
//!
//! The loader says neither at which line it stopped nor which index is too large, and reads normals,
//! texture coordinates and materials, which no mesh needs. So it is given the lines `v` and `f`
//! alone, faces without what stands behind a slash, and this file keeps the place.

use super::Dropped;
use std::borrow::Cow;
use std::io::{self, BufRead, Read};

/// Longest line, bytes.
const LONGEST: usize = 1 << 20;

/// What the lines so far had in them.
#[derive(Default)]
pub(super) struct Seen {
    /// Line of the last that was handed on, from 1.
    pub(super) line: u64,
    /// Vertices.
    pub(super) vertices: u64,
    /// Faces of more and of fewer corners than three.
    pub(super) dropped: Dropped,
    /// The largest index of a face, and its line.
    pub(super) largest: (i64, u64),
    /// Why the reading ended, if it was here.
    pub(super) refused: Option<String>,
}

/// Hands the lines on.
pub(super) struct Sieve<'a> {
    rest: &'a [u8],
    /// The present line, and how much of it was taken.
    line: Vec<u8>,
    taken: usize,
    next_line: u64,
    /// What was in the lines.
    pub(super) seen: Seen,
}

impl<'a> Sieve<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Sieve { rest: bytes, line: Vec::new(), taken: 0, next_line: 1, seen: Seen::default() }
    }

    /// Puts the next `v` or `f` into `line`; an empty one means the end.
    fn advance(&mut self) -> Result<(), String> {
        self.line.clear();
        self.taken = 0;
        while !self.rest.is_empty() {
            self.seen.line = self.next_line;
            let text = self.joined()?;
            let text = text.split(|byte| *byte == b'#').next().unwrap_or_default();
            let mut words = text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
            match words.next() {
                Some(b"v") => {
                    self.seen.vertices += 1;
                    self.vertex(words);
                }
                Some(b"f") if self.seen.face(words, &mut self.line)? => {}
                _ => continue,
            }
            self.line.push(b'\n');
            return Ok(());
        }
        Ok(())
    }

    /// Writes a vertex, without its colour: the loader wants all of them to have one, or none.
    fn vertex<'w>(&mut self, words: impl Iterator<Item = &'w [u8]> + Clone) {
        let count = words.clone().count();
        self.line.push(b'v');
        for word in words.take(if count == 6 { 3 } else { count }) {
            self.line.push(b' ');
            self.line.extend(word);
        }
    }

    /// The next line, with those that it goes on in.
    fn joined(&mut self) -> Result<Cow<'a, [u8]>, String> {
        let mut text = Cow::Borrowed(&[] as &[u8]);
        loop {
            let end = self.rest.iter().position(|byte| *byte == b'\n');
            let (line, rest) = self.rest.split_at(end.map_or(self.rest.len(), |end| end + 1));
            self.rest = rest;
            self.next_line += 1;
            if text.len() + line.len() > LONGEST {
                return Err(format!("allowed: lines of at most {LONGEST} bytes"));
            }
            let line = line.trim_ascii_end();
            match line.strip_suffix(b"\\") {
                Some(begun) if !rest.is_empty() => text.to_mut().extend(begun),
                _ if text.is_empty() => return Ok(Cow::Borrowed(line)),
                _ => {
                    text.to_mut().extend(line);
                    return Ok(text);
                }
            }
        }
    }
}

impl Seen {
    /// Writes a face of three or more corners; `false` for fewer.
    fn face<'a>(
        &mut self,
        words: impl Iterator<Item = &'a [u8]>,
        line: &mut Vec<u8>,
    ) -> Result<bool, String> {
        let mut corners = 0;
        line.push(b'f');
        for word in words {
            let index = word.split(|byte| *byte == b'/').next().unwrap_or_default();
            let number = str::from_utf8(index).ok().and_then(|index| index.parse::<i64>().ok());
            let count = self.vertices as i64;
            match number {
                Some(number) if number > 0 => {
                    self.largest = self.largest.max((number, self.line));
                }
                Some(number) if number < 0 && number >= -count => {}
                _ => {
                    let word = index[..index.len().min(20)].escape_ascii();
                    return Err(format!(
                        "'{word}' is no vertex; allowed: 1 to the number of vertices, or -1 and \
                         below to count back, here from {count}"
                    ));
                }
            }
            line.push(b' ');
            line.extend(index);
            corners += 1;
        }
        self.dropped.polygons += u64::from(corners > 3);
        if corners < 3 {
            self.dropped.faces += 1;
            line.clear();
        }
        Ok(corners >= 3)
    }
}

impl BufRead for Sieve<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken == self.line.len()
            && let Err(message) = self.advance()
        {
            self.seen.refused = Some(message);
            return Err(io::Error::from(io::ErrorKind::InvalidData));
        }
        Ok(&self.line[self.taken..])
    }

    fn consume(&mut self, amount: usize) {
        self.taken += amount;
    }
}

impl Read for Sieve<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}
