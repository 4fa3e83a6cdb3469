//! What is said in the end.

use super::proof::Answers;
use serde::Serialize;

/// A piece that the plan does without.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LeftOut {
    /// Its name.
    pub piece: &'static str,
    /// Which property allows it, with its number, and what was measured.
    pub because: String,
    /// Percent of the time of a test, or of a ray where it is about the way to the triangles; 0 where the
    /// difference is noise or nothing differs by it alone.
    pub saves_percent: f64,
}

/// A piece that stays.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Kept {
    /// Its name.
    pub piece: &'static str,
    /// Which property asks for it, with its number, or what was measured.
    pub because: String,
}

/// What to use, and why.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Plan {
    /// The id of the variant.
    pub variant: String,
    /// What it does without.
    pub left_out: Vec<LeftOut>,
    /// What stays.
    pub kept: Vec<Kept>,
}

/// The whole answer, as programs read it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// File or built-in scene.
    pub mesh: String,
    /// Which rays.
    pub rays: String,
    /// What is needed of a hit.
    pub needs: &'static str,
    /// The plan.
    pub plan: Plan,
    /// The proof.
    pub answers: Answers,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn programs_read_what_was_promised() {
        let left_out =
            LeftOut { piece: "u and v", because: "hits only".into(), saves_percent: 1.5 };
        let kept = Kept { piece: "f64", because: "far off".into() };
        let plan = Plan { variant: "wald/f32".into(), left_out: vec![left_out], kept: vec![kept] };
        let answers = Answers { rays: 9, agree: 8, disagree: 0 };
        let (mesh, rays) = ("soup".into(), "random".into());
        let report = Report { mesh, rays, needs: "hit", plan, answers };
        let wanted = serde_json::json!({
            "mesh": "soup",
            "rays": "random",
            "needs": "hit",
            "plan": {
                "variant": "wald/f32",
                "left_out": [{"piece": "u and v", "because": "hits only", "saves_percent": 1.5}],
                "kept": [{"piece": "f64", "because": "far off"}],
            },
            "answers": {"rays": 9, "agree": 8, "disagree": 0},
        });
        assert_eq!(serde_json::to_value(report).ok(), Some(wanted));
    }
}
