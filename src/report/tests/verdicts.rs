//! Claims: counted once, under the condition that they are about.

use super::*;
use crate::report::ledger::Ledger;

fn ledger(findings: &[Finding]) -> Ledger {
    Ledger::new(&results(Vec::new(), &[]), findings)
}

#[test]
fn a_claim_counts_once_and_by_its_own_condition() {
    let findings = [
        finding("B-1", "literal", Verdict::Reproduced, true),
        finding("B-1", "fixed", Verdict::Reproduced, false),
        finding("B-1", "reshuffled", Verdict::NotReproduced, false),
        finding("B-2", "", Verdict::Undecided, true),
        finding("H-1", "", Verdict::NotTestable, true),
    ];
    let ledger = ledger(&findings);
    assert_eq!(
        ledger.sentence,
        "Of 3 claims: 1 reproduced, 1 undecided and 1 not testable here. One of them is turned \
         round by another condition."
    );
    let papers: Vec<usize> = ledger.papers.iter().map(|paper| paper.claims.len()).collect();
    assert_eq!(papers, [2, 1]);
    assert_eq!(
        ledger.papers[0].claims[0].headline,
        "reproduced (literal, fixed); not reproduced (reshuffled)"
    );
    assert_eq!(ledger.papers[0].claims[0].experiments, ["first"]);
}

#[test]
fn every_verdict_is_told_by_a_sign_and_by_words() {
    for (verdict, sign, words) in [
        (Verdict::Reproduced, "✓", "reproduced"),
        (Verdict::NotReproduced, "✗", "not reproduced"),
        (Verdict::Undecided, "?", "undecided"),
        (Verdict::NotTestable, "–", "not testable here"),
    ] {
        let page = html(&results(Vec::new(), &[]), &[finding("B-1", "", verdict, true)]);
        assert!(page.contains(&format!("aria-hidden=\"true\">{sign}</span> {words}</td>")));
        assert!(page.contains("[1.20, 1.30]") && page.contains("id=\"claim-B-1\""));
    }
}

#[test]
fn machines_that_disagree_are_counted_apart() {
    let findings = [
        finding("B-1", "literal, Z80", Verdict::Reproduced, true),
        finding("B-1", "literal, 6502", Verdict::NotReproduced, true),
    ];
    assert!(ledger(&findings).sentence.starts_with("Of 1 claim: 1 depends on the machine."));
}

#[test]
fn a_link_to_a_claim_that_was_not_judged_leads_nowhere_and_is_none() {
    let page = html(&results(vec![timed("a", 1.0)], &[]), &[]);
    assert!(!page.contains("href=\"#claim-B-1\""));
    assert!(page.contains("claims B-1"));
}
