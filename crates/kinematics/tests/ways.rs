//! Kinds of groups with more than two ways, whose numbers change over the cycle, are followed by continuity.

use std::f64::consts::{PI, TAU};

use assur_group::PairSort::Pin;
use assur_group::plane::{dot, minus, vector};
use assur_group::{
    Assemblies, AssurGroup, Body, BuildError, Builders, ForceAngle, GroupError, GroupFrame, GroupKind,
    GroupPlugin, Number, Order, Pair, PairGeometry, Pattern, inventory,
};
use assur_kinematics::Linkage;
use assur_number::Real;
use assur_words::Text;

/// The pin of a pair in the frame of one of its bodies.
fn pin(pair: &Pair, body: usize) -> [f64; 2] {
    let PairGeometry::Pin { at_a, at_b } = pair.geometry else { panic!("a slide") };
    if pair.a == body { at_a } else { at_b }
}

/// The inner and the outer pair of a link that has one of each.
fn ends(frame: &GroupFrame, link: usize) -> [&Pair; 2] {
    [&frame.inner, &frame.outer]
        .map(|pairs| pairs.iter().find(|pair| pair.joins(link)).expect("a pair of the link"))
}

/// Where the outer pin of a link is.
fn outer<T: Real>(frame: &GroupFrame, link: usize, bodies: &[Body<T>]) -> [T; 2] {
    let [_, pair] = ends(frame, link);
    let body = pair.other(link);
    bodies[body].point(vector(pin(pair, body)))
}

/// Where circles about `a` and `b` meet: left of the way from a to b, and right of it.
fn circles<T: Real>(a: [T; 2], b: [T; 2], [r, s]: [T; 2]) -> Option<[[T; 2]; 2]> {
    let d = minus(b, a);
    let square = dot(d, d);
    let along = (square + r * r - s * s).half() / square;
    let height = r * r / square - along * along;
    if height.least() < -1e-15 {
        return None;
    }
    let across = height.clamp_negative().sqrt();
    let at = |side: T| [a[0] + along * d[0] - side * d[1], a[1] + along * d[1] + side * d[0]];
    Some([at(across), at(-across)])
}

/// Puts a link with two of its points to two places.
fn put<T: Real>(body: &mut Body<T>, [p, q]: [[f64; 2]; 2], [at_p, at_q]: [[T; 2]; 2]) {
    let (own, there) = (minus(vector::<T>(q), vector(p)), minus(at_q, at_p));
    let square = dot(own, own);
    body.c = dot(own, there) / square;
    body.s = (own[0] * there[1] - own[1] * there[0]) / square;
    let arm = body.arm(vector(p));
    (body.x, body.y) = (at_p[0] - arm[0], at_p[1] - arm[1]);
}

fn length(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[0] - from[0]).hypot(to[1] - from[1])
}

/// The direction along which the places of the inner pin are ordered.
fn order<T: Real>(p: [T; 2]) -> T {
    p[0] * T::from_f64(0.3_f64.cos()) + p[1] * T::from_f64(0.3_f64.sin())
}

/// Whether a number is negative; an error where that differs between the lanes, which are then placed one at a time.
fn is_negative<T: Real>(number: T) -> Result<bool, GroupError> {
    match (number.least() < 0.0, number.greatest() < 0.0) {
        (least, greatest) if least == greatest => Ok(least),
        _ => Err(GroupError::NoAssembly { gap_m: 3.0 }),
    }
}

/// The number of the first way.
fn first_way<T: Real>(a: [T; 2]) -> Result<usize, GroupError> {
    is_negative(a[0]).map(usize::from)
}

/// Two links and three pins. The ways are the two places of the inner pin in their order; they have the numbers 0 and 1, or
/// 1 and 2 where the first outer pin lies left of the origin.
#[derive(Debug)]
struct Sorted(GroupFrame);

impl<T: Real> AssurGroup<T> for Sorted {
    fn frame(&self) -> &GroupFrame {
        &self.0
    }

    fn ways(&self) -> usize {
        3
    }

    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError> {
        let frame = &self.0;
        let links = [frame.links[0], frame.links[1]];
        let own = links.map(|link| {
            let [inner, outer] = ends(frame, link).map(|pair| pin(pair, link));
            [outer, inner]
        });
        let ends = links.map(|link| outer(frame, link, bodies));
        let radii = own.map(|[from, to]| T::from_f64(length(from, to)));
        let mut found = circles(ends[0], ends[1], radii).ok_or(GroupError::NoAssembly { gap_m: 1.0 })?;
        if is_negative(order(found[1]) - order(found[0]))? {
            found.swap(0, 1);
        }
        let index = way.checked_sub(first_way(ends[0])?);
        let inner = *index.and_then(|index| found.get(index)).ok_or(GroupError::NoAssembly { gap_m: 2.0 })?;
        for i in [0, 1] {
            put(&mut bodies[links[i]], own[i], [ends[i], inner]);
        }
        let [u, v] = ends.map(|end| minus(inner, end));
        Ok((u[0] * v[1] - u[1] * v[0]) / (radii[0] * radii[1]))
    }
}

struct SortedKind;
impl GroupKind for SortedKind {
    type Kernel<T: Number> = Sorted;
    fn build<T: Number>(frame: &GroupFrame) -> Result<Sorted, BuildError> {
        Ok(Sorted(frame.clone()))
    }
}

/// The words of an entry of a test.
const TEST: Text = Text::message("a test", Vec::new());

inventory::submit! {
    GroupPlugin {
        name: "sorted",
        kind: "sorted",
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: TEST,
        pattern: Some(Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Pin), (1, Pin)] }),
        rank: 1,
        ways: Assemblies { most: 3, varies: true, words: TEST },
        iterates: false,
        singular: TEST,
        force_angle: ForceAngle::DEFAULT,
        source: TEST,
        builders: Builders::of::<SortedKind>(),
    }
}

fn compiled(text: &str) -> Linkage {
    let mechanism = assur_scene::read("ways", text).unwrap_or_else(|errors| panic!("{errors}"));
    Linkage::compile(mechanism).unwrap_or_else(|error| panic!("{error}"))
}

/// Distance of two angles, rad.
fn apart(a: f64, b: f64) -> f64 {
    ((a - b) - TAU * ((a - b) / TAU).round()).abs()
}

#[test]
fn a_parallelogram_stays_one_whatever_the_numbers_of_its_ways() {
    let linkage = compiled(
        "[ground]\npoints = { O = 0, C = 5 }\n[link.crank]\npoints = { O = 0, A = 2 }\n\
         [link.rod]\npoints = { A = 0, B = 5 }\n[link.rocker]\npoints = { C = 0, B = 2 }\n\
         [input]\nlink = \"crank\"\nfrom = 1.0\n[assembly]\nB = [6.0, 1.7]\n",
    );
    let change_points: Vec<_> = linkage.change_points().copied().collect();
    assert_eq!(change_points.len(), 2);
    assert!(
        (change_points[0].coordinate - PI).abs() < 1e-14 && (change_points[1].coordinate - TAU).abs() < 1e-14
    );
    let mut position = linkage.position();
    let mut seen = std::collections::BTreeSet::new();
    for i in 0..2000 {
        let q = f64::from(i) * 0.0123;
        linkage.solve(q, Order::Second, &mut position).unwrap();
        let (rod, rocker) = (linkage.link_motion(2, &position), linkage.link_motion(3, &position));
        assert!(apart(rod.pf0, 0.0) < 1e-12 && apart(rocker.pf0, q) < 1e-12, "{q}");
        assert!(rod.pf1.abs() < 1e-9 && (rocker.pf1 - 1.0).abs() < 1e-9, "{q}");
        seen.insert(linkage.ways.at(q)[0]);
        // The numbers are those of the kind: the inner pin's place in the order of both.
        let b = [5.0 + 2.0 * q.cos(), 2.0 * q.sin()];
        let a = [2.0 * q.cos(), 2.0 * q.sin()];
        let other = circles(a, [5.0, 0.0], [5.0, 2.0]).unwrap();
        let mirrored = other.into_iter().max_by(|x, y| length(*x, b).total_cmp(&length(*y, b))).unwrap();
        if (order(b) - order(mirrored)).abs() > 1e-6 {
            let number = first_way(a).unwrap() + usize::from(order(b) > order(mirrored));
            assert_eq!(usize::from(linkage.ways.at(q)[0]), number, "{q}");
        }
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), [0, 1, 2]);
}
