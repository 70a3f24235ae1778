//! The right-hand side of Andrews' squeezing mechanism, by hand: a crank and three dyads, reduced to the crank.

/// A complex number, for a vector of the plane and for a constant turn with a factor.
type C = [f64; 2];

#[inline(always)]
fn times(a: C, b: C) -> C {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

#[inline(always)]
fn dot(a: C, b: C) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

#[inline(always)]
fn plus(a: C, b: C) -> C {
    [a[0] + b[0], a[1] + b[1]]
}

#[inline(always)]
fn minus(a: C, b: C) -> C {
    [a[0] - b[0], a[1] - b[1]]
}

#[inline(always)]
fn scaled(k: f64, a: C) -> C {
    [k * a[0], k * a[1]]
}

#[inline(always)]
fn perp(a: C) -> C {
    [-a[1], a[0]]
}

/// Place of a point and its two derivatives with respect to the crank's angle.
#[derive(Clone, Copy)]
struct Point {
    place: C,
    first: C,
    second: C,
}

/// A link of a dyad: from its outer pin to the inner one, and the derivatives of its angle.
#[derive(Clone, Copy)]
struct Link {
    r: C,
    w: f64,
    e: f64,
}

/// Two links between a moving pin and a ground pin.
#[inline(always)]
fn dyad(from: &Point, ground: C, [l1, l2]: [f64; 2], side: f64) -> [Link; 2] {
    let d = minus(ground, from.place);
    let square = dot(d, d);
    let (sum, difference) = (l1 + l2, l1 - l2);
    let root = 0.5 * side * ((sum * sum - square) * (square - difference * difference)).sqrt();
    let inverse = 1.0 / square;
    let part = 0.5 + 0.5 * (sum * difference) * inverse;
    let r1 = plus(scaled(part, d), scaled(root * inverse, perp(d)));
    let r2 = minus(r1, d);
    let inverse = 1.0 / root;
    let (w1, w2) = (-dot(from.first, r2) * inverse, -dot(from.first, r1) * inverse);
    let a = minus(minus(scaled(w1 * w1, r1), scaled(w2 * w2, r2)), from.second);
    [Link { r: r1, w: w1, e: dot(a, r2) * inverse }, Link { r: r2, w: w2, e: dot(a, r1) * inverse }]
}

/// J and half of dJ/dq of a link that is carried by a moving pin: `part` of its length lies between pin and center.
#[inline(always)]
fn carried(pin: &Point, link: &Link, part: f64, mass: f64, inertia: f64) -> [f64; 2] {
    let arm = scaled(part, link.r);
    let v = plus(pin.first, scaled(link.w, perp(arm)));
    let a = minus(plus(pin.second, scaled(link.e, perp(arm))), scaled(link.w * link.w, arm));
    [mass * dot(v, v) + inertia * link.w * link.w, mass * dot(v, a) + inertia * link.w * link.e]
}

const A: C = [-0.06934, -0.00227];
const B: C = [-0.03635, 0.03273];
const SPRING: C = [0.014, 0.072];

/// Moments of inertia about the ground pins of K1, K3, K5, K7.
const PINNED: [f64; 4] = [
    2.194e-6 + 0.04325 * 0.00092 * 0.00092,
    5.255e-6 + 0.02373 * (0.01043 * 0.01043 + 0.01874 * 0.01874),
    1.169e-5 + 0.07050 * (0.02308 * 0.02308 + 0.00916 * 0.00916),
    1.912e-5 + 0.05498 * (0.00449 * 0.00449 + 0.01228 * 0.01228),
];

/// The acceleration of the crank at an angle and a speed, rad/s².
#[inline(never)]
pub(crate) fn by_hand(angle: f64, speed: f64) -> f64 {
    let (s, c) = angle.sin_cos();
    let crank = scaled(0.007, [c, s]);
    let f = Point { place: crank, first: perp(crank), second: scaled(-1.0, crank) };
    let [k2, k3] = dyad(&f, B, [0.028, 0.035], 1.0);
    let e = Point {
        place: plus(B, k3.r),
        first: scaled(k3.w, perp(k3.r)),
        second: minus(scaled(k3.e, perp(k3.r)), scaled(k3.w * k3.w, k3.r)),
    };
    let [k4, k5] = dyad(&e, A, [0.02, 0.04], -1.0);
    let [k6, k7] = dyad(&e, A, [0.02, 0.04], 1.0);
    let parts = [
        carried(&f, &k2, 0.0115 / 0.028, 0.00365, 4.410e-7),
        carried(&e, &k4, 0.7105, 0.00706, 5.667e-7),
        carried(&e, &k6, 0.7105, 0.00706, 5.667e-7),
    ];
    let pinned = [(PINNED[1], k3), (PINNED[2], k5), (PINNED[3], k7)];
    let (mut inertia, mut half) = (PINNED[0], 0.0);
    for [own, slope] in parts {
        inertia += own;
        half += slope;
    }
    for (own, link) in pinned {
        inertia += own * link.w * link.w;
        half += own * link.w * link.e;
    }
    // D on K3: (0.02, -0.018) where E is (0, -0.035).
    let arm = times(k3.r, [0.018 / 0.035, 0.02 / 0.035]);
    let between = minus(plus(B, arm), SPRING);
    let length = dot(between, between).sqrt();
    let tension = 4530.0 * (length - 0.07785) / length;
    let moment = 0.033 - tension * k3.w * dot(between, perp(arm));
    (moment - half * speed * speed) / inertia
}
