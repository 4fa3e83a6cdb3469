//! Named values, line by line, from CSV with a header or from JSON lines.

use super::error::ReadError;
use super::json::{Object, complaint, text};
use super::lines::Lines;
use std::io::BufRead;

/// How alike a name must be to be offered for an unknown one (Jaro-Winkler, 1 is equal). Low, since
/// the names have two letters.
const ALIKE: f64 = 0.5;

/// The names that may stand in a record.
#[derive(Clone, Copy)]
pub struct Schema {
    /// What must be there, then what may.
    pub names: &'static [&'static str],
    /// How many must.
    pub required: usize,
}

/// The value of one name in the present record.
#[derive(Clone, Default)]
struct Field {
    text: String,
    /// Column of CSV, from 1; 0 in JSON lines and where the name is absent.
    column: usize,
}

enum Format {
    /// For each column, the index of its name.
    Csv(Vec<usize>),
    JsonLines,
}

/// Reads record after record into one place.
pub struct Records<R> {
    lines: Lines<R>,
    schema: Schema,
    /// Known from the first line on.
    format: Option<Format>,
    fields: Vec<Field>,
}

impl<R: BufRead> Records<R> {
    /// `file` is what messages call the input.
    pub fn new(input: R, file: &str, schema: Schema) -> Self {
        let fields = vec![Field::default(); schema.names.len()];
        Records { lines: Lines::new(input, file), schema, format: None, fields }
    }

    /// Goes to the next record; `false` behind the last.
    pub fn advance(&mut self) -> Result<bool, ReadError> {
        if self.format.is_none() {
            let Some(first) = self.lines.advance()?.map(str::to_owned) else { return Ok(false) };
            match first.trim_start().chars().next() {
                Some('{') => {
                    self.format = Some(Format::JsonLines);
                    return self.json(&first).map(|()| true);
                }
                Some('[') => {
                    let message = "a JSON array; allowed: JSON lines, one object a line, or CSV";
                    return Err(self.lines.bad("", message.into()));
                }
                _ => self.format = Some(Format::Csv(self.header(&first)?)),
            }
        }
        let Some(line) = self.lines.advance()? else { return Ok(false) };
        if let Some(Format::Csv(columns)) = &self.format {
            let fields = &mut self.fields;
            let cells = each_cell(line, |column, text| {
                if let Some(name) = columns.get(column) {
                    fields[*name].text.clear();
                    fields[*name].text.push_str(text);
                }
            });
            let wanted = columns.len();
            let fits = cells == wanted;
            return if fits { Ok(true) } else { Err(self.ragged(cells, wanted)) };
        }
        let line = line.to_owned();
        self.json(&line).map(|()| true)
    }

    /// The text of a name in the present record; `None` if there is none, or it is empty.
    pub fn text(&self, name: usize) -> Option<&str> {
        Some(self.fields[name].text.as_str()).filter(|text| !text.is_empty())
    }

    /// What is wrong with the value of a name.
    pub fn bad(&self, name: usize, allowed: &str) -> ReadError {
        let (field, name) = (&self.fields[name], self.schema.names[name]);
        let place = match field.column {
            0 => format!(", field '{name}'"),
            column => format!(", column {column} ({name})"),
        };
        let message = format!("'{}' is not allowed; allowed: {allowed}", field.text);
        self.lines.bad(&place, message)
    }

    /// An error at the present line.
    pub fn bad_line(&self, message: String) -> ReadError {
        self.lines.bad("", message)
    }

    /// An error of the file as a whole.
    pub fn whole(&self, message: String) -> ReadError {
        self.lines.whole(message)
    }

    /// The index of each column's name.
    fn header(&mut self, line: &str) -> Result<Vec<usize>, ReadError> {
        let mut names = Vec::new();
        each_cell(line, |_, name| names.push(name.to_owned()));
        let mut columns = Vec::new();
        for (place, name) in names.iter().enumerate() {
            let index = self.index(name, &format!(", column {}", place + 1))?;
            if columns.contains(&index) {
                return Err(self.twice(name, &format!(", column {}", place + 1)));
            }
            self.fields[index].column = place + 1;
            columns.push(index);
        }
        self.complete(&columns, "columns", "; a header with the names must come first")?;
        Ok(columns)
    }

    fn json(&mut self, line: &str) -> Result<(), ReadError> {
        let Object(members) = serde_json::from_str(line).map_err(|error| {
            let (message, column) = complaint(&error);
            let message = format!("{message}; allowed: JSON lines, one object a line");
            self.lines.bad(&format!(", column {column}"), message)
        })?;
        self.fields.iter_mut().for_each(|field| field.text.clear());
        let mut seen = Vec::with_capacity(members.len());
        for (name, value) in members {
            let index = self.index(&name, "")?;
            if seen.contains(&index) {
                return Err(self.twice(&name, ""));
            }
            self.fields[index].text = text(value);
            seen.push(index);
        }
        self.complete(&seen, "fields", "")
    }

    fn index(&self, name: &str, place: &str) -> Result<usize, ReadError> {
        let known = self.schema.names;
        if let Some(index) = known.iter().position(|other| *other == name) {
            return Ok(index);
        }
        let wanted = name.to_lowercase();
        let alike = |other: &str| strsim::jaro_winkler(&wanted, other);
        let best = known.iter().copied().max_by(|a, b| alike(a).total_cmp(&alike(b)));
        let hint = best.filter(|best| alike(best) >= ALIKE);
        let hint = hint.map(|best| format!(". Did you mean '{best}'?")).unwrap_or_default();
        let allowed = known.join(", ");
        Err(self.lines.bad(place, format!("unknown name '{name}'; allowed: {allowed}{hint}")))
    }

    fn twice(&self, name: &str, place: &str) -> ReadError {
        self.lines.bad(place, format!("'{name}' stands there twice; allowed: once"))
    }

    fn complete(&self, seen: &[usize], what: &str, hint: &str) -> Result<(), ReadError> {
        let required = self.schema.names.iter().take(self.schema.required).enumerate();
        let missing = required.filter(|(index, _)| !seen.contains(index));
        let missing: Vec<&str> = missing.map(|(_, name)| *name).collect();
        if missing.is_empty() {
            return Ok(());
        }
        Err(self.lines.bad("", format!("missing {what}: {}{hint}", missing.join(", "))))
    }

    fn ragged(&self, cells: usize, wanted: usize) -> ReadError {
        let place = format!(", column {}", cells.min(wanted) + 1);
        let message = format!("{cells} values; allowed: {wanted}, as the header has");
        self.lines.bad(&place, message)
    }
}

/// Calls `each` with the cells of a line of CSV, blanks around them cut off; how many there are.
fn each_cell(line: &str, mut each: impl FnMut(usize, &str)) -> usize {
    let mut count = 0;
    let mut next = |text: &str| {
        each(count, text);
        count += 1;
    };
    // Only ids are ever quoted.
    if line.contains('"') {
        let mut reader = csv::ReaderBuilder::new();
        let reader = reader.has_headers(false).trim(csv::Trim::All);
        let mut record = csv::StringRecord::new();
        // Text in memory can neither fail to be read nor be of another encoding.
        if matches!(reader.from_reader(line.as_bytes()).read_record(&mut record), Ok(true)) {
            record.iter().for_each(&mut next);
        }
    } else {
        line.split(',').for_each(|cell| next(cell.trim()));
    }
    count
}
