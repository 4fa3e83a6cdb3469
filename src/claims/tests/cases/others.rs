//! Thesis H, the lecture and the coursebook.

use super::{Case, case};
use crate::claims::Verdict;

/// In the order of the ledger.
pub const CASES: &[Case] = &[
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
    // Ten times the triangles take ten times as long, and in a hierarchy as much more as they have digits.
    case(
        "H-6.2",
        &[
            ("list", "1000", 1e3),
            ("list", "100000", 1e5),
            ("time", "surface|kd-tree/100", 2.0),
            ("time", "surface|kd-tree/100000", 5.0),
            ("volumes", "1000", 30.0),
            ("volumes", "100000", 49.0),
            ("tests", "1000|100000", 3.0),
        ],
        &[("time", "kd-tree/100000", 50.0)],
    ),
    case(
        "L-1",
        &[("ratio", "icosphere/20/wald", 2.0), ("ratio", "icosphere/320/wald", 30.0)],
        &[("ratio", "icosphere/320/wald", 15.0)],
    ),
    case(
        "L-2",
        &[("agrees", "box|sphere/8|128/1|4", 1.0), ("time", "100", 1e2), ("time", "1000", 1e3)],
        &[("agrees", "box/128/4", 0.0)],
    ),
    case(
        "L-3",
        &[("error", "soup|terrain", 3.0), ("pairs", "soup|terrain", 100.0)],
        &[("error", "terrain", 7.0)],
    ),
    case(
        "L-4",
        &[("volumes", "soup|terrain/as given", 20.0), ("volumes", "soup|terrain/along x", 30.0)],
        &[("volumes", "terrain/along x", 20.0)],
    ),
    case(
        "L-5",
        &[
            ("cells", "soup|terrain/grid", 17.0),
            ("cells", "soup|terrain/octree", 13.0),
            ("cells", "soup|terrain/kd-tree", 7.0),
        ],
        &[("cells", "terrain/kd-tree", 14.0)],
    ),
    case("C-1", &[("time", "lanes/a", 1.0)], &[("time", "packets/b", 0.01)]),
];
