//! Operations noted with their operands, so that it can be told which of them an optimiser must keep.

use std::cell::RefCell;
use std::collections::HashMap;

/// What is done to numbers or masks. What costs an instruction nothing is there for its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Noted {
    /// A number that a ray, or the search so far, brings along.
    OfRay,
    /// A number stored of a triangle, by its place.
    OfTriangle(usize),
    /// A number stored of several triangles at once, one to a lane, or that rays have in common.
    OfGroup(usize),
    /// A number that was kept of a triangle, put into every lane.
    Kept,
    /// A number that changes in every test, and that a ray has for itself.
    OfBoth,
    /// An addition or subtraction.
    Add,
    /// A multiplication.
    Multiply,
    /// a b + c with one rounding.
    Fused,
    /// A division.
    Divide,
    /// A comparison; the number tells which.
    Compare(u8),
    /// Two masks joined: `and`, or `or`.
    Join(bool),
    /// One of two numbers, by a mask.
    Select,
    /// A sign flipped by another.
    Flip,
    /// A sign changed, a mask turned round, a sign bit looked at, square roots and arc cosines:
    /// mostly folded into their neighbours, and never counted.
    Free(u8),
}

/// A result: a constant by its bits, or an operation by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Place {
    /// Known before anything runs.
    Constant(u64),
    /// Of the tape.
    At(u32),
}

/// A place in one word, which is how numbers and masks carry it: kernels in all their forms are hundreds
/// of thousands of operations, and what each of them moves is code that has to be built.
#[derive(Clone, Copy, Debug)]
pub struct Word(u64);

/// Upper half of the words that are numbers of operations: a NaN that no arithmetic makes.
const OF_TAPE: u64 = 0x7ff8_ace0;

impl Word {
    /// A constant by its bits: of an f64, or 0 and 1 for a mask.
    pub const fn constant(bits: u64) -> Self {
        Word(bits)
    }
    /// Of a place.
    pub fn of(place: Place) -> Self {
        match place {
            Place::Constant(bits) => Word(bits),
            Place::At(at) => Word(OF_TAPE << 32 | u64::from(at)),
        }
    }
    /// The place.
    pub fn place(self) -> Place {
        if self.0 >> 32 == OF_TAPE { Place::At(self.0 as u32) } else { Place::Constant(self.0) }
    }
    /// What a number is.
    #[inline(never)]
    pub fn value(self) -> f64 {
        match self.place() {
            Place::Constant(bits) => f64::from_bits(bits),
            Place::At(at) => TAPE.with_borrow(|tape| tape.entries[at as usize].value),
        }
    }
    /// What a mask is.
    pub fn truth(self) -> bool {
        match self.place() {
            Place::Constant(bits) => bits != 0,
            Place::At(_) => self.value() != 0.0,
        }
    }
}

/// An operation with its operands, its value, and what it depends on.
#[derive(Clone, Copy, Debug)]
struct Entry {
    noted: Noted,
    value: f64,
    operands: [Option<Place>; 3],
    ray: bool,
    triangle: bool,
}

/// What was noted. An operation on the same operands is noted once.
#[derive(Default)]
struct Tape {
    entries: Vec<Entry>,
    known: HashMap<(Noted, [Option<Place>; 3]), u32>,
}

thread_local! {
    static TAPE: RefCell<Tape> = RefCell::new(Tape::default());
}

/// The result of an operation, noted unless it is known already. `value` is what it is as a number: 0
/// or 1 for a mask.
#[inline(never)]
pub fn note(noted: Noted, operands: [Option<Place>; 3], value: f64) -> Place {
    TAPE.with_borrow_mut(|tape| {
        if let Some(at) = tape.known.get(&(noted, operands)) {
            return Place::At(*at);
        }
        let (mut ray, mut triangle) = match noted {
            Noted::OfRay => (true, false),
            Noted::OfTriangle(_) | Noted::OfGroup(_) => (false, true),
            Noted::OfBoth => (true, true),
            _ => (false, false),
        };
        for operand in operands.into_iter().flatten() {
            if let Place::At(at) = operand {
                let entry = tape.entries[at as usize];
                ray |= entry.ray;
                triangle |= entry.triangle;
            }
        }
        let at = tape.entries.len() as u32;
        tape.entries.push(Entry { noted, value, operands, ray, triangle });
        // Two rays' numbers are two, however alike.
        if !matches!(noted, Noted::OfRay | Noted::OfBoth) {
            tape.known.insert((noted, operands), at);
        }
        Place::At(at)
    })
}

/// Operations that some result needs.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Needed {
    /// Those that each lane does for itself in every test.
    pub each: Vec<Noted>,
    /// Those that depend on a triangle alone: done once for all lanes.
    pub once: Vec<Noted>,
}

/// Runs `body` on an empty tape and returns which operations the results need that it names.
/// What depends on a ray alone is done before any triangle, and not among them.
pub fn needed(body: impl FnOnce() -> Vec<Place>) -> Needed {
    let before = TAPE.take();
    let wanted = body();
    needed_of(&TAPE.replace(before), wanted)
}

fn needed_of(tape: &Tape, mut wanted: Vec<Place>) -> Needed {
    let mut seen = vec![false; tape.entries.len()];
    let mut needed = Needed::default();
    while let Some(place) = wanted.pop() {
        let Place::At(at) = place else { continue };
        let at = at as usize;
        if std::mem::replace(&mut seen[at], true) {
            continue;
        }
        let entry = tape.entries[at];
        match (entry.ray, entry.triangle) {
            (true, true) => needed.each.push(entry.noted),
            (false, true) => needed.once.push(entry.noted),
            _ => {}
        }
        wanted.extend(entry.operands.into_iter().flatten());
    }
    needed
}
