//! Thesis B.

use super::{Case, case};

/// In the order of the ledger.
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
            ("share", "1", 0.3175),
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
        "B-5",
        &[
            ("time", "20|320/moller1", 2.0),
            ("time", "20/badouel|chirkov-line", 2.2),
            ("time", "320/badouel|chirkov-line", 3.0),
        ],
        &[("time", "320/badouel|chirkov-line", 2.1)],
    ),
    case(
        "B-6",
        &[("bytes", "moller1", 36.0), ("bytes", "badouel|chirkov-line", 64.0)],
        &[("bytes", "moller1", 100.0)],
    ),
];
