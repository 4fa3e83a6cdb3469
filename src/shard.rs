//! A share of clock-free work, so that several machines or jobs can each do one.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// One of several parts of about equal size. The parts of a list follow each other, and together
/// are the list; which part an item is in depends on nothing but the length of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// From 1 to `parts`.
    part: usize,
    parts: usize,
}

/// Words that name no share.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("'{0}' is not allowed; allowed: I/N with whole numbers 1 <= I <= N, for instance 2/3")]
pub struct ShardError(String);

impl Shard {
    /// All of it.
    pub const WHOLE: Shard = Shard { part: 1, parts: 1 };

    /// Its size over that of all.
    pub fn share(self) -> f64 {
        1.0 / self.parts as f64
    }

    /// The places of its items in a list of so many.
    pub fn range(self, count: usize) -> Range<usize> {
        // Wide enough for every product of two lengths.
        let end_of = |part: usize| (count as u128 * part as u128 / self.parts as u128) as usize;
        end_of(self.part - 1)..end_of(self.part)
    }
}

impl Default for Shard {
    fn default() -> Self {
        Shard::WHOLE
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.part, self.parts)
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let number = |text: &str| {
            // `parse` would take a sign as well.
            let digits = text.bytes().all(|byte| byte.is_ascii_digit());
            text.parse().ok().filter(|_| digits)
        };
        let pair = text.split_once('/');
        let pair = pair.and_then(|(part, parts)| Some((number(part)?, number(parts)?)));
        match pair {
            Some((part, parts)) if 1 <= part && part <= parts => Ok(Shard { part, parts }),
            _ => Err(ShardError(text.to_owned())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_follow_each_other_and_differ_by_one_at_most() {
        for (count, parts) in [(0, 1), (7, 1), (7, 3), (2, 5), (1000, 7), (usize::MAX, 3)] {
            let of = |part: usize| Shard { part, parts }.range(count);
            assert_eq!((of(1).start, of(parts).end), (0, count));
            for part in 1..parts {
                assert_eq!(of(part).end, of(part + 1).start);
            }
            let sizes = (1..=parts).map(|part| of(part).len());
            assert!(sizes.clone().max().unwrap_or(0) - sizes.min().unwrap_or(0) <= 1);
        }
        assert_eq!(Shard::WHOLE.range(5), 0..5);
    }

    #[test]
    fn words_are_two_numbers_in_order() {
        let shard: Shard = "2/3".parse().expect("a share");
        assert_eq!((shard, shard.to_string().as_str()), (Shard { part: 2, parts: 3 }, "2/3"));
        for wrong in ["", "1", "0/3", "4/3", "1/0", "+1/3", "-1/3", "1/3/5", "a/b", "1.0/3", " 1/3"]
        {
            let error = wrong.parse::<Shard>().expect_err(wrong);
            assert!(error.to_string().contains("1 <= I <= N"), "{error}");
        }
    }
}
