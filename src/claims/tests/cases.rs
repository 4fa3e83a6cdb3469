//! For every claim that can be tested figures with which it holds, and a change that undoes it.

use super::made::Cells;
use crate::claims::Verdict;

/// Figures with a known answer.
pub struct Case {
    /// The claim.
    pub id: &'static str,
    /// Figures with which all its parts hold.
    pub holds: Cells,
    /// What is changed so that one does not.
    pub change: Cells,
    /// The verdict of the first.
    pub first: Verdict,
    /// The verdict with the change.
    pub changed: Verdict,
}

const fn case(id: &'static str, holds: Cells, change: Cells) -> Case {
    Case { id, holds, change, first: Verdict::Reproduced, changed: Verdict::NotReproduced }
}

/// All cases, in the order of the ledger.
pub const CASES: &[Case] = &[
    case(
        "B-4.1a",
        &[("moller0", "0|1", 1.15), ("moller1", "0|1", 1.0), ("moller3", "0|1", 1.04)],
        &[("moller3", "0|1", 0.9)],
    ),
    case("B-4.1b", &[("moller3", "0", 1.1), ("moller3", "1", 0.97)], &[("moller3", "1", 1.2)]),
    case(
        "B-4.1c",
        &[("moller3", "0|0.25|0.5|0.75", 1.05), ("moller3", "1", 0.95)],
        &[("moller3", "0.5", 0.9)],
    ),
    case(
        "B-4.2a",
        &[("moller", "0|1", 1.1), ("badouel", "0|1", 1.4), ("chirkov", "0|1", 1.0)],
        &[("chirkov", "0|1", 1.2)],
    ),
    case("B-4.2b", &[("chirkov", "0", 1.0), ("chirkov", "1", 0.9)], &[("chirkov", "1", 1.1)]),
    case(
        "B-4.2c",
        &[
            ("moller", "0", 1.0),
            ("moller", "0.5", 1.25),
            ("moller", "1", 1.5),
            ("badouel", "0", 1.0),
            ("badouel", "0.5", 1.25),
            ("badouel", "1", 1.5),
            ("chirkov", "0", 1.0),
            ("chirkov", "0.5", 1.25),
            ("chirkov", "1", 1.5),
        ],
        &[("moller", "0.5", 1.6)],
    ),
    case(
        "B-4.3",
        &[
            ("moller", "AMD 1/0|1", 1.1),
            ("moller", "Intel 1/0|1", 0.9),
            ("chirkov", "AMD 1|Intel 1/0|1", 1.0),
        ],
        &[("moller", "Intel 1/0|1", 1.1)],
    ),
    case(
        "B-4.3b",
        &[
            ("moller", "AMD 1|AMD 2|Intel 1|Intel 2/0|1", 1.0),
            ("badouel", "AMD 1|AMD 2|Intel 1|Intel 2/0|1", 1.5),
        ],
        &[("badouel", "AMD 2/0|1", 1.7)],
    ),
    case(
        "B-4.4",
        &[("price", "AMD 1", 0.2), ("price", "Intel 1", 0.1)],
        &[("price", "Intel 1", 0.3)],
    ),
    case(
        "B-4.5",
        &[
            ("pairs", "", 1e6),
            ("share", "0", 0.121),
            ("share", "1", 0.318),
            ("share", "2", 0.121),
            ("share", "3", 0.319),
            ("share", "4", 0.121),
        ],
        &[("share", "1", 0.33)],
    ),
    case(
        "B-4.5t",
        &[
            ("time", "0", 1.0),
            ("time", "1", 0.6),
            ("time", "2", 0.8),
            ("time", "3", 0.65),
            ("time", "4", 0.9),
            ("time", "5", 0.4),
        ],
        &[("time", "1", 0.95)],
    ),
    case(
        "B-4.5m",
        &[
            ("time", "0", 10.0),
            ("time", "1", 5.0),
            ("share", "0", 0.2),
            ("share", "1", 0.8),
            ("measured", "0", 5.0),
            ("measured", "0.5", 7.5),
            ("measured", "1", 10.0),
        ],
        &[("measured", "0.5", 9.0)],
    ),
    case(
        "B-4.5c",
        &[("code", "0", 10.0), ("code", "1", 8.0), ("density", "0", 8.0), ("density", "1", 10.0)],
        &[("density", "1", 11.0)],
    ),
    case(
        "B-4.5d",
        &[
            ("price", "moller1/dot|cross|difference", 0.1),
            ("price", "moller1/division", 0.02),
            ("price", "moller1/condition", 0.3),
            ("price", "badouel|chirkov-line/dot", 0.1),
            ("price", "badouel/division", 0.1),
            ("price", "chirkov-line/division", 0.03),
            ("price", "badouel|chirkov-line/condition", 0.2),
        ],
        &[("price", "moller1/dot", 0.5)],
    ),
    case(
        "B-4.6",
        &[("moller", "0|1", 1.0), ("badouel", "0|1", 1.3), ("chirkov", "0|1", 1.15)],
        &[("chirkov", "0|1", 0.9)],
    ),
    case(
        "B-4.6b",
        &[
            ("without", "moller1|badouel|chirkov-line/0|0.5|1", 1.0),
            ("with", "moller1|badouel/0|0.5|1", 1.01),
            ("with", "chirkov-line/0|0.5|1", 1.3),
        ],
        &[("with", "moller1/0|0.5|1", 1.2)],
    ),
    case(
        "B-4.7",
        &[
            ("pairs", "", 1e6),
            ("share", "0", 0.121),
            ("share", "2", 14e-6),
            ("share", "3", 0.637),
            ("share", "4", 0.242),
        ],
        &[("share", "2", 3e-4)],
    ),
    case(
        "B-4.7t",
        &[("rare", "1", 0.1), ("time", "2", 0.6), ("time", "3", 0.7), ("time", "4", 0.9)],
        &[("time", "4", 1.1)],
    ),
    case(
        "B-4.9",
        &[
            ("add", "moller1/0", 9.0),
            ("add", "moller1/1", 4.0),
            ("add", "badouel/0", 8.0),
            ("add", "chirkov-line/0", 11.0),
            ("sub", "moller1/0", 15.0),
            ("sub", "badouel/0", 9.0),
            ("sub", "chirkov-line/0", 19.0),
            ("neg", "moller1|chirkov-line/0", 1.0),
            ("neg", "badouel/0", 2.0),
            ("mul", "moller1/0", 25.0),
            ("mul", "badouel/0", 13.0),
            ("mul", "chirkov-line/0", 29.0),
            ("div", "moller1|chirkov-line/0", 1.0),
            ("div", "badouel/0", 3.0),
            ("condition", "moller1|badouel/0", 4.0),
            ("condition", "chirkov-line/0", 2.0),
        ],
        &[("mul", "badouel/0", 14.0)],
    ),
    case(
        "B-6",
        &[("bytes", "moller1", 36.0), ("bytes", "badouel|chirkov-line", 64.0)],
        &[("bytes", "moller1", 100.0)],
    ),
    case(
        "H-4.a",
        &[("time", "moller-trumbore", 1.0), ("time", "kensler-shirley|keidy", 0.8)],
        &[("time", "keidy", 1.2)],
    ),
    case(
        "H-4.b",
        &[("time", "moller-trumbore|kensler-shirley|keidy/distance|inside", 1.0)],
        &[("time", "keidy/inside", 1.2)],
    ),
    case(
        "H-5.a",
        &[
            ("time", "wald", 1.0),
            ("time", "perpendicular-planes", 0.9),
            ("add|mul", "wald", 10.0),
            ("add|mul", "perpendicular-planes", 15.0),
        ],
        &[("time", "perpendicular-planes", 1.1)],
    ),
    case(
        "H-5.b",
        &[
            ("plain", "a", 1.0),
            ("plain", "b", 1.1),
            ("prepared", "c", 0.5),
            ("prepared", "d", 0.55),
        ],
        &[("plain", "b", 0.2)],
    ),
    case(
        "H-6.a",
        &[
            ("packet", "kensler-shirley", 1.0),
            ("packet", "wald", 0.9),
            ("single", "kensler-shirley", 0.8),
            ("single", "wald", 1.0),
        ],
        &[("packet", "wald", 1.5)],
    ),
    case(
        "H-7.a",
        &[("sse2|avx2", "first/a|b", 1.0), ("sse2|avx2", "last/a|b", 0.8)],
        &[("sse2", "last/b", 1.1)],
    ),
    case(
        "H-7.b",
        &[("sse2|avx2", "first|last/wald|perpendicular-planes", 1.0)],
        &[("avx2", "last/wald", 1.2)],
    ),
    case(
        "H-7.c",
        &[
            ("mul", "wald/first", 10.0),
            ("mul", "wald/last", 15.0),
            ("mul", "perpendicular-planes/first", 15.0),
            ("mul", "perpendicular-planes/last", 21.0),
        ],
        &[("mul", "wald/last", 16.0)],
    ),
    case(
        "H-9.a",
        &[("time", "moller-trumbore|kensler-shirley", 1.0)],
        &[("time", "kensler-shirley", 1.1)],
    ),
    case(
        "H-9.b",
        &[
            ("time", "moller-trumbore|kensler-shirley", 1.0),
            ("time", "keidy", 1.3),
            ("div", "moller-trumbore|kensler-shirley", 1.0),
            ("div", "keidy", 2.0),
            ("mul", "moller-trumbore|kensler-shirley", 28.0),
            ("mul", "keidy", 47.0),
        ],
        &[("div", "keidy", 1.0)],
    ),
    case(
        "H-10.a",
        &[
            ("add", "kensler-shirley", 1.0),
            ("add", "shevtsov", 2.0),
            ("add", "badouel-cramer", 3.0),
            ("add", "wald", 4.0),
            ("add", "perpendicular-planes", 5.0),
            (
                "sub|mul|div",
                "kensler-shirley|shevtsov|badouel-cramer|wald|perpendicular-planes",
                1.0,
            ),
            ("time", "kensler-shirley", 10.0),
            ("time", "shevtsov", 20.0),
            ("time", "badouel-cramer", 30.0),
            ("time", "wald", 40.0),
            ("time", "perpendicular-planes", 50.0),
        ],
        &[("time", "kensler-shirley", 90.0)],
    ),
    case(
        "H-5.1",
        &[("plain", "a", 1.0), ("prepared", "b", 0.6), ("packet", "c/vertices", 0.1)],
        &[("packet", "c/vertices", 0.9)],
    ),
    case(
        "H-5.2",
        &[
            ("division", "first/wald/M1|M2", 1.0),
            ("division", "last/wald/M1", 0.8),
            ("division", "last/wald/M2", 1.0),
            ("full", "wald/M1|M2", 1.0),
            ("full", "perpendicular-planes/M1", 1.0),
            ("full", "perpendicular-planes/M2", 1.2),
        ],
        &[("full", "perpendicular-planes/M2", 1.0)],
    ),
    case("H-5.5a", &[("hits|misses", "h-4/a/fixed", 0.0)], &[("misses", "h-4/a/fixed", 1.0)]),
    case("H-5.5b", &[("error", "wald|keidy", 1e-6)], &[("error", "keidy", 1e-5)]),
    case(
        "H-5.5c",
        &[("t|all", "moller-trumbore", 2.0), ("t|all", "wald", 1.0)],
        &[("all", "wald", 3.0)],
    ),
    case("H-5.5d", &[("error", "wald|keidy", 1e-14)], &[("error", "wald", 1e-15)]),
    case(
        "H-5.5e",
        &[
            ("t", "first/wald/1", 1.0),
            ("t", "first/wald/2", 2.0),
            ("t", "last/wald/1", 1.1),
            ("t", "last/wald/2", 2.2),
            ("level", "wald/sse2|avx2", 1e-7),
        ],
        &[("t", "last/wald/1|2", 9.0)],
    ),
    case(
        "H-5.5f",
        &[
            ("t|b", "wald", 1.0),
            ("t|b", "keidy", 1.5),
            ("stiff", "needle/a", 1.0),
            ("stiff", "needle/b", 1.5),
        ],
        &[("stiff", "needle/b", 9.0)],
    ),
    case(
        "H-6.b",
        &[
            ("early|full|packet|double", "wald", 1.0),
            ("early", "perpendicular-planes", 0.9),
            ("full|packet|double", "perpendicular-planes", 1.0),
        ],
        &[("early", "perpendicular-planes", 1.0)],
    ),
    case(
        "H-6.c",
        &[
            ("plain", "kensler-shirley", 0.8),
            ("plain", "moller-trumbore", 1.0),
            ("prepared", "kensler-shirley", 1.2),
            ("prepared", "wald", 1.0),
        ],
        &[("plain", "kensler-shirley", 1.3)],
    ),
    case(
        "H-6.d",
        &[("early|full|packet", "wald", 1.0), ("early|full|packet", "shevtsov", 0.9)],
        &[("packet", "shevtsov", 1.2)],
    ),
    case(
        "H-6.e",
        &[("time", "keidy/0|1", 0.8), ("time", "half-spaces|signed-areas/0|1", 1.0)],
        &[("time", "keidy/0|1", 1.5)],
    ),
    case("H-mem", &[("bytes", "wald|perpendicular-planes", 48.0)], &[("bytes", "wald", 64.0)]),
    case(
        "H-3.4",
        &[
            ("nearest|lines", "moller-trumbore", 1.0),
            ("nearest", "kensler-shirley|keidy", 0.8),
            ("lines", "kensler-shirley|keidy", 1.2),
        ],
        &[("lines", "keidy", 0.5)],
    ),
    // Right answers show nothing.
    Case {
        changed: Verdict::Undecided,
        ..case(
            "H-3.4.4",
            &[
                ("hits", "early/0.5/fixed", 3.0),
                ("misses", "early/0.5/fixed", 0.0),
                ("others|misses_of_others", "a/0.5/fixed", 0.0),
            ],
            &[("hits", "early/0.5/fixed", 0.0)],
        )
    },
    case(
        "H-4.2.1",
        &[("divide", "a|b|c/full/last", 1.0), ("newton", "a|b|c/full/last", 0.9)],
        &[("newton", "a|b/full/last", 1.2)],
    ),
    case(
        "H-4.2.2",
        &[
            ("general|other", "moller-trumbore|kensler-shirley/vertices", 1.0),
            ("common", "moller-trumbore|kensler-shirley/vertices", 0.8),
            ("parallel", "moller-trumbore|kensler-shirley/vertices", 0.6),
        ],
        &[("parallel", "moller-trumbore|kensler-shirley/vertices", 0.9)],
    ),
    // Half of the statement has no part.
    Case {
        first: Verdict::Undecided,
        ..case(
            "H-4.2.3",
            &[
                ("structures", "moller-trumbore|perpendicular-planes/256|1024", 1.0),
                ("arrays", "moller-trumbore|perpendicular-planes/256|1024", 1.2),
            ],
            &[("arrays", "moller-trumbore/1024", 0.9)],
        )
    },
    case("H-4.2.4", &[("hits|misses", "a/fixed", 0.0)], &[("misses", "a/fixed", 2.0)]),
    case(
        "H-4.3.3",
        &[
            ("time", "badouel", 1.0),
            ("time", "badouel-cramer", 0.8),
            ("divide", "sse2/packet4", 4.0),
            ("multiply", "sse2/packet4", 0.5),
        ],
        &[("divide", "sse2/packet4", 8.0)],
    ),
    case("H-5.0", &[("low", "a", 0.999), ("high", "a", 1.001)], &[("high", "a", 1.1)]),
    case("C-1", &[("time", "a", 1.0)], &[("time", "a", 0.01)]),
];
