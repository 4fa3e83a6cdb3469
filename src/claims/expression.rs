//! What a part of a claim measures, as a formula over named series.
//!
//! ```text
//! sum     = product { ('+' | '-') product }
//! product = factor { ('*' | '/') factor }
//! factor  = '-' factor | number | "word" | name | name '(' sum { ',' sum } ')' | '(' sum ')'
//! ```

use super::function::Function;

/// A formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A number as it stands.
    Number(f64),
    /// A word between quotes: the value of a column, or its name.
    Word(String),
    /// A series or another formula, by its name.
    Name(String),
    /// A function of others.
    Call(Function, Vec<Expression>),
    /// Two joined by one of `+ - * /`.
    Joined(char, Box<Expression>, Box<Expression>),
    /// The negative.
    Negative(Box<Expression>),
}

impl Expression {
    /// Reads a formula; the error says what is wrong, where, and what is allowed.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut parser = Parser { text, at: 0 };
        let found = parser.sum()?;
        match parser.peek() {
            None => Ok(found),
            Some(other) => Err(parser.wrong(&format!("'{other}'"), "an operator, or the end")),
        }
    }

    /// Every name in it.
    pub fn names(&self) -> Vec<&str> {
        match self {
            Expression::Number(_) | Expression::Word(_) => Vec::new(),
            Expression::Name(name) => vec![name],
            Expression::Call(_, arguments) => arguments.iter().flat_map(Self::names).collect(),
            Expression::Joined(_, one, other) => [one.names(), other.names()].concat(),
            Expression::Negative(inner) => inner.names(),
        }
    }
}

struct Parser<'a> {
    text: &'a str,
    /// Bytes that are read.
    at: usize,
}

impl<'a> Parser<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    /// The next character that is no space.
    fn peek(&mut self) -> Option<char> {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
        self.rest().chars().next()
    }

    fn takes(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    /// Takes as many characters as pass.
    fn while_passes(&mut self, passes: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let length = rest.find(|c| !passes(c)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    fn wrong(&self, found: &str, allowed: &str) -> String {
        let place = self.text[..self.at].chars().count() + 1;
        format!("'{}', character {place}: {found} is not allowed; allowed: {allowed}", self.text)
    }

    fn sum(&mut self) -> Result<Expression, String> {
        self.joined(['+', '-'], Self::product)
    }

    fn product(&mut self) -> Result<Expression, String> {
        self.joined(['*', '/'], Self::factor)
    }

    fn joined(
        &mut self,
        operators: [char; 2],
        next: fn(&mut Self) -> Result<Expression, String>,
    ) -> Result<Expression, String> {
        let mut left = next(self)?;
        while let Some(operator) = self.peek().filter(|c| operators.contains(c)) {
            self.at += 1;
            let right = next(self)?;
            left = Expression::Joined(operator, Box::new(left), Box::new(right));
        }
        Ok(left)
    }

    fn factor(&mut self) -> Result<Expression, String> {
        const ALLOWED: &str = "a number, a name, a word in quotes, '-' or '('";
        match self.peek() {
            Some('-') => {
                self.at += 1;
                Ok(Expression::Negative(Box::new(self.factor()?)))
            }
            Some('(') => {
                self.at += 1;
                let inner = self.sum()?;
                self.closed(inner)
            }
            Some('"') => self.word(),
            Some(c) if c.is_ascii_digit() => self.number(),
            Some(c) if c.is_ascii_alphabetic() => self.name(),
            Some(other) => Err(self.wrong(&format!("'{other}'"), ALLOWED)),
            None => Err(self.wrong("the end", ALLOWED)),
        }
    }

    fn closed(&mut self, inner: Expression) -> Result<Expression, String> {
        if self.takes(')') { Ok(inner) } else { Err(self.wrong("this", "')' or an operator")) }
    }

    fn word(&mut self) -> Result<Expression, String> {
        self.at += 1;
        let word = self.while_passes(|c| c != '"').to_owned();
        if self.takes('"') {
            Ok(Expression::Word(word))
        } else {
            Err(self.wrong("the end", "'\"'"))
        }
    }

    fn number(&mut self) -> Result<Expression, String> {
        let start = self.at;
        self.while_passes(|c| c.is_ascii_digit() || c == '.');
        if self.rest().starts_with(['e', 'E']) {
            self.at += 1;
            self.while_passes(|c| c == '-' || c == '+');
            self.while_passes(|c| c.is_ascii_digit());
        }
        let digits = &self.text[start..self.at];
        let number = digits.parse().ok().filter(|number: &f64| number.is_finite());
        number.map(Expression::Number).ok_or_else(|| self.wrong(digits, "a number"))
    }

    fn name(&mut self) -> Result<Expression, String> {
        let start = self.at;
        let name = self.while_passes(|c| c.is_ascii_alphanumeric() || c == '_');
        if !self.takes('(') {
            return Ok(Expression::Name(name.to_owned()));
        }
        let Some(function) = Function::find(name) else {
            self.at = start;
            return Err(self.wrong(name, &Function::names()));
        };
        let mut arguments = vec![self.sum()?];
        while self.takes(',') {
            arguments.push(self.sum()?);
        }
        function.accepts(arguments.len()).map_err(|allowed| {
            self.wrong(&format!("{name} of {} arguments", arguments.len()), &allowed)
        })?;
        self.closed(Expression::Call(function, arguments))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(name: &str) -> Box<Expression> {
        Box::new(Expression::Name(name.to_owned()))
    }

    #[test]
    fn products_bind_tighter_and_everything_to_the_left() {
        let found = Expression::parse("a - b - c * d").expect("a formula");
        let first = Expression::Joined('-', name("a"), name("b"));
        let product = Expression::Joined('*', name("c"), name("d"));
        assert_eq!(found, Expression::Joined('-', Box::new(first), Box::new(product)));
        let found = Expression::parse("a / (b + c)").expect("a formula");
        let sum = Expression::Joined('+', name("b"), name("c"));
        assert_eq!(found, Expression::Joined('/', name("a"), Box::new(sum)));
    }

    #[test]
    fn calls_words_and_numbers() {
        let found = Expression::parse(" at(x , \"keidy\", 0.25) * -1e-6").expect("a formula");
        let arguments =
            vec![*name("x"), Expression::Word("keidy".to_owned()), Expression::Number(0.25)];
        let call = Expression::Call(Function::At, arguments);
        let negative = Expression::Negative(Box::new(Expression::Number(1e-6)));
        assert_eq!(found, Expression::Joined('*', Box::new(call), Box::new(negative)));
        assert_eq!(found.names(), ["x"]);
    }

    #[test]
    fn what_is_no_formula_is_refused_with_its_place() {
        for (text, place) in [
            ("", "character 1: the end"),
            ("a +", "character 4: the end"),
            ("a b", "character 3: 'b'"),
            ("(a", "character 3: this"),
            ("frobnicate(a)", "character 1: frobnicate"),
            ("1.2.3", "character 6: 1.2.3"),
            ("at(a, \"b)", "character 10: the end"),
            ("ln(a, b)", "character 8: ln of 2 arguments"),
            ("a ² b", "character 3: '²'"),
        ] {
            let error = Expression::parse(text).expect_err(text);
            assert!(error.contains(place) && error.contains("allowed: "), "{text}: {error}");
        }
    }
}
