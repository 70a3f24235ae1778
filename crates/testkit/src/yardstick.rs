//! For benches: a race of contestants, and formulas that are written by hand for one mechanism with constant lengths.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use assur_number::{Lanes, Real};

/// Positions of one contestant in one round.
const POSITIONS: usize = 1024;

/// A contestant of a race.
pub struct Contestant<'a> {
    name: &'static str,
    call: Box<dyn FnMut() + 'a>,
    /// Least time of a position, s.
    least: f64,
}

impl<'a> Contestant<'a> {
    /// From what it does at one coordinate.
    pub fn one_by_one(name: &'static str, mut position: impl FnMut(f64) + 'a) -> Self {
        let coordinates: Vec<f64> = coordinates().collect();
        let call = Box::new(move || coordinates.iter().for_each(|coordinate| position(*coordinate)));
        Self { name, call, least: f64::INFINITY }
    }

    /// From what it does at eight coordinates.
    pub fn eight_by_eight(name: &'static str, mut positions: impl FnMut(Lanes) + 'a) -> Self {
        let mut all = coordinates();
        let mut next = || Lanes::of(|_| all.next().unwrap_or_default());
        let blocks: Vec<Lanes> = (0..POSITIONS / Lanes::WIDTH).map(|_| next()).collect();
        let call = Box::new(move || blocks.iter().for_each(|block| positions(*block)));
        Self { name, call, least: f64::INFINITY }
    }

    /// From a formula of sine and cosine, evaluated at eight coordinates with the widest instructions of the machine.
    pub fn by_hand_in_lanes<V: 'a>(
        name: &'static str,
        formula: impl Fn([Lanes; 2]) -> V + Copy + 'a,
    ) -> Self {
        Self::eight_by_eight(name, move |coordinates| {
            let mut found = Lanes::evaluate(
                #[inline(always)]
                || {
                    let (s, c) = coordinates.sin_cos();
                    formula([s, c])
                },
            );
            black_box(&mut found);
        })
    }
}

/// Coordinates spread over one turn in an order that can't be guessed.
pub fn coordinates() -> impl Iterator<Item = f64> {
    let golden = |index: usize| (index as f64 * 0.618_033_988_749_894_9).fract() * TAU;
    (0..POSITIONS).map(golden)
}

/// Lets all contestants take turns in short rounds, and prints the least time of a position of each, since a shared machine
/// only adds: in ns, as a multiple of the first one's, and of the last one's before it whose name contains "by hand".
pub fn race(mut contestants: Vec<Contestant<'_>>, rounds: usize) {
    for _ in 0..rounds {
        for one in &mut contestants {
            let start = Instant::now();
            (one.call)();
            one.least = one.least.min(start.elapsed().as_secs_f64() / POSITIONS as f64);
        }
    }
    println!("{:40} {:>8} {:>12} {:>12}", "", "ns", "of the first", "of by hand");
    let first = contestants.first().map_or(f64::NAN, |one| one.least);
    let mut by_hand = f64::NAN;
    for Contestant { name, least, .. } in contestants {
        if name.contains("by hand") {
            by_hand = least;
        }
        println!("{name:40} {:8.2} {:12.3} {:12.2}", 1e9 * least, least / first, least / by_hand);
    }
}

/// The slider-crank with a crank of 0.1 m and a rod of 0.35 m, without offset, from sine and cosine of the crank's angle: place
/// of the piston with both derivatives, direction of the rod, both derivatives of its angle, its length along the guide.
#[inline(always)]
pub fn slider_crank<T: Real>([s, c]: [T; 2]) -> [T; 8] {
    let (crank, rod) = (T::from_f64(0.1), T::from_f64(0.35));
    let inverse = T::from_f64(1.0 / 0.35);
    let (x, y) = (crank * c, crank * s);
    let along = (rod * rod - y * y).sqrt();
    let per_along = T::ONE / along;
    let w = -(x * per_along);
    let e = y * (T::ONE + w * w) * per_along;
    let [first, second] = [w * y - y, e * y - w * w * along - x];
    [x + along, first, second, along * inverse, -(y * inverse), w, e, along]
}

/// Positions of the six-bar with a crank of 0.1 m at the origin, a rocker on (0, -0.4 m) guided by a stone on the crank pin,
/// and a ram on y = 0.28 m moved by a stone on the rocker; derivatives with respect to the crank's angle.
#[derive(Debug, Clone, Copy, Default)]
pub struct SixBar<T> {
    /// Direction of the rocker.
    pub direction: [T; 2],
    /// Derivatives of its angle.
    pub turn: [T; 2],
    /// Distance of the crank pin from the rocker's pin, with both derivatives.
    pub along: [T; 3],
    /// Place of the ram, with both derivatives.
    pub ram: [T; 3],
    /// Reciprocals of the distance and of the sine of the rocker's angle.
    pub inverse: [T; 2],
}

/// The [`SixBar`] from sine and cosine of the crank's angle.
#[inline(always)]
pub fn six_bar<T: Real>([s, c]: [T; 2]) -> SixBar<T> {
    let (x, y) = (T::from_f64(0.1) * c, T::from_f64(0.1) * s);
    let up = y + T::from_f64(0.4);
    let height = T::from_f64(0.68);
    let square = x * x + up * up;
    let along = square.sqrt();
    let per_along = along * (T::ONE / square);
    let t = [x * per_along, up * per_along];
    // A' = (-y, x), A'' = (-x, -y); along and across the rocker.
    let [along1, across1] = [x * t[1] - y * t[0], x * t[0] + y * t[1]];
    let [along2, across2] = [-across1, along1];
    let w = across1 * per_along;
    let e = (across2 - (along1 * w).twice()) * per_along;
    let per_sine = T::ONE / t[1];
    let slope = height * per_sine * per_sine;
    let ram2 = -(slope * (e - (w * w * t[0] * per_sine).twice()));
    SixBar {
        direction: t,
        turn: [w, e],
        along: [along, along1, along2 + w * w * along],
        ram: [height * t[0] * per_sine, -(slope * w), ram2],
        inverse: [per_along, per_sine],
    }
}
