//! PLY, by the crate `ply-rs-bw`, element by element, so that none is held longer than it is needed
//! and the place of an error is known.

use super::Mesh;
use super::build::Builder;
use super::load::shortened;
use crate::check::read::ReadError;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType,
    ScalarType,
};

/// The header is within the first so many bytes.
const LONGEST_HEADER: usize = 1 << 16;
/// Longest line of the text form, bytes.
const LONGEST_LINE: usize = 1 << 20;
/// What its lines may be.
const HEADER: &str = "allowed: 'ply', then 'format', 'comment', 'obj_info', 'element' and \
                      'property', then 'end_header'";
const END: &[u8] = b"end_header";
/// Both names are in use.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// One vertex, face or anything else.
struct Item {
    place: [f64; 3],
    corners: Vec<i64>,
}

impl PropertyAccess for Item {
    fn new() -> Self {
        Item { place: [f64::NAN; 3], corners: Vec::new() }
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if let Some(axis) = ["x", "y", "z"].iter().position(|axis| *axis == name) {
            let Some(number) = number(&property) else {
                return PropertyAccessResult::UnsupportedType;
            };
            self.place[axis] = number;
        } else if CORNERS.contains(&name) {
            self.corners = match property {
                Property::ListChar(list) => list.into_iter().map(i64::from).collect(),
                Property::ListUChar(list) => list.into_iter().map(i64::from).collect(),
                Property::ListShort(list) => list.into_iter().map(i64::from).collect(),
                Property::ListUShort(list) => list.into_iter().map(i64::from).collect(),
                Property::ListInt(list) => list.into_iter().map(i64::from).collect(),
                Property::ListUInt(list) => list.into_iter().map(i64::from).collect(),
                _ => return PropertyAccessResult::UnsupportedType,
            };
        } else {
            return PropertyAccessResult::Ignored;
        }
        PropertyAccessResult::Set
    }
}

/// The elements `vertex` and `face` of a file.
pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Mesh, ReadError> {
    let whole = |message: String| ReadError::Whole { file: file.to_owned(), message };
    let start = &bytes[..bytes.len().min(LONGEST_HEADER)];
    if !start.windows(END.len()).any(|part| part == END) {
        let message = "no 'end_header'; allowed: a PLY header of less than";
        return Err(whole(format!("{message} {LONGEST_HEADER} bytes")));
    }
    let parser = Parser::<Item>::new();
    let mut reader = Reader::new(bytes);
    let header = parser.read_header(&mut reader).map_err(|error| {
        let line = error.line().unwrap_or(1) as u64;
        let (file, place) = (file.to_owned(), String::new());
        let message = format!("{}; {HEADER}", words(&error));
        ReadError::Line { file, line, place, message }
    })?;
    // The reader counts the line behind the header as begun.
    let line = reader.line().saturating_sub(1) as u64;
    let rest = reader.into_inner();
    let mut body = Body { file, parser, header: &header, rest, line, builder: Builder::default() };
    for element in header.elements.values() {
        body.checked(element).map_err(whole)?;
        body.element(element)?;
    }
    if !body.rest.trim_ascii().is_empty() {
        let count = body.rest.len();
        let message = format!("{count} bytes behind the last element; allowed: as many elements");
        return Err(whole(format!("{message} as the header announces")));
    }
    body.builder.finish(file)
}

/// What follows the header.
struct Body<'a> {
    file: &'a str,
    parser: Parser<Item>,
    header: &'a Header,
    rest: &'a [u8],
    /// Last line that was read, of the text form.
    line: u64,
    builder: Builder,
}

impl Body<'_> {
    fn is_text(&self) -> bool {
        self.header.encoding == Encoding::Ascii
    }

    /// Refuses what the header announces of an element and the rest of the file cannot hold.
    fn checked(&self, element: &ElementDef) -> Result<(), String> {
        let ElementDef { name, count, properties, .. } = element;
        let least: usize = properties.values().map(|p| self.least_bytes(&p.data_type)).sum();
        // The last line of a text needs no end.
        let room = self.rest.len() + usize::from(self.is_text());
        if *count > 0 && least == 0 {
            return Err(format!("element '{name}' has no property; allowed: at least one"));
        }
        if count.checked_mul(least).is_none_or(|needed| needed > room) {
            let most = room / least.max(1);
            return Err(format!(
                "element '{name}': {count} announced, but the file is cut short; allowed: at most \
                 {most} in the bytes that are left"
            ));
        }
        let scalar = |wanted: &str| {
            properties.get(wanted).is_some_and(|p| matches!(p.data_type, PropertyType::Scalar(_)))
        };
        if name == "vertex" && !["x", "y", "z"].iter().all(|axis| scalar(axis)) {
            return Err("element 'vertex'; allowed: with the numbers x, y and z".into());
        }
        let is_list = |wanted: &&str| {
            let data_type = properties.get(*wanted).map(|property| &property.data_type);
            matches!(data_type, Some(PropertyType::List(_, _)))
        };
        if name == "face" && !CORNERS.iter().any(is_list) {
            return Err(format!("element 'face'; allowed: with a list '{}'", CORNERS[0]));
        }
        Ok(())
    }

    /// A number of a text is at least a digit and what parts it from the next.
    fn least_bytes(&self, data_type: &PropertyType) -> usize {
        let (PropertyType::Scalar(kind) | PropertyType::List(kind, _)) = data_type;
        if self.is_text() { 2 } else { width(kind) }
    }

    /// Reads all items of an element.
    fn element(&mut self, element: &ElementDef) -> Result<(), ReadError> {
        for index in 0..element.count {
            let item = if self.is_text() { self.line(element) } else { self.bytes(element) };
            let added = item.and_then(|item| match element.name.as_str() {
                "vertex" => self.builder.vertex(item.place),
                "face" => self.builder.face(&item.corners),
                _ => Ok(()),
            });
            added.map_err(|message| self.bad(element, index, message))?;
        }
        Ok(())
    }

    /// The next item of the text form: a line.
    fn line(&mut self, element: &ElementDef) -> Result<Item, String> {
        if self.rest.is_empty() {
            return Err(format!("the file ends; allowed: {} of them", element.count));
        }
        let end = self.rest.iter().position(|byte| *byte == b'\n');
        let (line, rest) = self.rest.split_at(end.map_or(self.rest.len(), |end| end + 1));
        self.rest = rest;
        self.line += 1;
        if line.len() > LONGEST_LINE {
            return Err(format!("allowed: lines of at most {LONGEST_LINE} bytes"));
        }
        let text = str::from_utf8(line).map_err(|_| "not UTF-8; allowed: UTF-8".to_owned())?;
        let item = self.parser.read_ascii_element(text.trim_ascii_end(), element);
        item.map_err(|error| {
            let values = element.properties.keys().cloned().collect::<Vec<_>>().join(" ");
            let error = words(&error);
            format!("{error}; allowed: '{values}', numbers such as 1, 0.5 or -2e3")
        })
    }

    /// The next item of the binary form.
    fn bytes(&mut self, element: &ElementDef) -> Result<Item, String> {
        let item = match self.header.encoding {
            Encoding::BinaryBigEndian => {
                self.parser.read_big_endian_element(&mut self.rest, element)
            }
            _ => self.parser.read_little_endian_element(&mut self.rest, element),
        };
        let count = element.count;
        item.map_err(|error| format!("{}; allowed: {count} whole ones", words(&error)))
    }

    fn bad(&self, element: &ElementDef, index: usize, message: String) -> ReadError {
        let file = self.file.to_owned();
        let name = &element.name;
        if self.is_text() {
            let place = format!(", {name} {index}");
            return ReadError::Line { file, line: self.line, place, message };
        }
        ReadError::Whole { file, message: format!("{name} {index}: {message}") }
    }
}

/// What the loader says, without the line, which is said elsewhere.
fn words(error: &ParseError) -> String {
    let text = error.to_string();
    let line = error.line().map(|line| format!("Line {line}: ")).unwrap_or_default();
    shortened(text.strip_prefix(&line).unwrap_or(&text))
}

/// A scalar, exactly.
fn number(property: &Property) -> Option<f64> {
    match *property {
        Property::Char(x) => Some(x.into()),
        Property::UChar(x) => Some(x.into()),
        Property::Short(x) => Some(x.into()),
        Property::UShort(x) => Some(x.into()),
        Property::Int(x) => Some(x.into()),
        Property::UInt(x) => Some(x.into()),
        Property::Float(x) => Some(x.into()),
        Property::Double(x) => Some(x),
        _ => None,
    }
}

/// Bytes of a number in the binary form.
fn width(kind: &ScalarType) -> usize {
    match kind {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}
