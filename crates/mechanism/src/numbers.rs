//! The numbers of a mechanism, one after another, and the one condition that ties some of them together.

use crate::{
    Balance, Brake, Contact, Direction, Drive, Force, Friction, GROUND, Inertia, Input, Link, LinkId, Load,
    LoadKind, Mechanism, Moment, Motion, MotorChoice, Place, Point, Range, RatedMotor, Slide, Solve, Spring,
    Surfaces, Torque, Value,
};

/// Pins nearer than this, relative to the greatest coordinate of the mechanism, coincide.
const SAME_PLACE: f64 = 1e-12;

impl Mechanism {
    /// Visits the numbers that may be changed one by one, always in the same order: lengths, masses, directions,
    /// constant loads, speeds, and what else has only bounds of its own.
    ///
    /// Only numbers whose bound depends on no other number are visited, so that a value between two admissible ones is
    /// admissible. Left out are counts, the rows of tables, ends of ranges, and pairs such as the two speeds of a motor.
    /// The one exception are the coordinates of pins: see [`links_of_length_zero`].
    pub fn visit_numbers(&mut self, mut visit: impl FnMut(&mut f64)) {
        let Self {
            title: _,
            links,
            points,
            slides,
            input,
            assembly,
            gravity,
            loads,
            frictions,
            balance,
            motion,
            drive,
            output: _,
            notes: _,
        } = self;
        let visit = &mut visit;
        for Link { name: _, mass, center, inertia } in links {
            // A formula of its own has no number that may be changed alone.
            let inertia = if let Inertia::Constant(inertia) = inertia { Some(inertia) } else { None };
            std::iter::once(mass).chain(inertia).chain(center).for_each(&mut *visit);
        }
        for Point { name: _, places } in points {
            for place in places {
                in_place(place, visit);
            }
        }
        for Slide { name: _, link: _, on: _, point, through, angle, tilt } in slides {
            point.iter_mut().chain(through).chain([angle, tilt]).for_each(&mut *visit);
        }
        in_input(input, visit);
        assembly.iter_mut().flat_map(|(_, at)| at).for_each(&mut *visit);
        gravity.iter_mut().flatten().for_each(&mut *visit);
        for Load { name: _, kind } in loads {
            in_load(kind, visit);
        }
        for friction in frictions {
            in_friction(friction, visit);
        }
        if let Some(Balance::Force { at, angle }) = balance {
            in_place(at, visit);
            visit(angle);
        }
        if let Some(motion) = motion {
            in_motion(motion, visit);
        }
        if let Some(drive) = drive {
            in_drive(drive, visit);
        }
    }
}

fn in_load(kind: &mut LoadKind, visit: &mut impl FnMut(&mut f64)) {
    match kind {
        LoadKind::Force(Force { at, direction, value }) => {
            in_place(at, visit);
            match direction {
                Direction::Ground(angle) | Direction::Link(angle) => visit(angle),
                Direction::AgainstMotion => {}
            }
            in_value(value, visit);
        }
        LoadKind::Moment(Moment { link: _, value }) => in_value(value, visit),
        LoadKind::Brake(Brake { link: _, force, radius, friction, lever }) => {
            in_value(force, visit);
            [radius, friction, lever].into_iter().for_each(visit);
        }
        LoadKind::Spring(Spring { ends, stiffness, length, damping }) => {
            for end in ends {
                in_place(end, visit);
            }
            [stiffness, length, damping].into_iter().for_each(visit);
        }
        LoadKind::Contact(contact) => {
            let Contact { center, radius, angle, force, friction, against_sliding: _, during: _ } = contact;
            in_place(center, visit);
            [radius, friction].into_iter().for_each(&mut *visit);
            for value in [angle, force] {
                in_value(value, visit);
            }
        }
    }
}

fn in_friction(Friction { pair: _, coefficient, surfaces }: &mut Friction, visit: &mut impl FnMut(&mut f64)) {
    visit(coefficient);
    match surfaces {
        Surfaces::Journal { radius, owner: _ } => visit(radius),
        Surfaces::Place => {}
        Surfaces::Faces { length, middle: _, offset } => [length, offset].into_iter().for_each(visit),
    }
}

fn in_place(Place { link: _, at }: &mut Place, visit: &mut impl FnMut(&mut f64)) {
    at.iter_mut().for_each(visit);
}

fn in_input(input: &mut Input, visit: &mut impl FnMut(&mut f64)) {
    // The two ends of a range must differ.
    if let Range::Cycle(_) = input.range {
        visit(&mut input.from);
    }
}

fn in_value(value: &mut Value, visit: &mut impl FnMut(&mut f64)) {
    match value {
        Value::Constant(number) | Value::Stroke { axis: number, .. } => visit(number),
        Value::Formula { axis, .. } => axis.iter_mut().for_each(visit),
        Value::Table { .. } => {}
    }
}

fn in_motion(motion: &mut Motion, visit: &mut impl FnMut(&mut f64)) {
    match motion {
        Motion::Prescribed { speed, acceleration } => [speed, acceleration].into_iter().for_each(visit),
        Motion::Transient {
            speed,
            until: _,
            samples: _,
            integrator: _,
            tolerance,
            step: _,
            max_steps: _,
        } => {
            [speed, tolerance].into_iter().for_each(visit);
        }
        Motion::Steady { mean_speed, unevenness } => {
            visit(mean_speed);
            if let Some(Solve::Given(number)) = unevenness {
                visit(number);
            }
        }
    }
}

fn in_drive(drive: &mut Drive, visit: &mut impl FnMut(&mut f64)) {
    let Drive { torque, ratio, efficiency, flywheel, flywheel_on: _ } = drive;
    for number in flywheel.iter_mut().chain([ratio]) {
        if let Solve::Given(number) = number {
            visit(number);
        }
    }
    visit(efficiency);
    match torque {
        Torque::None | Torque::Balance => {}
        Torque::Constant(moment) => visit(moment),
        Torque::Motor { motor, catalogue: _, max_speed, characteristic: _ } => {
            max_speed.iter_mut().for_each(&mut *visit);
            // The rated speed must stay below the synchronous one.
            if let MotorChoice::Rated(RatedMotor { power, max_torque_ratio, inertia, .. }) = motor {
                visit(power);
                max_torque_ratio.iter_mut().chain(inertia).for_each(visit);
            }
        }
    }
}

/// The links without a slide whose pins, two or more, all coincide: such a link turns freely about them, so its angle
/// is not determined.
pub fn links_of_length_zero(links: usize, points: &[Point], slides: &[Slide]) -> Vec<LinkId> {
    let places = || points.iter().flat_map(|point| &point.places);
    let greatest = places().flat_map(|place| place.at).fold(0.0, |most: f64, x| most.max(x.abs()));
    // By link: the place of its first pin, how many pins it has, and whether all are at that place.
    let mut pins = vec![([0.0; 2], 0_usize, true); links];
    for place in points.iter().filter(|point| point.is_pin()).flat_map(|point| &point.places) {
        let (first, count, together) = &mut pins[place.link];
        if *count == 0 {
            *first = place.at;
        }
        *count += 1;
        *together &= (place.at[0] - first[0]).hypot(place.at[1] - first[1]) <= SAME_PLACE * greatest;
    }
    let slides_on = |link: LinkId| slides.iter().any(|slide| slide.link == link || slide.on == link);
    let zero = |link: &LinkId| {
        let (_, count, together) = pins[*link];
        count > 1 && together && !slides_on(*link)
    };
    (GROUND + 1..links).filter(zero).collect()
}
