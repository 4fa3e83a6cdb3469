//! From what was looked at, measured and proved to a plan.

use super::evidence::Saving;
use super::form::Form;
use super::outcome::{Kept, LeftOut, Plan};
use super::piece::{Look, Piece};
use super::proof::Answers;

/// A form that may become the plan, with its times.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The form.
    pub form: Form,
    /// ns of a test in each round, its share of preparing the triangle included.
    pub times: Vec<f64>,
    /// Its time over the default's when the two were timed once more, after it had been chosen: who comes
    /// first of many owes a part of that to chance.
    pub again: Option<Saving>,
}

/// Forms that were measured side by side.
#[derive(Clone, Debug)]
pub struct Finals {
    /// The forms; all are right on the sample.
    pub entries: Vec<Entry>,
    /// Where the default variant is among them.
    pub default: usize,
    /// What identical code differs by, relative.
    pub floor: f64,
}

impl Finals {
    /// Time of an entry over that of the default; where the two were timed once more, then.
    fn beside_default(&self, entry: usize) -> Option<Saving> {
        let (one, default) = (&self.entries[entry], &self.entries[self.default]);
        one.again.or_else(|| Saving::of(&one.times, &default.times, self.floor))
    }

    /// Whether a form was not timed once more; the default has nothing to be timed beside.
    pub fn is_unconfirmed(&self, id: &str) -> bool {
        let place = self.place(id).filter(|place| *place != self.default);
        place.is_some_and(|place| self.entries[place].again.is_none())
    }

    /// Takes down what came of timing a form beside the default once more; where there were too few rounds,
    /// what the finals said stands.
    pub fn confirm(&mut self, id: &str, again: Option<Saving>) {
        if let Some(place) = self.place(id) {
            self.entries[place].again = again.or_else(|| self.beside_default(place));
        }
    }

    fn place(&self, id: &str) -> Option<usize> {
        self.entries.iter().position(|entry| entry.form.id == id)
    }
}

/// A piece with what is known of it.
pub struct Looked<'a> {
    /// The piece.
    pub piece: &'a Piece,
    /// What the situation says.
    pub look: Look,
    /// What its pair of forms says.
    pub saving: Option<Saving>,
    /// Why it was brought back, if it was.
    pub back: Option<String>,
}

/// What came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Settled {
    /// The plan.
    pub plan: Plan,
    /// The proof.
    pub answers: Answers,
    /// Time of the plan over that of the default variant; `None` where the plan is the default.
    pub beside_default: Option<Saving>,
    /// A form that does more than it has to, and is faster all the same, beyond noise; its time over that
    /// of the plan.
    pub faster: Option<(String, Saving)>,
}

impl Looked<'_> {
    fn may_go(&self) -> bool {
        self.look.is_spare() && self.back.is_none()
    }

    /// Whether a form had better leave it out: it may, and that is not slower by itself.
    fn should_go(&self) -> bool {
        self.may_go() && self.look.is_waste() && !self.saving.is_some_and(|one| one.is_loss())
    }
}

/// Chooses the form that does all that is needed and least besides, and brings pieces back until its
/// answers are at least as good as the default variant's. `prove` tells a form's answers on all rays beside the default
/// variant's, of which `agree` are right.
pub fn settle(
    looked: &mut [Looked<'_>],
    finals: &Finals,
    agree: u64,
    prove: &mut dyn FnMut(&Form) -> Answers,
) -> Settled {
    let holds = |answers: &Answers| answers.disagree == 0 && answers.agree >= agree;
    loop {
        let chosen = choose(looked, finals, None);
        let answers = prove(&finals.entries[chosen].form);
        if chosen == finals.default || holds(&answers) {
            return told(looked, finals, chosen, answers);
        }
        let causes: Vec<usize> = (0..looked.len())
            .filter(|place| looked[*place].may_go() && gone(looked, *place, finals, chosen))
            .collect();
        let cause = causes.iter().copied().find(|place| {
            let other = choose(looked, finals, Some(*place));
            other != finals.default && holds(&prove(&finals.entries[other].form))
        });
        let wrong = answers.disagree.max(agree.saturating_sub(answers.agree));
        let because = format!(
            "without it {} gives a worse answer than the default variant on {wrong} of {} rays",
            finals.entries[chosen].form.id, answers.rays
        );
        // Where no single one explains it, all of them come back, and the default is left.
        let back = cause.map_or(causes.clone(), |place| vec![place]);
        if back.is_empty() {
            let default = finals.default;
            let answers = prove(&finals.entries[default].form);
            return told(looked, finals, default, answers);
        }
        back.iter().for_each(|place| looked[*place].back = Some(because.clone()));
    }
}

/// Whether the form leaves out a piece that the default variant does.
fn gone(looked: &[Looked<'_>], place: usize, finals: &Finals, chosen: usize) -> bool {
    let leaves = |entry: usize| looked[place].piece.is_left_out_by(&finals.entries[entry].form);
    leaves(chosen) && !leaves(finals.default)
}

/// Whether a form does what is needed, and `also` the piece at that place.
fn does_enough(looked: &[Looked<'_>], form: &Form, also: Option<usize>) -> bool {
    (0..looked.len()).all(|place| {
        let may_go = looked[place].may_go() && also != Some(place);
        may_go || !looked[place].piece.is_left_out_by(form)
    })
}

/// Pieces that a form does and had better leave out.
pub fn waste(looked: &[Looked<'_>], form: &Form) -> usize {
    looked.iter().filter(|one| one.should_go() && !one.piece.is_left_out_by(form)).count()
}

/// Of the forms that do what is needed, and `also` the piece at that place, and are not slower than the
/// default beyond noise: the one that does least besides, and of several the fastest.
fn choose(looked: &[Looked<'_>], finals: &Finals, also: Option<usize>) -> usize {
    let beside = |entry: usize| finals.beside_default(entry);
    // What cannot be compared is not taken.
    let ratio = |entry: usize| beside(entry).map_or(f64::INFINITY, |one| one.ratio.estimate);
    let is_allowed = |entry: &usize| {
        let enough = does_enough(looked, &finals.entries[*entry].form, also);
        let as_fast = beside(*entry).is_some_and(|one| !one.is_loss());
        *entry == finals.default || (enough && as_fast)
    };
    let wasted = |entry: usize| waste(looked, &finals.entries[entry].form);
    let least =
        |a: &usize, b: &usize| wasted(*a).cmp(&wasted(*b)).then(ratio(*a).total_cmp(&ratio(*b)));
    let allowed = (0..finals.entries.len()).filter(is_allowed);
    allowed.min_by(least).unwrap_or(finals.default)
}

/// The fastest form that does what is needed, if it is faster than the chosen one beyond noise.
fn faster(looked: &[Looked<'_>], finals: &Finals, chosen: usize) -> Option<(String, Saving)> {
    let times = &finals.entries[chosen].times;
    let enough = finals.entries.iter().filter(|entry| does_enough(looked, &entry.form, None));
    let compared = enough.filter_map(|entry| {
        Some((entry.form.id.clone(), Saving::of(&entry.times, times, finals.floor)?))
    });
    let fastest = compared.min_by(|a, b| a.1.ratio.estimate.total_cmp(&b.1.ratio.estimate));
    fastest.filter(|(_, saving)| saving.percent() > 0.0)
}

fn told(looked: &[Looked<'_>], finals: &Finals, chosen: usize, answers: Answers) -> Settled {
    let form = &finals.entries[chosen].form;
    let mut plan = Plan { variant: form.id.clone(), left_out: Vec::new(), kept: Vec::new() };
    for one in looked {
        let piece = one.piece.name;
        if one.may_go() && (one.piece.done_by.is_none() || one.piece.is_left_out_by(form)) {
            let (because, saves_percent) = saved(one);
            plan.left_out.push(LeftOut { piece, because, saves_percent });
        } else {
            plan.kept.push(Kept { piece, because: kept(one, finals, chosen) });
        }
    }
    let beside_default = finals.beside_default(chosen).filter(|_| chosen != finals.default);
    Settled { plan, answers, beside_default, faster: faster(looked, finals, chosen) }
}

/// Why a piece may go, and percent that it saves.
fn saved(one: &Looked<'_>) -> (String, f64) {
    let saving = match &one.look {
        Look::Measured(_, saving) => Some(*saving),
        _ => one.saving,
    };
    let because = one.look.because();
    match saving {
        Some(saving) => (format!("{because}; {}", saving.words()), saving.percent()),
        None if one.piece.pair.is_some() => {
            (format!("{because}; its two forms could not be timed here"), 0.0)
        }
        None if matches!(one.look, Look::Open(_)) => {
            (format!("{because}; the form that is left does without"), 0.0)
        }
        None => (because.to_owned(), 0.0),
    }
}

/// Why a piece stays.
fn kept(one: &Looked<'_>, finals: &Finals, chosen: usize) -> String {
    let because = one.look.because();
    if !one.look.is_spare() {
        return because.to_owned();
    }
    if let Some(back) = &one.back {
        return format!("{because}; but {back}");
    }
    let times = &finals.entries[chosen].times;
    let ratio = |entry: &Entry| Saving::of(&entry.times, times, finals.floor);
    let without = finals.entries.iter().filter(|entry| one.piece.is_left_out_by(&entry.form));
    let best = without
        .filter_map(|entry| Some((entry, ratio(entry)?)))
        .min_by(|a, b| a.1.ratio.estimate.total_cmp(&b.1.ratio.estimate));
    match best {
        Some((entry, saving)) if saving.is_loss() => format!(
            "{because}; but {}, which leaves it out, is {:.1} % slower than the plan",
            entry.form.id,
            -saving.percent()
        ),
        Some((entry, _)) => format!(
            "{because}; but {}, which leaves it out, is no faster than the plan or does too little",
            entry.form.id
        ),
        None => {
            format!("{because}; but no form leaves it out beside all else that is to be left out")
        }
    }
}
