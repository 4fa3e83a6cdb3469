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

/// An operation with its operands, and what it depends on.
#[derive(Clone, Copy, Debug)]
struct Entry {
    noted: Noted,
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

/// The result of an operation, noted unless it is known already.
#[inline(never)]
pub fn note(noted: Noted, operands: [Option<Place>; 3]) -> Place {
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
        tape.entries.push(Entry { noted, operands, ray, triangle });
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
