//! A figure's numbers as a table to read.

use super::dump::raw_count;
use super::{Table, standing};
use crate::chart::{Dot, Field, Figure, Numbers, Point, short_figure, title};
use crate::report::sense::sense;
use crate::report::words::between;

/// The table that is read, the best first.
pub(in crate::report) fn table(figure: &Figure, numbers: &Numbers) -> Table {
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
    Table { head: head(figure, title), rows }
}

fn same(one: &Point, other: &Point) -> bool {
    (&one.panel, &one.series, &one.x) == (&other.panel, &other.series, &other.x)
}

fn head(figure: &Figure, title: &str) -> Vec<String> {
    let plain = |words: &str| words.replace('_', " ");
    let joined = |names: &[String]| plain(&names.join(", "));
    let x = figure.x.list();
    vec![
        figure.panels.as_deref().map_or("figure".to_owned(), plain),
        if x.is_empty() { "x".to_owned() } else { joined(x) },
        joined(figure.series.list()),
        title.to_owned(),
        "interval".to_owned(),
        "published".to_owned(),
    ]
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
