//! Time of one solution with PF1 and PF2: alone, eight side by side, and by the general solution.

use assur_group::{
    AssurGroup, Body, Closed, GroupFrame, Number, Order, Pair, PairGeometry, Wrench, derive_generally,
};
use assur_group_rrr::Rrr;
use assur_number::{Lanes, Real};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn frame() -> GroupFrame {
    let pin = |id, a, b, at_a, at_b| Pair { id, a, b, geometry: PairGeometry::Pin { at_a, at_b } };
    GroupFrame {
        links: vec![2, 3],
        inner: vec![pin(1, 2, 3, [0.4, 0.0], [0.35, 0.1])],
        outer: vec![pin(0, 2, 1, [0.0, 0.0], [0.1, 0.0]), pin(2, 3, 0, [0.0, 0.0], [0.5, 0.0])],
        scale: 0.4,
    }
}

/// Ground, a crank that turns about the origin, and the two links.
fn bodies<T: Real>(q: T) -> [Body<T>; 4] {
    let mut bodies = [Body::ground(); 4];
    (bodies[1].s, bodies[1].c) = q.sin_cos();
    bodies[1].w1 = T::ONE;
    bodies
}

fn group<T: Number>() -> Closed<Rrr<T>> {
    Closed(Rrr::new(&frame()).expect("the lengths make a group"))
}

fn solve<T: Number>(bencher: Bencher<'_, '_>, q: T, order: Order) {
    let group: Box<dyn AssurGroup<T>> = Box::new(group::<T>());
    let mut bodies = bodies(q);
    bencher.bench_local(|| group.solve(black_box(&mut bodies), 0, order).is_ok());
}

#[divan::bench(sample_size = 2000)]
fn f64_pf2(bencher: Bencher<'_, '_>) {
    solve(bencher, 0.7_f64, Order::Second);
}

#[divan::bench(sample_size = 2000)]
fn f64_place(bencher: Bencher<'_, '_>) {
    solve(bencher, 0.7_f64, Order::Place);
}

#[divan::bench(sample_size = 2000)]
fn eight_lanes_pf2(bencher: Bencher<'_, '_>) {
    solve::<Lanes>(bencher, Lanes::of(|lane| 0.7 + 0.1 * lane as f64), Order::Second);
}

#[divan::bench(sample_size = 2000)]
fn f64_pf2_by_the_general_solution(bencher: Bencher<'_, '_>) {
    let group = group::<f64>();
    let mut bodies = bodies(0.7);
    bencher.bench_local(|| {
        let placed = group.place(black_box(&mut bodies), 0).is_ok();
        placed && derive_generally(group.frame(), &mut bodies, Order::Second).is_ok()
    });
}

#[divan::bench(sample_size = 2000)]
fn f64_reactions(bencher: Bencher<'_, '_>) {
    let group = group::<f64>();
    let mut bodies = bodies(0.7);
    let placed = group.place(&mut bodies, 0).is_ok();
    let given = [Wrench { fx: 1.0, fy: 2.0, m: 3.0 }; 4];
    let mut reactions = [Wrench::ZERO; 3];
    bencher.bench_local(|| {
        let mut loads = given;
        placed && group.reactions(black_box(&bodies), &mut loads, &mut reactions).is_ok()
    });
}
