//! Kinds of operations, and which of them stand in a stream.

/// Operations of one walk through the loop.
pub const PLACES: usize = 12;

/// A kind of operation that has units of its own, or shares them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    /// An addition or subtraction.
    Add = 1,
    /// A multiplication.
    Multiply,
    /// A multiplication and addition with one rounding.
    Fused,
    /// A division.
    Divide,
    /// A comparison whose answer joins a mask.
    Compare,
    /// One of two numbers by a mask.
    Select,
    /// A sign flipped.
    Flip,
    /// A number loaded into every lane, and added.
    Load,
}

impl Kind {
    /// All of them, in the order of their digits.
    pub const ALL: [Kind; 8] = [
        Kind::Add,
        Kind::Multiply,
        Kind::Fused,
        Kind::Divide,
        Kind::Compare,
        Kind::Select,
        Kind::Flip,
        Kind::Load,
    ];

    /// Its name in rows and charts.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Add => "add",
            Kind::Multiply => "multiply",
            Kind::Fused => "fused",
            Kind::Divide => "divide",
            Kind::Compare => "compare",
            Kind::Select => "select",
            Kind::Flip => "flip",
            Kind::Load => "load",
        }
    }
}

/// Which kinds stand in the loop: place i holds the digit 16^i.
pub mod mix {
    use super::{Kind, PLACES};

    /// One kind at every place.
    pub const fn alone(kind: Kind) -> u64 {
        kind as u64 * 0x1111_1111_1111
    }
    /// Two kinds in turn.
    pub const fn half(one: Kind, other: Kind) -> u64 {
        one as u64 * 0x1010_1010_1010 + other as u64 * 0x0101_0101_0101
    }
    /// One kind at every third place, another at the rest.
    pub const fn third(one: Kind, rest: Kind) -> u64 {
        one as u64 * 0x1001_0010_0100 + rest as u64 * 0x0110_1101_1011
    }
    /// The digit of a place.
    pub const fn digit(mix: u64, place: usize) -> u64 {
        mix >> (4 * place) & 15
    }
    /// How far it is from a kind's place to its next, in mixes that hold it.
    pub const fn step(mix: u64, kind: Kind) -> usize {
        match count(mix, kind) {
            0 => PLACES,
            count => PLACES / count,
        }
    }
    /// How many operations of a kind there are.
    pub const fn count(mix: u64, kind: Kind) -> usize {
        let (mut count, mut place) = (0, 0);
        while place < PLACES {
            count += (digit(mix, place) == kind as u64) as usize;
            place += 1;
        }
        count
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mixes_hold_what_they_are_said_to() {
        let counts = |mix| Kind::ALL.map(|kind| mix::count(mix, kind));
        assert_eq!(counts(mix::alone(Kind::Load)), [0, 0, 0, 0, 0, 0, 0, 12]);
        assert_eq!(counts(mix::half(Kind::Add, Kind::Flip)), [6, 0, 0, 0, 0, 0, 6, 0]);
        assert_eq!(counts(mix::third(Kind::Select, Kind::Flip)), [0, 0, 0, 0, 0, 4, 8, 0]);
        assert_eq!(mix::step(mix::third(Kind::Select, Kind::Flip), Kind::Select), 3);
        assert_eq!(mix::digit(mix::half(Kind::Add, Kind::Flip), 0), Kind::Flip as u64);
    }
}
