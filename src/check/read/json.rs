//! One line of JSON lines: a flat object, its values as they are written.
//!
//! Values are kept as text, so that numbers of both formats are read, and rounded, by one rule.

use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;
use std::fmt;

/// Names and values in the order of the line; a name may stand there twice.
pub struct Object<'a>(pub Vec<(String, &'a RawValue)>);

impl<'de> Deserialize<'de> for Object<'de> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Members;
        impl<'de> Visitor<'de> for Members {
            type Value = Object<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("one object a line")
            }
            fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<Object<'de>, M::Error> {
                let mut members = Vec::with_capacity(18);
                while let Some(member) = map.next_entry()? {
                    members.push(member);
                }
                Ok(Object(members))
            }
        }
        deserializer.deserialize_map(Members)
    }
}

/// The text of a value: what a string holds, nothing for `null`, anything else as it stands.
pub fn text(value: &RawValue) -> String {
    match value.get() {
        "null" => String::new(),
        quoted if quoted.starts_with('"') => {
            serde_json::from_str(quoted).unwrap_or_else(|_| quoted.to_owned())
        }
        other => other.to_owned(),
    }
}

/// What the parser says, without the place that it appends, and the column.
pub fn complaint(error: &serde_json::Error) -> (String, usize) {
    let said = error.to_string();
    let message = said.split(" at line ").next().unwrap_or_default().to_owned();
    (message, error.column())
}
