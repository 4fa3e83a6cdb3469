//! What an experiment asks, for whoever reads stored rows: from the text that lies beside them, or
//! from the experiments that are compiled in.

use super::built_in::built_in_sources;
use crate::experiment::Experiment;
use crate::results::{About, DESCRIPTION};
use crate::stability::EXPERIMENT as STABILITY;

/// Describes an experiment by its id and, where it was stored, by its text; `None` if neither says
/// anything. A text that this program does not understand is told of on stderr.
pub fn describe(id: &str, text: Option<&str>) -> Option<About> {
    if id == STABILITY {
        return Some(of_stability());
    }
    let built_in =
        built_in_sources().into_iter().find(|(name, _)| *name == format!("configs/{id}.toml"));
    if let Some(text) = text {
        // What is the same as a file of ours is that file.
        let same = built_in.as_ref().filter(|(_, ours)| ours == text);
        let stored = format!("{id}/{DESCRIPTION}");
        let config = same.map_or(stored, |(name, _)| name.clone());
        match Experiment::parse(&config, text) {
            Ok(experiment) => return Some(of(experiment, config)),
            Err(error) => {
                say!("note: {error}; the experiment of this program is taken instead")
            }
        }
    }
    let (name, text) = built_in?;
    Some(of(Experiment::parse(&name, &text).ok()?, name))
}

fn of(experiment: Experiment, config: String) -> About {
    About {
        command: format!("ray_test run {config}"),
        id: experiment.id,
        title: experiment.title,
        mirrors: experiment.mirrors,
        question: experiment.question,
        why: experiment.why,
        claims: experiment.claims,
        figures: experiment.figure,
        config,
    }
}

/// It has no file, and its figures are those of its rows.
fn of_stability() -> About {
    About {
        id: STABILITY.to_owned(),
        title: "Where does each kernel start to fail?".to_owned(),
        question: "On which stiff and extreme cases does each kernel fail, and which rays through \
                   edges and vertices of closed meshes does it lose?"
            .to_owned(),
        why: "Random triangles say little about needles, grazing rays or coordinates far from the \
              origin. Each family of cases has a knob from harmless to hard; every form of every \
              kernel is asked the same cases, and its answers are compared with the exact ones. A \
              kernel is not blamed for what a rounding of the inputs does by itself: that stands \
              beside its errors. No clock is read."
            .to_owned(),
        command: "ray_test stability".to_owned(),
        ..About::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_text_beside_the_rows_goes_before_ours() {
        let (name, text) = built_in_sources().into_iter().next().expect("there are some");
        let id = name.trim_start_matches("configs/").trim_end_matches(".toml").to_owned();
        let config = |text: Option<&str>| describe(&id, text).map(|about| about.config);
        assert_eq!(config(None), Some(name.clone()));
        assert_eq!(config(Some(&text)), Some(name.clone()));
        let changed = format!("{text}\n# changed\n");
        assert_eq!(config(Some(&changed)), Some(format!("{id}/experiment.toml")));
        // What this program does not understand does not hide what it knows.
        assert_eq!(config(Some("id = 7")), Some(name));
        assert!(describe("nobody-knows-this", None).is_none());
        let stability = describe(STABILITY, None).expect("it has no file, but words");
        assert_eq!((stability.id.as_str(), stability.config.as_str()), (STABILITY, ""));
    }
}
