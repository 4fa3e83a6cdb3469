//! A plan that one reads.

use std::fmt::Write;

use crate::plan::Found;

/// Lines are no longer than that.
const WIDTH: usize = 100;
/// What explains a piece stands this far in.
const INDENT: usize = 4;

/// The variant, what it does without, what stays, and the proof.
pub fn text(found: &Found) -> String {
    let (report, plan) = (&found.report, &found.report.plan);
    let mut text = format!("{}, {} rays, needs {}\n\n", report.mesh, report.rays, report.needs);
    // Writing to a String cannot fail.
    let _ = writeln!(text, "use {}", plan.variant);
    text += &beside(found);
    text += "\nleft out\n";
    for one in &plan.left_out {
        let _ = writeln!(text, "  {} (saves {})", one.piece, percent(one.saves_percent));
        wrap(&mut text, &one.because);
    }
    text += "\nkept\n";
    for one in &plan.kept {
        let _ = writeln!(text, "  {}", one.piece);
        wrap(&mut text, &one.because);
    }
    let answers = &report.answers;
    let _ = writeln!(
        text,
        "\nanswers: of {} rays {} agree with the exact answer or differ by rounding; on {} the default is \
         right and the plan is not",
        answers.rays, answers.agree, answers.disagree
    );
    text
}

fn beside(found: &Found) -> String {
    let default = &found.default;
    let mut text = match found.settled.beside_default {
        None => "which is the default variant\n".to_owned(),
        Some(saving) => format!("a test beside the default, {default}: {}\n", saving.words()),
    };
    if let Some((id, saving)) = &found.settled.faster {
        let _ = writeln!(
            text,
            "faster still, though it does more than it has to, {id}: {}",
            saving.words()
        );
    }
    text
}

fn percent(percent: f64) -> String {
    if percent == 0.0 { "nothing".to_owned() } else { format!("{percent:.1} %") }
}

/// Adds words, line by line.
fn wrap(text: &mut String, words: &str) {
    let mut length = 0;
    for word in words.split_whitespace() {
        let more = word.chars().count() + 1;
        if length == 0 || length + more > WIDTH - INDENT {
            if length > 0 {
                text.push('\n');
            }
            text.push_str(&" ".repeat(INDENT));
            length = 0;
        } else {
            text.push(' ');
        }
        text.push_str(word);
        length += more;
    }
    text.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_not_too_long() {
        let mut text = String::new();
        wrap(&mut text, &"eleven char ".repeat(30));
        assert!(text.lines().count() > 3);
        assert!(
            text.lines().all(|line| line.len() <= WIDTH && line.starts_with("    e")
                || line.starts_with("    c"))
        );
        assert_eq!(text.split_whitespace().count(), 60);
    }
}
