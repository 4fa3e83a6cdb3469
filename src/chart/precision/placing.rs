//! Labels near their points, where nothing else stands.

use crate::chart::canvas::Place;
use crate::chart::text;

/// A rectangle, y downwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rectangle {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Rectangle {
    /// Around a place.
    pub fn around(at: Place, half_width: f64, half_height: f64) -> Self {
        Rectangle {
            left: at.0 - half_width,
            right: at.0 + half_width,
            top: at.1 - half_height,
            bottom: at.1 + half_height,
        }
    }

    fn overlaps(&self, other: &Rectangle) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    fn is_inside(&self, other: &Rectangle) -> bool {
        self.left >= other.left
            && self.right <= other.right
            && self.top >= other.top
            && self.bottom <= other.bottom
    }
}

/// What is taken already.
pub(super) struct Taken {
    room: Rectangle,
    taken: Vec<Rectangle>,
}

/// From a point to the nearest edge of its label.
const NEAR: f64 = 7.0;
/// Beyond this the label needs a line to its point.
pub(super) const FAR: f64 = 12.0;
/// Labels are looked for in rings, so far apart, so many.
const RING: f64 = 9.0;
const RINGS: usize = 16;
/// Directions of a ring, clockwise from the right; those on the level of the point first.
const DIRECTIONS: [(f64, f64); 12] = [
    (1.0, 0.0),
    (-1.0, 0.0),
    (0.0, -1.0),
    (0.0, 1.0),
    (0.87, -0.5),
    (0.87, 0.5),
    (-0.87, -0.5),
    (-0.87, 0.5),
    (0.5, -0.87),
    (0.5, 0.87),
    (-0.5, -0.87),
    (-0.5, 0.87),
];

impl Taken {
    /// Nothing yet, and labels must stay in this room.
    pub fn new(room: Rectangle) -> Self {
        Taken { room, taken: Vec::new() }
    }

    /// Keeps labels off a rectangle.
    pub fn keep_off(&mut self, rectangle: Rectangle) {
        self.taken.push(rectangle);
    }

    /// Keeps labels off a level or upright line.
    pub fn keep_off_line(&mut self, from: Place, to: Place) {
        self.keep_off(Rectangle {
            left: from.0.min(to.0) - 1.5,
            right: from.0.max(to.0) + 1.5,
            top: from.1.min(to.1) - 1.5,
            bottom: from.1.max(to.1) + 1.5,
        });
    }

    /// Middle of the nearest free place for a label, and its distance from the point; that place is
    /// taken then. `None` if there is none near enough.
    pub fn place(
        &mut self,
        point: Place,
        words: &str,
        size: f64,
        bold: bool,
    ) -> Option<(Place, f64)> {
        let (half_width, half_height) =
            (text::width(words, size, bold) / 2.0 + 1.0, size * 0.5 + 1.5);
        for ring in 0..RINGS {
            let distance = NEAR + RING * ring as f64;
            for (right, down) in DIRECTIONS {
                // The label's edge, not its middle, is at that distance.
                let side = if right == 0.0 { 0.0 } else { right.signum() };
                let across = distance * right + half_width * side;
                let along = distance * down + half_height * down;
                let middle = (point.0 + across, point.1 + along);
                let rectangle = Rectangle::around(middle, half_width, half_height);
                let free = rectangle.is_inside(&self.room)
                    && !self.taken.iter().any(|other| other.overlaps(&rectangle));
                if free {
                    self.taken.push(rectangle);
                    return Some((middle, distance));
                }
            }
        }
        None
    }
}
