//! What is timed on the sample, one group after the other: pairs, heats, preparing, finals, and the plan
//! beside the default once more.

use super::contest::{self, Timed};
use super::evidence::Saving;
use super::form::Form;
use super::heats;
use super::pieces::PIECES;
use super::pilot::Asking;
use super::prepare::{self, Stores};
use super::proof::{Answers, Standing};
use super::settle::{Finals, Looked, Settled, settle, waste};
use super::situation::Situation;
use crate::experiment::cells::{CONTROLS, MOST_SUBJECTS};
use crate::experiment::{Bench, Patience, Scene, Trouble};
use crate::measure::{Order, Protocol};
use crate::registry::{Variant, find};
use crate::table::Row;
use std::sync::atomic::Ordering;

/// Heats have so many times fewer rounds than finals. They only say who is worth a closer look: a form that
/// is missed for a per cent or two costs the plan no more than that.
const FEWER: usize = 4;
/// Triangles that are prepared: corners and records fit the first cache.
const PREPARED: usize = 256;
/// Contestants of the group that the ways to the triangles are timed in.
const WAYS: usize = 6;
/// Times that a plan is timed beside the default once more, as a rule.
const CONFIRMATIONS: usize = 1;

/// About how many blocks are timed in groups of so many rounds, of so many forms.
pub fn blocks(rounds: usize, forms: usize) -> usize {
    let group = |order: Order, rounds: usize, contestants: usize| {
        let protocol = Protocol { rounds, ..Protocol::new(order, 0) };
        protocol.planned_rounds(contestants) * contestants
    };
    let most = MOST_SUBJECTS + CONTROLS;
    let full = group(Order::Reshuffled, rounds, most);
    // Groups are cut between kernels, and so there may be one more.
    let heats = forms.div_ceil(MOST_SUBJECTS) + 1;
    let contests = 2 * full + heats * group(Order::Reshuffled, heat_rounds(rounds), most);
    let confirmed = CONFIRMATIONS * group(Order::Reshuffled, rounds, 2 + CONTROLS);
    rounds * WAYS + contests + group(Order::Fixed, rounds, most) + confirmed
}

/// Rounds of the heats.
fn heat_rounds(rounds: usize) -> usize {
    (rounds / FEWER).max(Protocol::LEAST_ROUNDS)
}

/// What is timed with, on what, and where it is taken down.
pub struct Stages<'a, 'b> {
    /// What is known so far.
    pub situation: Situation,
    /// The variant that a plan must not be slower than.
    pub default: &'static Variant,
    /// The sample.
    pub scene: &'a Scene,
    /// The clock.
    pub bench: &'a mut Bench<'b>,
    /// All that was timed.
    pub rows: &'a mut Vec<Row>,
}

/// What was timed before anything is chosen.
struct Contested {
    pairs: Timed,
    stores: Stores,
    finals: Finals,
}

impl Stages<'_, '_> {
    /// Times, chooses and proves. `None` when interrupted, or where the default cannot be timed.
    ///
    /// # Errors
    /// A group that cannot be measured.
    pub fn settled(&mut self, asking: &mut Asking<'_, '_>) -> Result<Option<Settled>, Trouble> {
        let Some(mut contested) = self.contested()? else { return Ok(None) };
        let mut looked = looked(&self.situation, contest::savings(&contested.pairs));
        let mut proofs = Proofs { usual: asking.standing(self.default), known: Vec::new() };
        let agree = proofs.usual.agree();
        // Each time round one more form was timed once more.
        loop {
            let mut prove = |form: &Form| proofs.of(form, asking);
            let settled = settle(&mut looked, &contested.finals, agree, &mut prove);
            let chosen = &settled.plan.variant;
            if !contested.finals.is_unconfirmed(chosen) {
                return Ok(Some(settled));
            }
            let again = self.again(chosen, &contested.stores)?;
            if self.bench.cancel.load(Ordering::Relaxed) {
                return Ok(None);
            }
            contested.finals.confirm(chosen, again);
        }
    }

    /// Pairs, heats, preparing, finals.
    fn contested(&mut self) -> Result<Option<Contested>, Trouble> {
        let looks: Vec<bool> =
            PIECES.iter().map(|piece| (piece.look)(&self.situation).is_spare()).collect();
        let pairs = self.time(&contest::paired(&|place| looks[place]))?;
        let forms = self.forms(&looks);
        let heats = self.heats(&forms, &pairs)?;
        let some = &self.scene.triangles[..self.scene.triangles.len().min(PREPARED)];
        let stores = prepare::time(&forms, some, self.scene.facts.seed, self.bench)?;
        let finalists = self.finalists(&forms, &heats, &pairs, &stores);
        let timed = self.time(&finalists)?;
        if self.bench.cancel.load(Ordering::Relaxed) {
            return Ok(None);
        }
        let tests = self.situation.crowd.tests_per_triangle();
        self.situation.preparing = prepare::worth(&timed, &finalists, &stores, tests);
        let share = |variant: &Variant| share(&stores, variant, tests);
        let finals = heats::finals(&timed, &finalists, self.default, &share);
        Ok(finals.map(|finals| Contested { pairs, stores, finals }))
    }

    /// The forms that do what is needed, and the default.
    fn forms(&self, spare: &[bool]) -> Vec<&'static Variant> {
        let needed = |form: &Form| {
            let mut pieces = PIECES.iter().zip(spare);
            pieces.all(|(piece, is_spare)| *is_spare || !piece.is_left_out_by(form))
        };
        let output = self.situation.wanted.output;
        let mut forms = contest::candidates(output, self.situation.pilot.too_coarse > 0, &needed);
        if !forms.iter().any(|form| std::ptr::eq(*form, self.default)) {
            forms.push(self.default);
        }
        forms.sort_by_key(|variant| variant.axes.kernel);
        forms
    }

    /// All forms in few rounds; those of the pairs have their times already.
    fn heats(&mut self, forms: &[&'static Variant], pairs: &Timed) -> Result<Timed, Trouble> {
        let untimed = |form: &&'static Variant| pairs.of(&form.id()).is_none();
        let untimed: Vec<&'static Variant> = forms.iter().copied().filter(untimed).collect();
        let (rounds, patience) = (self.bench.rounds, *self.bench.patience);
        self.bench.rounds = heat_rounds(rounds);
        *self.bench.patience = Patience { groups: 0, ..patience };
        let heats = self.time(&untimed);
        (self.bench.rounds, *self.bench.patience) = (rounds, patience);
        let mut heats = heats?;
        heats.figures.extend(pairs.figures.iter().cloned());
        Ok(heats)
    }

    /// Those that go on, by what preparing is worth as far as the heats tell.
    fn finalists(
        &mut self,
        forms: &[&'static Variant],
        heats: &Timed,
        pairs: &Timed,
        stores: &Stores,
    ) -> Vec<&'static Variant> {
        let tests = self.situation.crowd.tests_per_triangle();
        self.situation.preparing = prepare::worth(heats, forms, stores, tests);
        let looked = looked(&self.situation, contest::savings(pairs));
        let share = |variant: &Variant| share(stores, variant, tests);
        let waste = |form: &Form| waste(&looked, form);
        heats::finalists(heats, forms, self.default, &share, &waste)
    }

    /// A form beside the default alone: its time over the default's. `None` without enough rounds.
    fn again(&mut self, id: &str, stores: &Stores) -> Result<Option<Saving>, Trouble> {
        let Some(chosen) = find(id) else { return Ok(None) };
        let timed = self.time(&[chosen, self.default])?;
        let tests = self.situation.crowd.tests_per_triangle();
        let share = |variant: &Variant| share(stores, variant, tests);
        let times = |variant| heats::with_share(&timed, variant, &share);
        let both = times(chosen).zip(times(self.default));
        Ok(both.and_then(|(own, default)| Saving::of(&own, &default, timed.floor)))
    }

    fn time(&mut self, variants: &[&'static Variant]) -> Result<Timed, Trouble> {
        let timed = contest::time(variants, self.default, self.scene, self.bench)?;
        self.rows.extend(timed.rows.iter().cloned());
        Ok(timed)
    }
}

/// Answers of forms on all rays, each asked for once.
struct Proofs {
    /// Those of the default.
    usual: Standing,
    known: Vec<(String, Answers)>,
}

impl Proofs {
    fn of(&mut self, form: &Form, asking: &mut Asking<'_, '_>) -> Answers {
        if let Some((_, answers)) = self.known.iter().find(|(id, _)| *id == form.id) {
            return *answers;
        }
        let answers = find(&form.id)
            .map_or_else(Answers::default, |variant| asking.standing(variant).beside(&self.usual));
        self.known.push((form.id.clone(), answers));
        answers
    }
}

/// What is known of each piece.
fn looked(situation: &Situation, savings: Vec<Option<Saving>>) -> Vec<Looked<'static>> {
    let pieces = PIECES.iter().zip(savings);
    let one = |(piece, saving)| Looked { piece, look: (piece.look)(situation), saving, back: None };
    pieces.map(one).collect()
}

/// What preparing adds to a test, ns. What could not be timed is never chosen.
fn share(stores: &Stores, variant: &Variant, tests_per_triangle: f64) -> f64 {
    stores.of(variant).map_or(f64::INFINITY, |cost| cost.median / tests_per_triangle)
}
