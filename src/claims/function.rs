//! The functions that a formula may call.

/// A function by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// `at(series, key...)`: the figure of a key; of its first columns alone, the series of the others.
    At,
    /// `without(series, key...)`: all whose first key is none of these.
    Without,
    /// `like(series, word)`: all whose first key contains the word.
    Like,
    /// `keys(series)`: the keys, as figures.
    Keys,
    /// `first(series)`
    First,
    /// `last(series)`
    Last,
    /// `count(series)`
    Count,
    /// `mean(series, column...)`: over these columns, or over all. So `sum`, `min`, `max`, `median`,
    /// `spread` (largest over smallest) and `geomean`.
    Mean,
    /// The geometric mean.
    Geomean,
    /// The sum.
    Sum,
    /// The smallest; of several numbers as well.
    Min,
    /// The largest; of several numbers as well.
    Max,
    /// The median.
    Median,
    /// The largest over the smallest of two or more.
    Spread,
    /// `slope(series)`: of the straight line of least squares over the numeric key.
    Slope,
    /// `r2(series)`: share of the variance that this line explains.
    RSquared,
    /// `growth(series)`: the slope with key and figure as logarithms, the exponent of a power.
    Growth,
    /// `spearman(a, b)`: rank correlation of two series of the same keys; `a` must be exact.
    Spearman,
    /// Natural logarithm.
    Ln,
    /// Exponential function.
    Exp,
    /// Square root.
    Sqrt,
    /// Absolute value.
    Abs,
    /// Square.
    Square,
}

use Function::{
    Abs, At, Count, Exp, First, Geomean, Growth, Keys, Last, Like, Ln, Max, Mean, Median, Min,
    RSquared, Slope, Spearman, Spread, Sqrt, Square, Sum, Without,
};

/// Name, function, fewest and most arguments.
const ALL: [(&str, Function, usize, usize); 23] = [
    ("at", At, 2, usize::MAX),
    ("without", Without, 2, usize::MAX),
    ("like", Like, 2, 2),
    ("keys", Keys, 1, 1),
    ("first", First, 1, 1),
    ("last", Last, 1, 1),
    ("count", Count, 1, 1),
    ("mean", Mean, 1, usize::MAX),
    ("geomean", Geomean, 1, usize::MAX),
    ("sum", Sum, 1, usize::MAX),
    ("min", Min, 1, usize::MAX),
    ("max", Max, 1, usize::MAX),
    ("median", Median, 1, usize::MAX),
    ("spread", Spread, 1, usize::MAX),
    ("slope", Slope, 1, 1),
    ("r2", RSquared, 1, 1),
    ("growth", Growth, 1, 1),
    ("spearman", Spearman, 2, 2),
    ("ln", Ln, 1, 1),
    ("exp", Exp, 1, 1),
    ("sqrt", Sqrt, 1, 1),
    ("abs", Abs, 1, 1),
    ("square", Square, 1, 1),
];

impl Function {
    /// The function of a name.
    pub fn find(name: &str) -> Option<Self> {
        ALL.iter().find(|(own, ..)| *own == name).map(|(_, function, ..)| *function)
    }

    /// All names, for messages.
    pub fn names() -> String {
        ALL.map(|(name, ..)| name).join(", ")
    }

    /// Whether it takes so many arguments; the error says how many it does.
    pub fn accepts(self, count: usize) -> Result<(), String> {
        let arity = ALL.iter().find(|(_, own, ..)| *own == self);
        let (fewest, most) = arity.map_or((0, 0), |(.., fewest, most)| (*fewest, *most));
        if (fewest..=most).contains(&count) {
            return Ok(());
        }
        let more = if most > fewest { " or more" } else { "" };
        Err(format!("{fewest}{more}"))
    }

    /// Whether it picks among its figures by their size. Which one is picked is itself a matter of
    /// chance, so all of them must lie within their intervals at once for the result to do so.
    pub fn selects(self) -> bool {
        matches!(self, Min | Max | Median | Spread | Spearman)
    }
}
