//! The same answers on a terminal: at most 100 columns, no colours.

use super::answers::Answer;
use super::ledger::Ledger;
use super::page::Page;
use super::trust::Check;
use comfy_table::presets::NOTHING;
use comfy_table::{ContentArrangement, Table};

/// Columns of the widest line.
const WIDTH: usize = 100;

/// Which kernel to take, how many claims hold and which do not, how trustworthy the run was.
pub(super) fn text(page: &Page) -> String {
    let mut parts = vec![wrapped(&page.cite, 0)];
    if !page.nothing.is_empty() {
        parts.push(format!("{}\n", page.nothing));
        return parts.join("\n");
    }
    for answers in &page.answers {
        let machine = answers.machine.as_str();
        let on = if machine.is_empty() { "this machine" } else { machine };
        let list: String = answers.list.iter().map(answer).collect();
        parts.push(format!("Which kernel to take on {on}\n{list}"));
    }
    parts.push(wrapped(&page.ledger.sentence, 0) + &claims(&page.ledger));
    parts.push(wrapped(&page.trust_sentence, 0) + &checks(&page.trust));
    parts.join("\n")
}

/// A need, the variant that answers it on a line of its own, to be copied, and its figures.
fn answer(answer: &Answer) -> String {
    let mut figures = Vec::new();
    if !answer.note.is_empty() {
        figures.push(answer.note.clone());
    }
    if !answer.time.is_empty() {
        figures.push(format!("{} ns per test", answer.time));
    }
    if !answer.error.is_empty() {
        figures.push(format!("error {}", answer.error));
    }
    if !answer.runner_up.is_empty() {
        figures.push(format!("next: {}", answer.runner_up));
    }
    if !answer.cell.is_empty() {
        figures.push(format!("{}: {}", answer.experiment, answer.cell));
    }
    let lines = figures.iter().map(|line| wrapped(line, 6)).collect::<String>();
    format!("{}    {}\n{lines}", wrapped(&answer.need, 2), answer.variant)
}

fn claims(ledger: &Ledger) -> String {
    let rows = ledger.papers.iter().flat_map(|paper| &paper.claims);
    let rows = rows.map(|claim| [&claim.id, &claim.headline, &claim.statement].map(String::clone));
    table(["claim", "verdict", "statement"], rows)
}

fn checks(checks: &[Check]) -> String {
    let checks = checks.iter().map(|check| {
        let mark = if check.alarm { "! " } else { "" };
        [format!("{mark}{}", check.what), check.figure.clone(), check.meaning.clone()]
    });
    table(["check", "", "meaning"], checks)
}

/// Columns as wide as there is room for; empty without rows.
fn table(head: [&str; 3], rows: impl Iterator<Item = [String; 3]>) -> String {
    let mut table = Table::new();
    table.load_style(NOTHING);
    table.set_content_arrangement(ContentArrangement::Dynamic);
    table.set_width(WIDTH as u16);
    table.set_header(head);
    rows.for_each(|row| {
        table.add_row(row);
    });
    if table.is_empty() { String::new() } else { table.trim_fmt() + "\n" }
}

/// Lines of whole words behind an indent, each ended; a word that is longer by itself stays whole,
/// since it is an id to be copied.
fn wrapped(text: &str, indent: usize) -> String {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let fits = |line: &String| line.chars().count() + 1 + word.chars().count() <= WIDTH;
        match lines.last_mut() {
            Some(line) if fits(line) => *line += &format!(" {word}"),
            _ => lines.push(format!("{}{word}", " ".repeat(indent))),
        }
    }
    lines.iter().map(|line| format!("{line}\n")).collect()
}
