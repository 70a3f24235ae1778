//! Known cases, and random systems against Newton's method from very many starting points.

use proptest::prelude::*;

use crate::moduli::length;
use crate::steps::Steps;
use crate::unique::SLOPE;
use crate::{Moduli, Sum, Unique, Width, spectral_radius};

/// Numbers in (-1, 1), one after the other.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 32).unwrap_or(0)) / f64::from(1_u32 << 31) - 1.0
    }
}

fn random(widths: &[Width], strength: f64, dice: &mut Dice) -> Moduli {
    let mut vector = |width: Width, size: f64| {
        let [x, y] = [dice.next(), dice.next()];
        [size * x, if width == Width::Two { size * y } else { 0.0 }]
    };
    let constants = widths.iter().map(|&width| vector(width, 100.0)).collect();
    let slopes =
        widths.iter().map(|&width| widths.iter().map(|_| vector(width, strength)).collect()).collect();
    Moduli { widths: widths.to_vec(), constants, slopes }
}

/// Solutions to which Newton's method leads from many magnitudes of all sizes.
fn by_trial(system: &Moduli, dice: &mut Dice) -> Vec<Vec<f64>> {
    let mut found: Vec<Vec<f64>> = Vec::new();
    for _ in 0..600 {
        let start: Vec<f64> = (0..system.count()).map(|_| 100.0 * (6.0 * dice.next()).exp()).collect();
        let Some(z) = Steps::new(system).newton(&start) else { continue };
        let size = z.iter().fold(1e-300, |most: f64, z| most.max(*z));
        let far = |known: &Vec<f64>| known.iter().zip(&z).any(|(a, b)| (a - b).abs() > 1e-7 * size);
        if found.iter().all(far) {
            found.push(z);
        }
    }
    found
}

const SORTS: [&[Width]; 9] = [
    &[Width::Two],
    &[Width::One, Width::One],
    &[Width::Two, Width::Two],
    &[Width::One, Width::Two, Width::Two],
    &[Width::One, Width::One, Width::Two, Width::Two],
    &[Width::One, Width::One, Width::Two],
    &[Width::One, Width::One, Width::One, Width::One, Width::Two],
    &[Width::Two, Width::Two, Width::Two],
    &[Width::One, Width::Two, Width::Two, Width::Two],
];

#[test]
fn a_drawer_jams_where_the_coefficient_is_the_length_over_twice_the_offset() {
    // Pulled by F at a distance a against a load Q: N1 = F a / L = -N2, F = Q + f (|N1| + |N2|).
    let (load, length, offset) = (100.0, 0.3, 0.4);
    let drawer = |f: f64| {
        let w = offset / length;
        let row = vec![[f * w, 0.0]; 2];
        Moduli { widths: vec![Width::One; 2], constants: vec![[load * w, 0.0]; 2], slopes: vec![row; 2] }
    };
    let limit = length / (2.0 * offset);
    for part in [0.1, 0.9, 0.999_999] {
        let f = part * limit;
        let found = drawer(f).solutions();
        assert!(found.complete && found.points.len() == 1, "{found:?}");
        let exact = load * offset / length / (1.0 - part);
        assert!((found.points[0][0] / exact - 1.0).abs() < 1e-9 / (1.0 - part), "{found:?}");
        assert!((drawer(f).certificate() - part).abs() < 1e-12);
    }
    for f in [1.000_001 * limit, 3.0 * limit] {
        let found = drawer(f).solutions();
        assert!(found.complete && found.points.is_empty(), "{found:?}");
    }
}

#[test]
fn a_journal_has_the_roots_of_its_quadratic() {
    // z = |c + v z| with c along x: two roots where v points back and is longer than 1, none where it points on.
    let journal =
        |v: [f64; 2]| Moduli { widths: vec![Width::Two], constants: vec![[1.0, 0.0]], slopes: vec![vec![v]] };
    let two = journal([-1.25, 0.0]).solutions();
    let mut roots: Vec<f64> = two.points.iter().map(|z| z[0]).collect();
    roots.sort_by(f64::total_cmp);
    // 1 - 1.25 z = z and 1.25 z - 1 = z.
    assert!(two.complete && roots.len() == 2, "{two:?}");
    assert!((roots[0] - 1.0 / 2.25).abs() < 1e-14 && (roots[1] - 4.0).abs() < 1e-13, "{roots:?}");
    assert!(journal([1.25, 0.0]).solutions().points.is_empty());
    assert_eq!(journal([0.3, 0.4]).solutions().points.len(), 1);
}

#[test]
fn parts_are_solved_one_after_the_other() {
    // The journal above, whose roots 1/2.25 and 4 load five pins, each of them with the friction of the one before: more at once than
    // algebra solves. Responses to loads elsewhere are zero but for rounding.
    let n = 6;
    let mut slopes = vec![vec![[1e-16, -1e-17]; n]; n];
    slopes[0][0] = [-1.25, 0.0];
    (1..n).for_each(|j| slopes[j][j - 1] = [0.0, 0.5]);
    let mut constants = vec![[3.0, 0.0]; n];
    constants[0] = [1.0, 0.0];
    let system = Moduli { widths: vec![Width::Two; n], constants, slopes };
    let mut found = system.solutions();
    found.points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert!(found.complete && found.points.len() == 2, "{found:?}");
    for (point, root) in found.points.iter().zip([1.0 / 2.25, 4.0]) {
        let mut z = root;
        for found in point {
            assert!((found - z).abs() < 1e-12, "{point:?}");
            z = 3_f64.hypot(0.5 * z);
        }
    }
    // The small root is on the path from no friction, the great one is not.
    let near = |i: usize| system.near(&found.points[i]);
    assert!(near(0).is_some() && near(1).is_none());
}

#[test]
fn a_wedge_at_the_angle_of_friction_has_a_continuum() {
    // z = |1 - z| has one solution, z = |0 + z| a ray of them that begins at zero.
    let slide = |a: f64, w: f64| Moduli {
        widths: vec![Width::One],
        constants: vec![[a, 0.0]],
        slopes: vec![vec![[w, 0.0]]],
    };
    let one = slide(1.0, -1.0).solutions();
    assert_eq!((one.points, one.continuum), (vec![vec![0.5]], false));
    let ray = slide(0.0, 1.0).solutions();
    assert_eq!((ray.points, ray.continuum), (vec![vec![0.0]], true));
    assert!(slide(1.0, 1.0).solutions().points.is_empty());
}

#[test]
fn spectral_radii_are_known_ones() {
    let near = |matrix: &[Vec<f64>], radius: f64| {
        let found = spectral_radius(matrix);
        assert!((found - radius).abs() <= 1e-12 * radius.max(1.0), "{found} instead of {radius}");
    };
    near(&[vec![0.3]], 0.3);
    near(&[vec![0.0, 4.0], vec![1.0, 0.0]], 2.0);
    near(&[vec![0.0, 7.0], vec![0.0, 0.0]], 0.0);
    near(&[vec![0.5, 7.0], vec![0.0, 0.5]], 0.5);
    near(&[vec![0.0, 1.0, 0.0], vec![0.0, 0.0, 1.0], vec![1.0, 0.0, 0.0]], 1.0);
    near(&[vec![2.0, 1.0, 1.0], vec![1.0, 2.0, 1.0], vec![1.0, 1.0, 2.0]], 4.0);
    near(&[], 0.0);
}

#[test]
fn several_solutions_occur_with_pins_alone() {
    let mut dice = Dice(5);
    let counts: Vec<usize> = (0..300)
        .map(|_| random(&[Width::Two, Width::Two, Width::Two], 2.0, &mut dice).solutions().points.len())
        .collect();
    for count in [0, 1, 2] {
        assert!(counts.contains(&count), "none of 300 systems has {count} solutions");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { max_global_rejects: 2, ..ProptestConfig::with_cases(80) })]

    #[test]
    fn all_solutions_are_those_that_trial_finds(seed: u64, sort in 0..SORTS.len(), strength in 0.05..3.0_f64) {
        let mut dice = Dice(seed);
        let system = random(SORTS[sort], strength, &mut dice);
        let found = system.solutions();
        for z in &found.points {
            prop_assert!(Steps::new(&system).residual(z) < 1e-10 && z.iter().all(|z| *z >= 0.0), "{z:?}");
        }
        // Close to a double root it says that some may be missing; of random systems hardly one is such.
        prop_assume!(found.complete);
        for trial in by_trial(&system, &mut dice) {
            let size = trial.iter().fold(0.0_f64, |most, z| most.max(*z));
            let near = found.points.iter().any(|z| z.iter().zip(&trial).all(|(a, b)| (a - b).abs() <= 1e-6 * size));
            prop_assert!(near, "{trial:?} is missing in {:?}", found.points);
        }
    }

    #[test]
    fn a_certificate_means_one_solution(seed: u64, sort in 0..SORTS.len(), part in 0.01..0.99_f64) {
        let mut system = random(SORTS[sort], 1.0, &mut Dice(seed));
        let radius = system.certificate();
        system.slopes.iter_mut().flatten().flatten().for_each(|w| *w *= part / radius);
        prop_assert!((system.certificate() - part).abs() < 1e-11);
        let found = system.solutions();
        prop_assert_eq!(found.points.len(), 1);
        let followed = system.follow(&vec![0.0; system.count()]).unwrap();
        let size = followed.iter().fold(0.0_f64, |most, z| most.max(*z));
        prop_assert!(found.points[0].iter().zip(&followed).all(|(a, b)| (a - b).abs() <= 1e-9 * size));
        prop_assert_eq!(system.only(), Some(followed));
        system.slopes.iter_mut().flatten().flatten().for_each(|w| *w *= 1.001 / part);
        prop_assert_eq!(system.only(), None);
    }

    #[test]
    fn a_step_approaches_the_solution_by_the_lengths(seed: u64, sort in 0..SORTS.len()) {
        let system = random(SORTS[sort], 0.2, &mut Dice(seed));
        if let Some(z) = system.follow(&vec![0.0; system.count()]) {
            let start: Vec<f64> = z.iter().map(|z| 1.3 * z + 1.0).collect();
            let bound = |j: usize| (0..z.len()).map(|k| length(system.slopes[j][k]) * (start[k] - z[k])).sum::<f64>();
            for (j, new) in system.step(&start).into_iter().enumerate() {
                prop_assert!((new - z[j]).abs() <= bound(j) + 1e-9 * new.abs().max(1.0));
            }
        }
    }
}

/// Most unknowns of a system.
const MOST: usize = 6;

/// The equations in which each vector is an unknown of its own, but those of one component next to each other share one; the same
/// equations with a magnitude each, and the first and last magnitude of each unknown.
fn unique(system: &Moduli) -> (Unique<f64, MOST>, Moduli, Vec<[usize; 2]>) {
    let mut shared = system.clone();
    let mut firsts: Vec<[usize; 2]> = Vec::new();
    for j in 0..system.count() {
        match firsts
            .last_mut()
            .filter(|[first, last]| first == last && system.widths[*first..=j] == [Width::One; 2])
        {
            Some([first, last]) => {
                *last = j;
                shared.slopes.iter_mut().for_each(|row| row[j] = row[*first]);
            }
            None => firsts.push([j, j]),
        }
    }
    let mut small = Unique([Sum::NONE; MOST]);
    for (sum, [first, last]) in small.0.iter_mut().zip(&firsts) {
        sum.is_vector = system.widths[*first] == Width::Two;
        let both = |one: [f64; 2], other: [f64; 2]| if first == last { one } else { [one[0], other[0]] };
        sum.constant = both(shared.constants[*first], shared.constants[*last]);
        for (slope, [k, _]) in sum.slopes.iter_mut().zip(&firsts) {
            *slope = both(shared.slopes[*first][*k], shared.slopes[*last][*k]);
        }
    }
    (small, shared, firsts)
}

/// The first unknowns of a system, which has no more.
fn first<const N: usize>(system: &Unique<f64, MOST>) -> Unique<f64, N> {
    Unique(std::array::from_fn(|i| {
        let Sum { is_vector, constant, slopes } = system.0[i];
        Sum { is_vector, constant, slopes: std::array::from_fn(|k| slopes[k]) }
    }))
}

/// As few unknowns as are enough.
fn solve(system: &Unique<f64, MOST>) -> Option<(f64, Vec<f64>)> {
    let is_empty = |sum: &Sum<f64, MOST>| {
        sum.constant.iter().chain(sum.slopes.iter().flatten()).all(|part| *part == 0.0)
    };
    if system.0[1..].iter().all(is_empty) {
        return first::<1>(system).solve(true).and_then(|(radius, z)| Some((radius?, z.to_vec())));
    }
    if system.0[3..].iter().all(is_empty) {
        return first::<3>(system).solve(true).and_then(|(radius, z)| Some((radius?, z.to_vec())));
    }
    system.solve(true).and_then(|(radius, z)| Some((radius?, z.to_vec())))
}

#[test]
fn small_memory_gives_what_the_careful_method_gives() {
    let mut dice = Dice(5);
    let mut proved = 0;
    for round in 0..800 {
        let sort = SORTS[1 + round % (SORTS.len() - 1)];
        let system = random(sort, [0.02, 0.2, 0.5][round % 3], &mut dice);
        let (small, shared, firsts) = unique(&system);
        let radius = spectral_radius(&shared.lengths());
        let Some((certificate, found)) = solve(&small) else {
            assert!(radius > 0.98, "{radius}");
            continue;
        };
        proved += 1;
        // The rounding of the polynomial over the least slope at which its root is taken.
        let rounding = 4.0 * f64::EPSILON / SLOPE;
        assert!((certificate - radius).abs() < rounding * radius && radius < 1.0, "{certificate} {radius}");
        let z = shared.follow(&vec![0.0; sort.len()]).unwrap();
        let size = z.iter().fold(0.0_f64, |most, z| most.max(*z));
        // Newton's method leaves rounding, which the derivative takes times 1 / (1 - radius) and the spread of its vectors.
        let off = 100.0 * f64::EPSILON * size / (1.0 - radius);
        for (own, [first, last]) in found.iter().zip(firsts) {
            let known: f64 = z[first..=last].iter().sum();
            assert!((own - known).abs() < off, "{found:?} {z:?}");
        }
    }
    assert!(proved > 400, "{proved}");
}

/// Two numbers whose magnitudes depend on each other and on themselves.
fn two(constants: [f64; 2], slopes: [[f64; 2]; 2]) -> Unique<f64, MOST> {
    let mut system = Unique([Sum::NONE; MOST]);
    for ((sum, constant), own) in system.0.iter_mut().zip(constants).zip(slopes) {
        sum.constant[0] = constant;
        sum.slopes.iter_mut().zip(own).for_each(|(slope, own)| slope[0] = own);
    }
    system
}

#[test]
fn unknowns_that_depend_on_each_other_in_turn_have_their_radius() {
    for (to, fro) in [(0.12, 0.006), (0.5, 0.0), (0.0, 0.0), (0.3, 0.3)] {
        let (radius, z) = solve(&two([1.0, 1.0], [[0.0, to], [fro, 0.0]])).unwrap();
        assert!((radius - f64::sqrt(to * fro)).abs() < 1e-15, "{radius}");
        assert!((z[0] - (1.0 + to) / (1.0 - to * fro)).abs() < 1e-15, "{z:?}");
    }
}

#[test]
fn rows_of_zeros_and_no_loads_are_solved_in_small_memory() {
    for (load, row, other, radius) in [
        (3.0, [0.0, 0.0], [0.5, 0.25], 0.25),
        (0.0, [0.1, 0.0], [0.2, 0.3], 0.3),
        (1e-200, [0.0; 2], [0.0; 2], 0.0),
    ] {
        let (certificate, z) = solve(&two([load, 2.0 * load], [row, other])).unwrap();
        assert!((certificate - radius).abs() < 1e-15, "{certificate}");
        let first = load / (1.0 - row[0]);
        let second = (2.0 * load + other[0] * first) / (1.0 - other[1]);
        assert!((z[0] - first).abs() <= 1e-15 * load && (z[1] - second).abs() <= 4e-15 * load, "{z:?}");
    }
}

#[test]
fn one_modulus_keeps_its_digits_next_to_jamming_where_it_does_not_grow() {
    // z = |-1 + w z| with w z below 1: z = 1/(1 + w).
    for left in [0.5, 1e-3, 1e-6, 1e-9, 1e-12] {
        let w: f64 = 1.0 - left;
        let sum = Sum { is_vector: true, constant: [-3.0, 0.0], slopes: [[w, 0.0]] };
        let (_, [z]) = Unique([sum]).solve(true).unwrap();
        assert!((z * (1.0 + w) / 3.0 - 1.0).abs() < 4.0 * f64::EPSILON, "{left}: {z}");
    }
}
