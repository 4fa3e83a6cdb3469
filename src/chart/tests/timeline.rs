use super::*;
use crate::chart::timeline;
use crate::table::Round;

/// A round of 0.1 s; its group's usual time is 4 ns.
fn round(experiment: &str, number: u64, times: f64, state: &str) -> Round {
    Round {
        experiment: experiment.into(),
        cell: "0 fixed".into(),
        round: number,
        at_s: 0.1 * number as f64,
        reference_ns_per_test: Some(4.0 * times),
        state: state.into(),
    }
}

/// Forty experiments of which most are short, a neighbour, and an outlier.
fn busy() -> Vec<Round> {
    let mut rounds = Vec::new();
    for number in 0..2000u64 {
        let experiment = format!("experiment-{}", number * number / 100_000);
        let times = 1.0 + 0.01 * (number % 7) as f64;
        rounds.push(match number % 40 {
            11 => round(&experiment, number, 1.3, "crowded"),
            23 => round(&experiment, number, 2.9, "dirty"),
            _ => round(&experiment, number, times, "clean"),
        });
    }
    rounds
}

fn checked(rounds: &[Round]) -> String {
    let svg = timeline(rounds, false).expect("it can be drawn");
    if let Ok(folder) = std::env::var("RAY_TEST_FIGURES") {
        std::fs::write(format!("{folder}/timeline-{}.svg", rounds.len()), &svg).expect("a folder");
    }
    boxes::check(&svg);
    svg
}

#[test]
fn a_busy_run_is_drawn_small_and_says_how_much_was_clean() {
    let svg = checked(&busy());
    // Of two thousand, fifty each were not.
    let words = svg.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(words.matches("2.5 % of all").count(), 2, "{words}");
    assert!(words.contains("Of 2000 rounds 2.5 % were thrown away"), "{words}");
    assert!(svg.len() < 400_000, "{}", svg.len());
    assert_eq!(timeline(&busy(), false).ok(), Some(svg));
}

#[test]
fn few_rounds_and_none_are_drawn_as_well() {
    checked(&busy()[..1]);
    // Without a clean round, the others tell what is usual.
    let crowded = checked(&[round("h-4", 0, 1.0, "crowded"), round("h-4", 1, 1.0, "crowded")]);
    assert!(crowded.contains("(100.0 % of all)"));
    let without = Round { reference_ns_per_test: None, ..round("h-4", 0, 1.0, "clean") };
    for nothing in [&[][..], &[without]] {
        assert!(checked(nothing).contains("Not drawn"));
    }
}

#[test]
fn what_is_far_off_is_cut_off_and_counted() {
    // A machine that changes its speed for good: from 0 to 50 % above what is usual.
    let rounds: Vec<Round> = (0..320)
        .map(|number| round("h-4", number, if number < 288 { 1.0 } else { 1.5 }, "clean"))
        .collect();
    let svg = checked(&rounds);
    assert!(svg.contains("2 windows reach beyond 30 %, cut off there"));
    let words = svg.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("within 0.0 % of its usual time, at worst 50.0 % off"), "{words}");
    assert!(!checked(&rounds[..288]).contains("cut off"));
}

#[test]
fn a_page_has_question_and_sentence_itself() {
    let bare = timeline(&busy(), true).expect("it can be drawn");
    boxes::check(&bare);
    // It stays in the description, for screen readers.
    let texts = |svg: &str| svg.matches("<text ").count();
    assert!(texts(&bare) < texts(&checked(&busy())) && bare.contains("Of 2000 rounds"));
}
