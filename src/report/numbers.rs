//! A figure's numbers: as a table to read, best first, and as CSV, unrounded.

use super::ReportError;
use super::sense::sense;
use super::words::between;
use crate::chart::{
    ChartError, Count, Dot, Field, Figure, Numbers, Point, Published, Standing, numbers,
    short_figure, title,
};
use crate::table::Row;

/// Cells under a header.
#[derive(Default)]
pub(super) struct Table {
    pub head: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

/// A figure's numbers as CSV, in the order of its rows and unrounded. Columns of `lines`, `bars` and
/// `shares`: `panel,series,x,column,value,low,high,kind`, kind being `measured`, `published` or
/// `bound`; of `counts`: `series,operation,counted,published`; of `heat`: `series,x,value,shown`; of
/// `precision`: `panel,series,precision,error,error_low,error_high,value,low,high,standing`. Only the
/// header where there is nothing to draw.
///
/// # Errors
/// As [`draw`](crate::chart::draw).
pub fn figure_csv(figure: &Figure, rows: &[Row]) -> Result<Vec<u8>, ReportError> {
    let table = match numbers(figure, rows, &Published::embedded()?) {
        Ok(numbers) => unrounded(figure, &numbers),
        Err(ChartError::Nothing(_)) => {
            Table { head: POINTS.map(str::to_owned).into(), ..Table::default() }
        }
        Err(error) => return Err(error.into()),
    };
    let mut bytes = Vec::new();
    let mut writer = csv::Writer::from_writer(&mut bytes);
    writer.write_record(&table.head)?;
    table.rows.iter().try_for_each(|row| writer.write_record(row))?;
    writer.flush().map_err(csv::Error::from)?;
    drop(writer);
    Ok(bytes)
}

const POINTS: [&str; 8] = ["panel", "series", "x", "column", "value", "low", "high", "kind"];

fn unrounded(figure: &Figure, numbers: &Numbers) -> Table {
    let head = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
    let mut rows: Vec<Vec<String>> = Vec::new();
    let mut points = |points: &[Point], column: &str, kind: &str| {
        rows.extend(points.iter().map(|point| raw(point, column, kind)));
    };
    match numbers {
        Numbers::Points { ours, published, bounds } => {
            points(ours, &figure.y, "measured");
            points(published, &figure.y, "published");
            points(bounds, figure.bound.as_deref().unwrap_or_default(), "bound");
        }
        Numbers::Shares { ours, published, ours_below, published_below } => {
            let below = figure.y_below.as_deref().unwrap_or_default();
            points(ours, &figure.y, "measured");
            points(published, &figure.y, "published");
            points(ours_below, below, "measured");
            points(published_below, below, "published");
        }
        Numbers::Counts(counts) => {
            return Table {
                head: head(&["series", "operation", "counted", "published"]),
                rows: counts.iter().map(raw_count).collect(),
            };
        }
        Numbers::Fields(fields) => {
            return Table {
                head: head(&["series", "x", "value", "shown"]),
                rows: fields.iter().map(raw_field).collect(),
            };
        }
        Numbers::Dots(dots) => {
            return Table {
                head: head(&[
                    "panel",
                    "series",
                    "precision",
                    "error",
                    "error_low",
                    "error_high",
                    "value",
                    "low",
                    "high",
                    "standing",
                ]),
                rows: dots.iter().map(raw_dot).collect(),
            };
        }
    }
    Table { head: head(&POINTS), rows }
}

fn raw(point: &Point, column: &str, kind: &str) -> Vec<String> {
    let end = |end: Option<f64>| end.map_or(String::new(), |end| end.to_string());
    let names = [&point.panel, &point.series, &point.x].map(String::clone);
    let mut row: Vec<String> = names.into();
    row.extend([column.to_owned(), point.y.to_string()]);
    row.extend([end(point.interval.map(|ends| ends.0)), end(point.interval.map(|ends| ends.1))]);
    row.push(kind.to_owned());
    row
}

fn raw_count(count: &Count) -> Vec<String> {
    let ours = count.ours.map_or(String::new(), |ours| ours.to_string());
    let theirs = count.published.map_or(String::new(), |theirs| theirs.to_string());
    vec![count.series.clone(), count.operation.to_owned(), ours, theirs]
}

fn raw_field(field: &Field) -> Vec<String> {
    let shown = field.shown.map_or(String::new(), |shown| shown.to_string());
    vec![field.series.clone(), field.x.clone(), field.share.to_string(), shown]
}

fn raw_dot(dot: &Dot) -> Vec<String> {
    let numbers = [dot.error, dot.errors.0, dot.errors.1, dot.time, dot.times.0, dot.times.1];
    let mut row = vec![dot.panel.clone(), dot.name.clone(), dot.precision.clone()];
    row.extend(numbers.map(|number| number.to_string()));
    row.push(standing(dot).to_owned());
    row
}

fn standing(dot: &Dot) -> &'static str {
    match dot.standing {
        Standing::Front => "front",
        Standing::Dominated => "dominated",
        Standing::Apart(_) => "set apart",
    }
}

/// The table that is read, the best first.
pub(super) fn table(figure: &Figure, numbers: &Numbers) -> Table {
    match numbers {
        Numbers::Points { ours, published, bounds } => {
            let title = figure.y_title.clone().unwrap_or_else(|| title(&figure.y));
            let mut table = points(figure, &title, ours, published);
            table.rows.extend(bounds.iter().map(|bound| {
                let mut cells = names(figure, bound);
                cells.extend([
                    format!("< {}", short_figure(bound.y)),
                    String::new(),
                    String::new(),
                ]);
                cells
            }));
            without_empty_columns(table)
        }
        Numbers::Shares { ours, published, ours_below, published_below } => {
            let mut table = points(figure, &title(&figure.y), ours, published);
            let below = figure.y_below.as_deref().unwrap_or_default();
            table.rows.extend(
                points(figure, "", ours_below, published_below).rows.into_iter().map(|mut row| {
                    row[1] = format!("{}: {}", title(below), row[1]);
                    row
                }),
            );
            without_empty_columns(table)
        }
        Numbers::Counts(counts) => Table {
            head: ["series", "operation", "counted", "published"].map(str::to_owned).into(),
            rows: counts.iter().map(raw_count).collect(),
        },
        Numbers::Fields(fields) => of_fields(figure, fields),
        Numbers::Dots(dots) => without_empty_columns(of_dots(figure, dots)),
    }
}

fn names(figure: &Figure, point: &Point) -> Vec<String> {
    [&point.panel, &point.x, &point.series].map(|name| figure.label(name)).into()
}

fn points(figure: &Figure, title: &str, ours: &[Point], published: &[Point]) -> Table {
    let sense = sense(&figure.y);
    let mut panels: Vec<&String> = Vec::new();
    for point in ours {
        if !panels.contains(&&point.panel) {
            panels.push(&point.panel);
        }
    }
    let panel = |point: &Point| panels.iter().position(|panel| **panel == point.panel);
    let mut order: Vec<&Point> = ours.iter().collect();
    order.sort_by(|a, b| panel(a).cmp(&panel(b)).then(sense.order(a.y, b.y)));
    let same = |one: &Point, other: &Point| {
        (&one.panel, &one.series, &one.x) == (&other.panel, &other.series, &other.x)
    };
    let row = |point: &&Point| {
        let theirs = published.iter().find(|theirs| same(theirs, point));
        let mut cells = names(figure, point);
        cells.push(short_figure(point.y));
        cells.push(point.interval.map_or(String::new(), |(low, high)| between(low, high)));
        cells.push(theirs.map_or(String::new(), |theirs| short_figure(theirs.y)));
        cells
    };
    let mut rows: Vec<Vec<String>> = order.iter().map(row).collect();
    let alone = published.iter().filter(|theirs| !ours.iter().any(|point| same(theirs, point)));
    rows.extend(alone.map(|theirs| {
        let mut cells = names(figure, theirs);
        cells.extend([String::new(), String::new(), short_figure(theirs.y)]);
        cells
    }));
    let plain = |words: &str| words.replace('_', " ");
    let joined = |names: &[String]| plain(&names.join(", "));
    let x = figure.x.list();
    let head = vec![
        figure.panels.as_deref().map_or("figure".to_owned(), plain),
        if x.is_empty() { "x".to_owned() } else { joined(x) },
        joined(figure.series.list()),
        title.to_owned(),
        "interval".to_owned(),
        "published".to_owned(),
    ];
    Table { head, rows }
}

/// Columns in which nothing stands, and a series that the category repeats, say nothing.
fn without_empty_columns(table: Table) -> Table {
    let says = |column: usize| {
        table.rows.iter().any(|row| !row[column].is_empty())
            && !(column == 2 && table.head[1] == table.head[2])
    };
    let kept: Vec<usize> = (0..table.head.len()).filter(|column| says(*column)).collect();
    let pick = |row: &Vec<String>| kept.iter().map(|column| row[*column].clone()).collect();
    Table { head: pick(&table.head), rows: table.rows.iter().map(pick).collect() }
}

/// A line a series, a column an x, those that fail in the fewest columns first.
fn of_fields(figure: &Figure, fields: &[Field]) -> Table {
    let mut columns: Vec<&String> = Vec::new();
    let mut series: Vec<(usize, &String)> = Vec::new();
    for field in fields {
        if !columns.contains(&&field.x) {
            columns.push(&field.x);
        }
        let fails = usize::from(field.share < 1.0);
        match series.iter_mut().find(|(_, name)| **name == field.series) {
            Some((failed, _)) => *failed += fails,
            None => series.push((fails, &field.series)),
        }
    }
    series.sort();
    let line = |(_, name): &(usize, &String)| {
        let cell = |column: &&String| {
            let here = |field: &&Field| field.series == **name && field.x == **column;
            let shown = fields.iter().find(here);
            shown.map_or(String::new(), |field| field.shown.map_or("–".to_owned(), short_figure))
        };
        let mut cells = vec![figure.label(name)];
        cells.extend(columns.iter().map(cell));
        cells
    };
    let mut head = vec![figure.series.list().join(", ")];
    head.extend(columns.iter().map(|column| figure.label(column)));
    Table { head, rows: series.iter().map(line).collect() }
}

/// By panel and precision, the fastest first.
fn of_dots(figure: &Figure, dots: &[Dot]) -> Table {
    let mut panels: Vec<&String> = Vec::new();
    for dot in dots {
        if !panels.contains(&&dot.panel) {
            panels.push(&dot.panel);
        }
    }
    let place = |dot: &Dot| panels.iter().position(|panel| **panel == dot.panel);
    let mut order: Vec<&Dot> = dots.iter().collect();
    order.sort_by(|a, b| {
        let precisions = a.precision.cmp(&b.precision);
        place(a).cmp(&place(b)).then(precisions).then(a.time.total_cmp(&b.time))
    });
    let row = |dot: &&Dot| {
        let names = [&dot.panel, &dot.precision, &dot.name].map(|name| figure.label(name));
        let mut cells: Vec<String> = names.into();
        cells.extend([short_figure(dot.time), between(dot.times.0, dot.times.1)]);
        cells.extend([short_figure(dot.error), standing(dot).to_owned()]);
        cells
    };
    let panel = figure.panels.as_deref().unwrap_or("figure").replace('_', " ");
    let time = figure.y_title.clone().unwrap_or_else(|| title(&figure.y));
    let mut head = vec![panel, "precision".to_owned(), "form".to_owned()];
    head.extend([time, "interval".to_owned(), "error".to_owned(), "standing".to_owned()]);
    Table { head, rows: order.iter().map(row).collect() }
}
