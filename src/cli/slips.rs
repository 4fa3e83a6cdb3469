//! A word in place of a density that is meant as a verb.

/// Words that are verbs of this program: a lone one that is close to them is a slip, not a density.
const VERBS: [&str; 13] = [
    "run",
    "reproduce",
    "list",
    "check",
    "stability",
    "compare",
    "report",
    "scene",
    "render",
    "recommend",
    "doctor",
    "completions",
    "help",
];

/// How alike two words must be to be taken for a slip (Jaro-Winkler, 1 is equal).
const ALIKE: f64 = 0.85;

/// What to say of a word that is meant as a verb; `None` for densities and other words.
pub fn slip(word: &str) -> Option<String> {
    if word.parse::<f64>().is_ok() || word == "all" {
        return None;
    }
    let alike = |verb: &&str| strsim::jaro_winkler(word, verb);
    let best = VERBS.into_iter().max_by(|a, b| alike(a).total_cmp(&alike(b)))?;
    (alike(&best) >= ALIKE).then(|| format!("unrecognized verb '{word}'; did you mean '{best}'?"))
}
