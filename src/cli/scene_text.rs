//! A plan that one reads.

use std::fmt::Write;

use crate::check::Precision;
use crate::plan::Found;
use crate::registry::asked;

/// Lines are no longer than that.
const WIDTH: usize = 100;
/// What is said of the whole begins this far in, behind its word.
const MARGIN: usize = 9;
/// What explains a piece stands this far in.
const INDENT: usize = 4;

/// Mesh and rays; the variant, what it saves, the proof and a line to paste; what it does without and what
/// stays, each with its reason.
pub fn text(found: &Found) -> String {
    let (report, plan) = (&found.report, &found.report.plan);
    let mut text = String::new();
    entry(&mut text, "mesh", &format!("{}, {} triangles", report.mesh, found.triangles));
    let needs = format!("a hit has to tell '{}'", report.needs);
    entry(&mut text, "rays", &format!("{} {}; {needs}", report.answers.rays, report.rays));
    text.push('\n');
    entry(&mut text, "plan", &format!("{} in '{}'", plan.variant, found.structure));
    entry(&mut text, "time", &beside(found));
    if let Some((id, saving)) = &found.settled.faster {
        let more = "it does more than it has to, and is faster all the same";
        entry(&mut text, "or", &format!("{id}: {more}: {} beside the plan", saving.words()));
    }
    entry(&mut text, "proof", &proof(found));
    entry(&mut text, "paste", &line_to_paste(found));
    text += "\nleft out\n";
    for one in &plan.left_out {
        let saving = match one.saves_percent {
            percent if percent > 0.0 => format!(": saves {percent:.1} %"),
            percent if percent < 0.0 => format!(": takes {:.1} % longer", -percent),
            _ => String::new(),
        };
        let _ = writeln!(text, "  {}{saving}", one.piece);
        wrap(&mut text, INDENT, &one.because);
    }
    text += "\nkept\n";
    for one in &plan.kept {
        let _ = writeln!(text, "  {}", one.piece);
        wrap(&mut text, INDENT, &one.because);
    }
    text.push('\n');
    wrap(&mut text, 0, RULE);
    text
}

/// How it was chosen.
const RULE: &str = "A piece that mesh and rays do not need is left out unless that was measured to be \
    slower: what cannot be told from noise goes, since less work is less work. Savings are of a test's \
    time, each of one piece by itself, so they do not add up; of the hierarchy and the bounding volume, of \
    a ray's.";

/// The time beside the default.
fn beside(found: &Found) -> String {
    match found.settled.beside_default {
        None => "that of the default: it is that".to_owned(),
        Some(saving) => format!("{} beside the default, {}", saving.words(), found.default),
    }
}

/// What was asked and what came of it.
fn proof(found: &Found) -> String {
    let answers = &found.report.answers;
    let worse = match answers.disagree {
        0 => "none is worse than the default's".to_owned(),
        some => format!("on {some} the default is right and the plan is not"),
    };
    format!(
        "{} of {} answers are exact or differ by no more than rounding explains; {worse}",
        answers.agree, answers.rays
    )
}

/// A picture by the plan, with what differs from the exact one: by the plan's variant where pictures are
/// made with it, else by its kernel's own form.
fn line_to_paste(found: &Found) -> String {
    let variant = &found.report.plan.variant;
    let mut pictured = asked().iter().filter(|form| form.axes.precision == Precision::F32.name());
    let kernel = match variant.split_once('/') {
        Some((kernel, _)) if !pictured.any(|form| form.id() == *variant) => kernel,
        _ => variant,
    };
    let (mesh, structure) = (quoted(&found.report.mesh), &found.structure);
    format!("ray_test render {mesh} --kernel {kernel} --structure {structure} --compare")
}

/// A word as shells take it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "._-+:/".contains(c);
    if word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

/// A word in the margin, and what is said behind it.
fn entry(text: &mut String, word: &str, said: &str) {
    let begin = text.len();
    wrap(text, MARGIN, said);
    let end = begin + word.len().min(MARGIN);
    text.replace_range(begin..end, word);
}

/// Adds words, line by line, so far in.
fn wrap(text: &mut String, indent: usize, words: &str) {
    let mut length = 0;
    // A number is not parted from its per cent.
    let words = words.replace(" %", "\u{a0}%");
    for word in words.split(' ').filter(|word| !word.is_empty()) {
        let more = word.chars().count() + 1;
        if length == 0 || length + more > WIDTH - indent {
            if length > 0 {
                text.push('\n');
            }
            text.push_str(&" ".repeat(indent));
            length = more - 1;
        } else {
            text.push(' ');
            length += more;
        }
        text.push_str(&word.replace('\u{a0}', " "));
    }
    text.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_not_too_long() {
        let mut text = String::new();
        wrap(&mut text, 4, &"eleven char ".repeat(30));
        assert!(text.lines().count() > 3);
        assert!(
            text.lines().all(|line| line.len() <= WIDTH && line.starts_with("    e")
                || line.starts_with("    c"))
        );
        assert_eq!(text.split_whitespace().count(), 60);
        let mut text = String::new();
        wrap(&mut text, 0, &format!("{} 5 % (4 to 6)", "a".repeat(97)));
        assert_eq!(text.lines().last(), Some("5 % (4 to 6)"));
        // Two words that fill a line, and one letter more.
        let full = format!("{} {}", "a".repeat(49), "b".repeat(50));
        let mut text = String::new();
        wrap(&mut text, 0, &full);
        wrap(&mut text, 0, &format!("{full}b"));
        assert_eq!(text.lines().map(str::len).collect::<Vec<_>>(), [100, 49, 51]);
    }

    #[test]
    fn words_stand_in_the_margin_and_meshes_in_quotes() {
        let mut text = String::new();
        entry(&mut text, "plan", &"word ".repeat(30));
        assert!(text.starts_with("plan     word word"), "{text}");
        assert!(text.lines().skip(1).all(|line| line.starts_with("         word")), "{text}");
        assert_eq!(quoted("icosphere:4"), "icosphere:4");
        assert_eq!(quoted("my bunny's.ply"), "'my bunny'\\''s.ply'");
    }
}
