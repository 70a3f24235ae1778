//! Loads, motion and drive as they are given.

use assur_book::{Column, Document, Fact, Table, Unit, link_name, row};
use assur_mechanism::{
    Direction, Drive, Force, LawTable, LinkId, LoadKind, Mechanism, Motion, MotorChoice, Over, Solve, Torque,
    Value,
};
use assur_words::{Text, joined, list, name, text, unit};

use super::Source;
use super::units::{ANGLE, INERTIA, LENGTH, MOMENT, POWER, TURNING};

/// Of a longer table the first rows are shown.
const MOST_ROWS: usize = 12;
/// N.
const NEWTON: &str = "N";

/// Each load: where and how it acts, and the law of its value.
pub fn loads_given(source: &Source<'_>, page: &mut Document) {
    let mechanism = source.mechanism;
    let heads = [text!("head-load"), text!("head-acts"), text!("head-value")].map(Column::of);
    let mut rows = Table::list(text!("report-given-loads"), heads);
    if let Some([x, y]) = mechanism.gravity {
        let size = Unit::of("m/s²", 1.0).show(x.hypot(y));
        rows.row(row![name("G"), text!("given-gravity"), joined(" = ", [name("g"), size])]);
    }
    for load in &mechanism.loads {
        let (what, value) = given(mechanism, &load.kind);
        rows.row(row![Text::from(&load.name), what, value]);
    }
    page.table(rows);
}

/// Where and how a load acts, and the law of its value.
fn given(mechanism: &Mechanism, load: &LoadKind) -> (Text, Text) {
    let link = |id: LinkId| link_name(mechanism, id);
    let law = |value: &Value, unit| law(mechanism, value, unit);
    match load {
        LoadKind::Force(Force { at, direction: along, value }) => {
            let place = text!("given-force", place = LENGTH.show_all(&at.at), link = link(at.link));
            (list([place, direction(*along)]), law(value, NEWTON))
        }
        LoadKind::Moment(moment) => {
            (text!("given-moment", link = link(moment.link)), law(&moment.value, MOMENT.name))
        }
        LoadKind::Brake(brake) => {
            let what = text!(
                "given-brake",
                link = link(brake.link),
                radius = LENGTH.show(brake.radius),
                lever = Unit::NONE.number(brake.lever),
                friction = Unit::NONE.number(brake.friction)
            );
            (what, law(&brake.force, NEWTON))
        }
        LoadKind::Spring(spring) => {
            let [one, other] = spring.ends.map(|end| link(end.link));
            let data = text!(
                "given-spring-data",
                stiffness = Unit::of("N/m", 1.0).show(spring.stiffness),
                length = LENGTH.show(spring.length),
                damping = Unit::of("N·s/m", 1.0).show(spring.damping)
            );
            (text!("given-spring", one, other), data)
        }
        LoadKind::Contact(contact) => {
            let what = text!(
                "given-contact",
                link = link(contact.center.link),
                radius = LENGTH.show(contact.radius),
                friction = Unit::NONE.number(contact.friction)
            );
            (what, law(&contact.force, NEWTON))
        }
    }
}

fn direction(direction: Direction) -> Text {
    match direction {
        Direction::Ground(angle) => text!("given-along-ground", angle = ANGLE.show(angle)),
        Direction::Link(angle) => text!("given-along-link", angle = ANGLE.show(angle)),
        Direction::AgainstMotion => text!("given-against-motion"),
    }
}

/// A value or the law by which it varies, in words.
fn law(mechanism: &Mechanism, value: &Value, of: &'static str) -> Text {
    match value {
        Value::Constant(value) => Unit::of(of, 1.0).show(*value),
        Value::Table { over, table, .. } => {
            let (argument, by) = match over {
                Over::Coordinate if mechanism.input.is_angle() => (text!("given-over-coordinate"), ANGLE),
                Over::Coordinate => (text!("given-over-coordinate"), LENGTH),
                Over::Time => (text!("given-over-time"), Unit::of("s", 1.0)),
                Over::Speed if mechanism.input.is_angle() => (text!("given-over-speed"), TURNING[0]),
                Over::Speed => (text!("given-over-speed"), Unit::of("m/s", 1.0)),
            };
            text!(
                "given-table",
                over = argument,
                by = unit(by.name),
                unit = unit(of),
                rows = pairs(table, by)
            )
        }
        Value::Stroke { axis, forward, back } => text!(
            "given-stroke",
            axis = ANGLE.show(*axis),
            unit = unit(of),
            forward = pairs(forward, Unit::NONE),
            back = pairs(back, Unit::NONE)
        ),
        Value::Formula { formula, .. } => list([name(formula.text().to_owned()), unit(of)]),
    }
}

/// The rows of a table: argument, value; a constant is its value alone.
fn pairs(table: &LawTable, by: Unit) -> Text {
    if let [[_, value]] = table.rows[..] {
        return Unit::NONE.number(value);
    }
    let pair = |[x, y]: &[f64; 2]| {
        let both = joined("; ", [by.number(*x), Unit::NONE.number(*y)]);
        joined("", [name("("), both, name(")")])
    };
    let more = (table.rows.len() > MOST_ROWS).then(|| name("..."));
    list(table.rows.iter().take(MOST_ROWS).map(pair).chain(more))
}

/// What the scene says about motion and drive.
pub fn motion_given(source: &Source<'_>, page: &mut Document) {
    let [speed, acceleration] = source.units.rates;
    let mut facts = match &source.mechanism.motion {
        Some(Motion::Prescribed { speed: w, acceleration: e }) => {
            vec![Fact::number("given-speed", *w, speed), Fact::number("given-acceleration", *e, acceleration)]
        }
        Some(Motion::Transient { speed: w, .. }) => vec![Fact::number("given-initial-speed", *w, speed)],
        Some(Motion::Steady { mean_speed, unevenness }) => {
            let unevenness = unevenness.map(|given| wanted("given-unevenness", given, Unit::NONE));
            std::iter::once(Fact::number("given-mean-speed", *mean_speed, speed)).chain(unevenness).collect()
        }
        None => Vec::new(),
    };
    facts.extend(source.mechanism.drive.iter().flat_map(|of| drive(of, source.units.reduced[2])));
    page.facts(text!("report-given-motion"), facts);
}

fn wanted(id: &'static str, given: Solve, unit: Unit) -> Fact {
    match given {
        Solve::Given(value) => Fact::number(id, value, unit),
        Solve::Wanted => Fact::text(id, text!("given-wanted")),
    }
}

fn drive(drive: &Drive, moment: Unit) -> Vec<Fact> {
    let mut facts = Vec::new();
    match &drive.torque {
        Torque::Constant(torque) => facts.push(Fact::number("given-driving-moment", *torque, moment)),
        Torque::Balance => facts.push(Fact::text("given-driving-moment", text!("given-wanted"))),
        Torque::Motor { motor, .. } => {
            facts.extend(motor_given(motor));
            facts.push(wanted("given-ratio", drive.ratio, Unit::NONE));
            facts.push(Fact::number("given-efficiency", drive.efficiency, Unit::NONE));
        }
        Torque::None => {}
    }
    facts.extend(drive.flywheel.map(|flywheel| wanted("given-flywheel", flywheel, INERTIA)));
    facts
}

fn motor_given(motor: &MotorChoice) -> Vec<Fact> {
    match motor {
        MotorChoice::Auto => vec![Fact::text("given-motor", text!("given-chosen"))],
        MotorChoice::Designation(designation) => vec![Fact::text("given-motor", name(designation.clone()))],
        MotorChoice::Rated(rated) => {
            let breakdown = |ratio| Fact::number("fact-breakdown-ratio", ratio, Unit::NONE);
            let rotor = |inertia| Fact::number("fact-rotor", inertia, INERTIA);
            let some = [
                Fact::number("fact-rated-power", rated.power, POWER),
                Fact::number("fact-synchronous-speed", rated.synchronous_speed, TURNING[0]),
                Fact::number("fact-rated-speed", rated.rated_speed, TURNING[0]),
            ];
            some.into_iter()
                .chain(rated.max_torque_ratio.map(breakdown))
                .chain(rated.inertia.map(rotor))
                .collect()
        }
    }
}

/// How many positions there are, of which link.
pub fn task_text(source: &Source<'_>) -> Text {
    let input = link_name(source.mechanism, source.mechanism.input.link);
    text!("report-task-text", positions = source.mechanism.input.positions, link = input)
}
