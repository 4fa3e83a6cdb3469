//! Somebody else's answers, beside the cases that they answer.

use super::cases::Cases;
use super::error::ReadError;
use super::records::{Records, Schema};
use crate::check::{Case, Reply};
use std::io::BufRead;

const SCHEMA: Schema = Schema { names: &["id", "hit", "t", "u", "v"], required: 5 };
const ID: usize = 0;
const HIT: usize = 1;

/// An answer and the id of its case.
struct Given {
    id: String,
    reply: Reply,
}

/// Reads answer after answer.
pub struct Answers<R>(Records<R>);

impl<R: BufRead> Answers<R> {
    /// `file` is what messages call the input.
    pub fn new(input: R, file: &str) -> Self {
        Answers(Records::new(input, file, SCHEMA))
    }

    fn advance(&mut self) -> Result<Option<Given>, ReadError> {
        let records = &mut self.0;
        if !records.advance()? {
            return Ok(None);
        }
        let id = records.text(ID).ok_or_else(|| records.bad(ID, "the id of a case"))?.to_owned();
        let hit = match records.text(HIT).map(str::to_lowercase).as_deref() {
            Some("true" | "1") => true,
            Some("false" | "0") => false,
            _ => return Err(records.bad(HIT, "true, false, 1 or 0")),
        };
        let value = |name: usize| match records.text(name).map(str::parse) {
            None => Ok(None),
            Some(Ok(number)) => Ok(Some(number)),
            Some(Err(_)) => Err(records.bad(name, "a number, nan, inf or nothing")),
        };
        let reply = Reply { hit, t: value(2)?, u: value(3)?, v: value(4)? };
        Ok(Some(Given { id, reply }))
    }
}

/// Cases with their answers: both in the same order, one answer for each case.
pub struct Answered<C, A> {
    cases: Cases<C>,
    answers: Answers<A>,
}

impl<C: BufRead, A: BufRead> Answered<C, A> {
    /// Nothing is read yet.
    pub fn new(cases: Cases<C>, answers: Answers<A>) -> Self {
        Answered { cases, answers }
    }

    /// The next case and its answer; `None` behind the last.
    ///
    /// # Errors
    /// Those of [`Cases::advance`]; what is wrong with an answer; and a missing, superfluous or
    /// misplaced one, with its id.
    pub fn advance(&mut self) -> Result<Option<(Case, Reply)>, ReadError> {
        match (self.cases.advance()?, self.answers.advance()?) {
            (Some(case), Some(given)) if case.id == given.id => Ok(Some((case, given.reply))),
            (Some(case), Some(given)) => self.mismatch(&case.id, &given.id),
            (Some(case), None) => {
                Err(self.answers.0.whole(format!("no answer for the case '{}'", case.id)))
            }
            (None, Some(given)) => Err(self.superfluous(&given.id)),
            (None, None) => Ok(None),
        }
    }

    fn superfluous(&self, id: &str) -> ReadError {
        self.answers.0.bad_line(format!("an answer for '{id}', which is no case or had its answer"))
    }

    /// Tells apart an answer too few, one too many, and another order, by the next of both.
    fn mismatch<T>(&mut self, case: &str, given: &str) -> Result<T, ReadError> {
        let answers = &self.answers.0;
        let missing = answers.bad_line(format!("no answer for the case '{case}'"));
        let superfluous = self.superfluous(given);
        let order = answers.bad_line(format!(
            "an answer for '{given}' where '{case}' is due; allowed: one answer for each case, in \
             the order of the cases"
        ));
        // What is wrong further on is not what is wrong first.
        let given_is_next = matches!(self.cases.advance(), Ok(Some(next)) if next.id == given);
        let case_is_next = matches!(self.answers.advance(), Ok(Some(next)) if next.id == case);
        Err(match (given_is_next, case_is_next) {
            (true, false) => missing,
            (false, true) => superfluous,
            _ => order,
        })
    }
}
