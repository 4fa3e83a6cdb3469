//! Reads a picture back, by an XML parser.

use roxmltree::{Document, Node};

/// Attributes that are places or lengths.
const NUMBERS: [&str; 18] = [
    "x",
    "y",
    "x1",
    "y1",
    "x2",
    "y2",
    "cx",
    "cy",
    "r",
    "rx",
    "ry",
    "width",
    "height",
    "points",
    "d",
    "font-size",
    "stroke-width",
    "opacity",
];
/// Those along the picture, and down.
const ALONG: [&str; 4] = ["x", "x1", "x2", "cx"];
const DOWN: [&str; 4] = ["y", "y1", "y2", "cy"];

/// What every picture is, whatever the rows: XML, and every number in it finite.
pub fn finite(svg: &str) -> Document<'_> {
    let document = Document::parse(svg).unwrap_or_else(|error| panic!("{error} in {svg}"));
    assert_eq!(document.root_element().tag_name().name(), "svg");
    for node in document.descendants() {
        for name in NUMBERS {
            let numbers = numbers(&node, name);
            assert!(numbers.iter().all(|number| number.is_finite()), "{name} of {node:?}");
        }
    }
    document
}

/// What it is besides where the values are such as can be measured: everything lies in what is shown.
#[allow(dead_code, reason = "hostile values lie anywhere")]
pub fn within(svg: &str) {
    let document = finite(svg);
    let view = numbers(&document.root_element(), "viewBox");
    let [_, _, width, height] = view[..] else { panic!("a view box of {view:?}") };
    for node in document.descendants() {
        let inside = |numbers: Vec<f64>, most: f64, name: &str| {
            let fits = numbers.iter().all(|place| (-0.5..=most + 0.5).contains(place));
            assert!(fits, "{name} of {node:?}: {numbers:?} beyond {most}");
        };
        ALONG.iter().for_each(|name| inside(numbers(&node, name), width, name));
        DOWN.iter().for_each(|name| inside(numbers(&node, name), height, name));
        let points = numbers(&node, "points");
        inside(points.iter().copied().step_by(2).collect(), width, "points");
        inside(points.iter().copied().skip(1).step_by(2).collect(), height, "points");
    }
}

/// The numbers of an attribute, those of a path without its letters; NaN for what is none.
fn numbers(node: &Node<'_, '_>, name: &str) -> Vec<f64> {
    let is_between = |c: char| c.is_whitespace() || ",MLHVZmlhvz".contains(c);
    let words = node.attribute(name).unwrap_or_default().split(is_between);
    words.filter(|word| !word.is_empty()).map(|word| word.parse().unwrap_or(f64::NAN)).collect()
}
