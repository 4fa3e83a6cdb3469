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

/// A line that makes the mesh: what it is about, and what stands behind its first word.
type Line<'a> = (Kind, Cow<'a, [u8]>);

/// What a line is about.
enum Kind {
    Vertex,
    Face,
}

impl<'a> Sieve<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Sieve { rest: bytes, line: Vec::new(), taken: 0, next_line: 1, seen: Seen::default() }
    }

    /// Looks through all lines and hands none on: what is wrong with a face is found before anything is
    /// built.
    pub(super) fn look(mut self) -> Seen {
        let mut one = || -> Result<bool, String> {
            match self.next()? {
                None => return Ok(false),
                Some((Kind::Vertex, _)) => self.seen.vertices += 1,
                Some((Kind::Face, text)) => {
                    self.line.clear();
                    self.seen.face(words(&text), &mut self.line)?;
                }
            }
            Ok(true)
        };
        let end = loop {
            match one() {
                Ok(true) => {}
                Ok(false) => break None,
                Err(message) => break Some(message),
            }
        };
        self.seen.refused = end;
        self.seen
    }

    /// Puts the next `v` or `f` into `line`; an empty one means the end.
    fn advance(&mut self) -> Result<(), String> {
        self.line.clear();
        self.taken = 0;
        while let Some((kind, text)) = self.next()? {
            match kind {
                Kind::Vertex => {
                    self.seen.vertices += 1;
                    self.vertex(words(&text));
                }
                Kind::Face if self.seen.face(words(&text), &mut self.line)? => {}
                Kind::Face => continue,
            }
            self.line.push(b'\n');
            break;
        }
        Ok(())
    }

    /// The next `v` or `f` with what stands behind it; `None` at the end.
    fn next(&mut self) -> Result<Option<Line<'a>>, String> {
        while !self.rest.is_empty() {
            self.seen.line = self.next_line;
            let text = self.joined()?;
            let begin = text.len() - text.trim_ascii_start().len();
            let kind = match text.get(begin) {
                Some(b'v') => Kind::Vertex,
                Some(b'f') => Kind::Face,
                _ => continue,
            };
            // `vn` and the like are other words.
            if text.get(begin + 1).is_none_or(|byte| byte.is_ascii_whitespace() || *byte == b'#') {
                let behind = match text {
                    Cow::Borrowed(text) => Cow::Borrowed(&text[begin + 1..]),
                    Cow::Owned(text) => Cow::Owned(text[begin + 1..].to_vec()),
                };
                return Ok(Some((kind, behind)));
            }
        }
        Ok(None)
    }

    /// Writes a vertex, without its colour: the loader wants all of them to have one, or none.
    fn vertex<'w>(&mut self, words: impl Iterator<Item = &'w [u8]>) {
        self.line.push(b'v');
        let (mut count, mut end_of_place) = (0, 0);
        for word in words {
            self.line.push(b' ');
            self.line.extend(word);
            count += 1;
            if count == 3 {
                end_of_place = self.line.len();
            }
        }
        if count == 6 {
            self.line.truncate(end_of_place);
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

/// The words of a line, without those of a comment.
fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    let is_over = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'#';
    let mut rest = text;
    std::iter::from_fn(move || {
        rest = rest.trim_ascii_start();
        let end = rest.iter().position(is_over).unwrap_or(rest.len());
        let (word, behind) = rest.split_at(end);
        rest = behind;
        (!word.is_empty()).then_some(word)
    })
}

/// A whole number, as it is parsed; nearly all are a few digits, which is quicker.
fn number(word: &[u8]) -> Option<i64> {
    if (1..=MOST_DIGITS).contains(&word.len()) && word.iter().all(u8::is_ascii_digit) {
        return Some(word.iter().fold(0, |sum, digit| 10 * sum + i64::from(digit - b'0')));
    }
    str::from_utf8(word).ok()?.parse().ok()
}

/// Numbers of so many digits fit.
const MOST_DIGITS: usize = 18;

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
            let count = self.vertices as i64;
            match number(index) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_as_they_are_parsed() {
        for word in ["0", "7", "0012", "999999999999999999", "9223372036854775807", "-3", "+5"] {
            assert_eq!(number(word.as_bytes()), word.parse().ok(), "{word}");
        }
        for word in ["", "-", "1.5", "9223372036854775808", "1a", "\u{661}"] {
            assert_eq!(number(word.as_bytes()), None, "{word}");
        }
    }

    #[test]
    fn a_look_sees_what_is_handed_on() {
        let text =
            b"vn 1 0 0\n v 0 0 0 # f 9 9 9\nv#\nf 1 2\nf 1//1 2/3 \\\n-1 4#5\nfoo\nv 1 2 3 4 5 6";
        let mut sieve = Sieve::new(text);
        let mut handed = String::new();
        sieve.read_to_string(&mut handed).expect("nothing is wrong");
        assert_eq!(handed, "v 0 0 0\nv\nf 1 2 -1 4\nv 1 2 3\n");
        let looked = Sieve::new(text).look();
        assert_eq!((looked.vertices, looked.largest), (3, (4, 5)));
        let counts = |seen: &Seen| (seen.vertices, seen.largest, seen.dropped, seen.line);
        assert_eq!(counts(&looked), counts(&sieve.seen));
        let refused = Sieve::new(b"v 0 0 0\nf 1 1 x\n").look().refused.expect("x is no number");
        assert!(refused.starts_with("'x' is no vertex"), "{refused}");
    }
}
