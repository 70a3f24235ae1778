//! Random loads of every kind, a motion, and a balancing load that does not act on the input.

use assur_formula::Formula;
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_mechanism::{
    Balance, Contact, Direction, Force, GROUND, Inertia, Input, LawTable, LinkId, Load, Mechanism, Moment,
    Motion, Over, Place, Point, Range, Shape, Spring, Value, VaryingInertia,
};

use super::draft::Draft;

/// A place whose virtual velocity is less than this fraction of the usual one can't carry the balancing load.
const LIVELY: f64 = 0.15;

/// A force over the stroke of a point needs a stroke of at least this fraction of the region.
const LEAST_TRAVEL: f64 = 0.01;

pub(crate) fn add(draft: &mut Draft, mechanism: &mut Mechanism) {
    if draft.rng.chance(0.75) {
        let sign = mechanism.input.sign();
        let unit = if turns(mechanism) { 1.0 } else { draft.size };
        let speed = sign * draft.rng.range(1.0, 12.0) * unit;
        let acceleration =
            if draft.rng.chance(0.6) { sign * draft.rng.signed(1.0, 60.0) * unit } else { 0.0 };
        mechanism.motion = Some(Motion::Prescribed { speed, acceleration });
    }
    if draft.rng.chance(0.7) {
        let down = [0.0, -9.81];
        let any = [draft.rng.signed(0.0, 9.0), draft.rng.signed(0.0, 9.0)];
        mechanism.gravity = Some(if draft.rng.chance(0.7) { down } else { any });
    }
    for index in 0..draft.rng.below(4) {
        let force = force(draft, mechanism);
        mechanism.loads.push(Load::new(format!("force {index}"), force));
    }
    for index in 0..draft.rng.below(3) {
        let link = moving(draft, mechanism);
        let value = value(draft, mechanism, draft.size, false);
        let moment = Moment { link, value, against_motion: false };
        mechanism.loads.push(Load::new(format!("moment {index}"), moment));
    }
    for index in 0..draft.rng.below(3) {
        let spring = spring(draft, mechanism);
        mechanism.loads.extend(spring.map(|spring| Load::new(format!("spring {index}"), spring)));
    }
    if draft.rng.chance(0.25) {
        let contact = contact(draft, mechanism);
        mechanism.loads.push(Load::new("contact", contact));
    }
    if draft.rng.chance(0.4) {
        mechanism.balance = balance(draft, mechanism);
    }
    varying_inertias(draft, mechanism);
}

/// Loads that neither depend on a coordinate nor on the time: weights, forces, moments, springs with dampers.
pub(crate) fn add_over_time(draft: &mut Draft, mechanism: &mut Mechanism) {
    mechanism.gravity = draft.rng.chance(0.8).then_some([0.7, -9.81]);
    for index in 0..draft.rng.below(3) {
        let link = moving(draft, mechanism);
        let at = place_on(draft, link);
        let direction = match draft.rng.below(3) {
            0 => Direction::AgainstMotion,
            1 => Direction::Link(draft.rng.angle()),
            _ => Direction::Ground(draft.rng.angle()),
        };
        let value = Value::Constant(draft.rng.signed(5.0, 120.0));
        mechanism.loads.push(Load::new(format!("force {index}"), Force { at, direction, value }));
    }
    if draft.rng.chance(0.6) {
        let (link, value) = (moving(draft, mechanism), draft.rng.signed(5.0, 120.0) * draft.size);
        let moment = Moment { link, value: Value::Constant(value), against_motion: false };
        mechanism.loads.push(Load::new("moment", moment));
    }
    let spring = spring(draft, mechanism).filter(|_| draft.rng.chance(0.5));
    mechanism.loads.extend(spring.map(|spring| Load::new("spring", spring)));
}

/// The moments of inertia of some links that are pinned to the ground vary with the coordinate.
fn varying_inertias(draft: &mut Draft, mechanism: &mut Mechanism) {
    let is_pinned = |link: LinkId| {
        let stands = |point: &Point, link| point.places.iter().any(|place| place.link == link);
        mechanism.points.iter().any(|point| stands(point, GROUND) && stands(point, link))
    };
    let pinned: Vec<_> = (1..mechanism.links.len()).map(is_pinned).collect();
    let unit = if turns(mechanism) { 1.0 } else { 1.0 / draft.size };
    for (link, _) in mechanism.links.iter_mut().skip(1).zip(pinned).filter(|(_, pinned)| *pinned) {
        let inertia = link.inertia.constant();
        if inertia <= 0.0 || !draft.rng.chance(0.3) {
            continue;
        }
        let [swing, waves, phase] = [
            draft.rng.range(0.1, 0.9),
            unit * f64::from(1 + u8::from(draft.rng.chance(0.5))),
            draft.rng.angle(),
        ];
        let text = format!("{inertia:?}*(1 + {swing:?}*cos({waves:?}*q + {phase:?}))");
        if let Ok(formula) = Formula::read(&text) {
            link.inertia = Inertia::Varying(VaryingInertia { formula, factor: 1.0 });
        }
    }
}

fn turns(mechanism: &Mechanism) -> bool {
    mechanism.input.is_angle()
}

fn moving(draft: &mut Draft, mechanism: &Mechanism) -> LinkId {
    1 + draft.rng.below(mechanism.links.len() - 1)
}

fn place_on(draft: &mut Draft, link: LinkId) -> Place {
    let at = [draft.rng.signed(0.0, 0.6) * draft.size, draft.rng.signed(0.0, 0.6) * draft.size];
    Place { link, at }
}

fn force(draft: &mut Draft, mechanism: &Mechanism) -> Force {
    let link = moving(draft, mechanism);
    let at = place_on(draft, link);
    let direction = match draft.rng.below(3) {
        0 if mechanism.motion.is_some() => Direction::AgainstMotion,
        1 => Direction::Link(draft.rng.angle()),
        _ => Direction::Ground(draft.rng.angle()),
    };
    let value = match value(draft, mechanism, 1.0, true) {
        Value::Stroke { axis, forward, .. } if travel(mechanism, at, axis) < LEAST_TRAVEL * draft.size => {
            Value::Constant(forward.rows[1][1])
        }
        value => value,
    };
    Force { at, direction, value }
}

/// Stroke of a point along an axis, m.
fn travel(mechanism: &Mechanism, at: Place, axis: f64) -> f64 {
    let Ok(linkage) = Linkage::compile(mechanism.clone()) else { return 0.0 };
    let mut position = linkage.position();
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for index in 0..mechanism.input.positions {
        if linkage.solve_index(index, Order::Place, &mut position).is_err() {
            return 0.0;
        }
        let [x, y] = position.bodies[at.link].point(at.at);
        let along = axis.cos() * x + axis.sin() * y;
        (low, high) = (low.min(along), high.max(along));
    }
    high - low
}

/// A random magnitude of up to about 100 N (times `unit`), constant or by a table.
fn value(draft: &mut Draft, mechanism: &Mechanism, unit: f64, point: bool) -> Value {
    let mut size = || draft.rng.signed(5.0, 120.0) * unit;
    let sizes = [size(), size(), size(), size()];
    let shape = if draft.rng.chance(0.7) { Shape::Linear } else { Shape::Step };
    let table = |from: f64, step: f64| {
        let rows = [0.0, 1.0, 2.0, 2.0].iter().zip(sizes).map(|(k, y)| [from + k * step, y]).collect();
        LawTable { rows, shape }
    };
    let input = &mechanism.input;
    // Odd steps avoid a position on a jump, where two values are right.
    match (draft.rng.below(6), mechanism.motion.as_ref(), input.period()) {
        (0, _, period) => {
            let step = period.unwrap_or(draft.size) * 0.273_1;
            let repeat = period.is_some();
            Value::Table { over: Over::Coordinate, table: table(input.from - 0.317_1 * step, step), repeat }
        }
        (1, Some(_), _) => {
            let table = table(-13.71, 9.37);
            // A step over the speed is read as a line with jumps where the input moves against its coordinate.
            let table = if input.sign() < 0.0 { table.mirrored() } else { table };
            Value::Table { over: Over::Speed, table, repeat: false }
        }
        (2, Some(_), _) => Value::Table { over: Over::Time, table: table(-0.011_3, 0.031_7), repeat: false },
        (3, ..) if point && matches!(input.range, Range::Cycle(_)) => {
            let rows = vec![[0.05, 0.0], [0.05, sizes[0]], [0.95, sizes[1]], [0.95, 0.0]];
            let forward = LawTable { rows, shape };
            Value::Stroke { axis: draft.rng.angle(), forward, back: LawTable::constant(sizes[2]) }
        }
        _ => Value::Constant(sizes[0]),
    }
}

/// A spring between two points that have no common link.
fn spring(draft: &mut Draft, mechanism: &Mechanism) -> Option<Spring> {
    let count = mechanism.points.len();
    let (a, b) = (&mechanism.points[draft.rng.below(count)], &mechanism.points[draft.rng.below(count)]);
    let common = a.places.iter().any(|p| b.places.iter().any(|q| q.link == p.link));
    let ends = [*draft.rng.pick(&a.places), *draft.rng.pick(&b.places)];
    let damping = if mechanism.motion.is_some() { draft.rng.range(0.0, 20.0) } else { 0.0 };
    let length = draft.rng.range(0.0, 1.0) * draft.size;
    let stiffness = draft.rng.range(10.0, 500.0) / draft.size;
    (!common).then_some(Spring { ends, stiffness, length, damping })
}

fn contact(draft: &mut Draft, mechanism: &Mechanism) -> Contact {
    let link = moving(draft, mechanism);
    let center = place_on(draft, link);
    let force = value(draft, mechanism, 1.0, false);
    let (low, high) = (mechanism.input.from - 0.313_7, mechanism.input.from + 0.271_9);
    let during = draft.rng.chance(0.5).then_some([low, high]);
    Contact {
        center,
        radius: draft.rng.range(0.0, 1.0) * draft.size,
        angle: Value::Constant(draft.rng.signed(0.0, 0.5)),
        force,
        friction: draft.rng.signed(0.0, 0.3),
        against_sliding: false,
        during,
    }
}

/// A random place whose velocity is sufficient in every position; `None` if that of the place drawn is not.
fn balance(draft: &mut Draft, mechanism: &Mechanism) -> Option<Balance> {
    let linkage = Linkage::compile(mechanism.clone()).ok()?;
    let link = moving(draft, mechanism);
    let at = place_on(draft, link);
    let angle = draft.rng.angle();
    let turn = draft.rng.chance(0.5);
    // Derivatives with respect to the coordinate: 1 and a length, or 1/length and 1.
    let (usual_turn, usual_way) = if turns(mechanism) { (1.0, draft.size) } else { (1.0 / draft.size, 1.0) };
    let mut position = linkage.position();
    let input: &Input = &mechanism.input;
    let lively = (0..input.positions).all(|index| {
        if linkage.solve_index(index, Order::First, &mut position).is_err() || link == GROUND {
            return false;
        }
        let (s, c) = angle.sin_cos();
        let pf1 = linkage.place_motion(at, &position).pf1;
        let rate =
            if turn { position.bodies[link].w1 / usual_turn } else { (c * pf1[0] + s * pf1[1]) / usual_way };
        rate.abs() > LIVELY
    });
    let load = if turn { Balance::Moment(link) } else { Balance::Force { at, angle } };
    lively.then_some(load)
}
