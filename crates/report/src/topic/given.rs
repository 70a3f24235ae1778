//! The task as it is given: dimensions and masses, loads, motion and drive.

use assur_book::{Cell, Column, Document, Fact, Table, Unit, link_name, row};
use assur_mechanism::{
    Direction, Drive, Driver, Force, Friction, Inertia, LawTable, LinkId, LoadKind, Mechanism, Motion,
    MotorChoice, Over, Place, Solve, Surfaces, TimeLaw, Torque, Value, VaryingInertia,
};
use assur_words::{Text, joined, list, name, text, unit};

use super::Source;

/// Of a longer table the first rows are shown.
const MOST_ROWS: usize = 12;

/// Each load: where and how it acts, and the law of its value; then the friction of the pairs.
pub fn loads_given(source: &Source<'_>, page: &mut Document) {
    let mechanism = source.mechanism;
    let heads = [text!("head-load"), text!("head-acts"), text!("head-value")].map(Column::of);
    let mut rows = Table::list(text!("report-given-loads"), heads);
    if let Some([x, y]) = mechanism.gravity {
        let size = Unit::MOVING[1].show(x.hypot(y));
        rows.row(row![name("G"), text!("given-gravity"), joined(" = ", [name("g"), size])]);
    }
    for load in &mechanism.loads {
        let (what, value) = given(mechanism, &load.kind);
        rows.row(row![Text::from(&load.name), what, value]);
    }
    page.table(rows);
    friction_given(mechanism, page);
}

/// Each pair with friction: its coefficient, and the surfaces that slide on each other.
fn friction_given(mechanism: &Mechanism, page: &mut Document) {
    let surfaces = |friction: &&Friction| match friction.surfaces {
        Surfaces::Journal { radius, owner } => {
            text!("given-journal", link = link_name(mechanism, owner), radius = Unit::LENGTH.show(radius))
        }
        Surfaces::Place => text!("given-pressed-place"),
        Surfaces::Faces { length, offset, .. } => text!(
            "given-pressed-faces",
            length = Unit::LENGTH.show(length),
            offset = Unit::LENGTH.show(offset)
        ),
    };
    let table = Table::each(text!("report-given-friction"), &mechanism.frictions)
        .column(text!("head-pair"), |friction| mechanism.pair_name(friction.pair))
        .column(text!("head-surfaces"), surfaces)
        .measured(text!("head-coefficient"), Unit::NONE, |friction| friction.coefficient);
    page.table(table.table());
}

/// Where and how a load acts, and the law of its value.
fn given(mechanism: &Mechanism, load: &LoadKind) -> (Text, Text) {
    let link = |id: LinkId| link_name(mechanism, id);
    let law = |value: &Value, unit| law(mechanism, value, unit);
    match load {
        LoadKind::Force(Force { at, direction: along, value }) => {
            (list([acts_at(mechanism, *at), direction(*along)]), law(value, Unit::FORCE.name))
        }
        LoadKind::Moment(moment) => {
            let acts = text!("given-moment", link = link(moment.link));
            let acts =
                if moment.against_motion { list([acts, text!("given-against-rotation")]) } else { acts };
            (acts, law(&moment.value, Unit::MOMENT.name))
        }
        LoadKind::Brake(brake) => {
            let what = text!(
                "given-brake",
                link = link(brake.link),
                radius = Unit::LENGTH.show(brake.radius),
                lever = Unit::NONE.number(brake.lever),
                friction = Unit::NONE.number(brake.friction)
            );
            (what, law(&brake.force, Unit::FORCE.name))
        }
        LoadKind::Spring(spring) => {
            let [one, other] = spring.ends.map(|end| link(end.link));
            let data = text!(
                "given-spring-data",
                stiffness = Unit::si("N/m").show(spring.stiffness),
                length = Unit::LENGTH.show(spring.length),
                damping = Unit::si("N s/m").show(spring.damping)
            );
            (text!("given-spring", one, other), data)
        }
        LoadKind::Contact(contact) => {
            let what = text!(
                "given-contact",
                link = link(contact.center.link),
                radius = Unit::LENGTH.show(contact.radius),
                center = place_name(mechanism, contact.center),
                angle = angle_law(mechanism, &contact.angle),
                friction = Unit::NONE.number(contact.friction)
            );
            (what, law(&contact.force, Unit::FORCE.name))
        }
    }
}

/// The point at a place of a link by its name, or the place in the frame of the link.
fn place_name(mechanism: &Mechanism, at: Place) -> Text {
    let is_there = |id: usize| mechanism.place_in(id, at.link) == Some(at.at);
    let point = (0..mechanism.points.len()).find(|id| is_there(*id));
    point.map_or_else(|| Unit::LENGTH.show_all(&at.at), |id| Text::from(&mechanism.points[id].name))
}

/// An angle, or the law by which it varies, rad.
fn angle_law(mechanism: &Mechanism, angle: &Value) -> Text {
    match angle {
        Value::Constant(angle) => Unit::ANGLE.show(*angle),
        law_of => law(mechanism, law_of, "rad"),
    }
}

/// Where a force acts: at a point of its link that has a name, else at a place in its frame.
fn acts_at(mechanism: &Mechanism, at: Place) -> Text {
    let link = link_name(mechanism, at.link);
    let is_there = |id: usize| mechanism.place_in(id, at.link) == Some(at.at);
    match (0..mechanism.points.len()).find(|id| is_there(*id)) {
        Some(id) => text!("given-force-at", point = Text::from(&mechanism.points[id].name), link),
        None => text!("given-force", place = Unit::LENGTH.show_all(&at.at), link),
    }
}

fn direction(direction: Direction) -> Text {
    match direction {
        Direction::Ground(angle) => text!("given-along-ground", angle = Unit::ANGLE.show(angle)),
        Direction::Link(angle) => text!("given-along-link", angle = Unit::ANGLE.show(angle)),
        Direction::AgainstMotion => text!("given-against-motion"),
    }
}

/// A value or the law by which it varies, in words.
fn law(mechanism: &Mechanism, value: &Value, of: &'static str) -> Text {
    match value {
        Value::Constant(value) => Unit::si(of).show(*value),
        Value::Table { over, table, .. } => {
            let (argument, by) = match over {
                Over::Coordinate => {
                    (text!("given-over-coordinate"), Unit::place(mechanism.input.first().is_angle()))
                }
                Over::Time => (text!("given-over-time"), Unit::SECOND),
                Over::Speed => {
                    (text!("given-over-speed"), Unit::rates(mechanism.input.first().is_angle())[0])
                }
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
            axis = Unit::ANGLE.show(*axis),
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
    let [speed, acceleration] = Unit::rates_of(source.kind);
    if source.kind.is_time() {
        return page.facts(text!("report-given-motion"), laws(source));
    }
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
    facts.extend(source.mechanism.drive.iter().flat_map(|of| drive(of, Unit::load_of(source.kind))));
    page.facts(text!("report-given-motion"), facts);
}

/// The duration of a motion over time, and the law of each drive.
fn laws(source: &Source<'_>) -> Vec<Fact> {
    let input = &source.mechanism.input;
    let moves = source.mechanism.motion.is_some();
    let duration = moves.then(|| Fact::number("given-duration", input.ends()[1], Unit::SECOND));
    let law = |driver: &Driver| {
        let unit = Unit::place(driver.is_angle());
        let told = match driver.law.as_ref()? {
            TimeLaw::Uniform { from, .. } if !moves => unit.show(*from),
            TimeLaw::Uniform { from, rate } => {
                let rate = Unit::rates(driver.is_angle())[0].show(*rate);
                text!("given-uniform", from = unit.show(*from), rate)
            }
            TimeLaw::Pieces(pieces) => {
                let rows = pieces.rows().map(|row| {
                    let both = joined("; ", [Unit::SECOND.number(row[0]), unit.number(row[1])]);
                    joined("", [name("("), both, name(")")])
                });
                let count = pieces.rows().count();
                let more = (count > MOST_ROWS).then(|| name("..."));
                let rows = list(rows.take(MOST_ROWS).chain(more));
                let unit = assur_words::unit(unit.name);
                if pieces.is_smooth() {
                    text!("given-law-spline", rows, unit)
                } else {
                    text!("given-law-lines", rows, unit)
                }
            }
            TimeLaw::Formula { formula, .. } => name(formula.text().to_owned()),
        };
        Some(Fact::text("given-law", told).of("drive", Text::from(&driver.label)))
    };
    duration.into_iter().chain(input.drivers.iter().filter_map(law)).collect()
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
    facts.extend(drive.flywheel.map(|flywheel| wanted("given-flywheel", flywheel, Unit::INERTIA)));
    facts
}

fn motor_given(motor: &MotorChoice) -> Vec<Fact> {
    match motor {
        MotorChoice::Auto => vec![Fact::text("given-motor", text!("given-chosen"))],
        MotorChoice::Designation(designation) => vec![Fact::text("given-motor", name(designation.clone()))],
        MotorChoice::Rated(rated) => {
            let breakdown = |ratio| Fact::number("fact-breakdown-ratio", ratio, Unit::NONE);
            let rotor = |inertia| Fact::number("fact-rotor", inertia, Unit::INERTIA);
            let some = [
                Fact::number("fact-rated-power", rated.power, Unit::POWER),
                Fact::number("fact-synchronous-speed", rated.synchronous_speed, Unit::TURNING[0]),
                Fact::number("fact-rated-speed", rated.rated_speed, Unit::TURNING[0]),
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
    let input = assur_book::driven_link(source.mechanism);
    text!("report-task-text", positions = source.mechanism.input.positions, link = input)
}

/// Points, slides, masses.
pub fn dimensions(source: &Source<'_>, page: &mut Document) {
    points(source, page);
    slides(source, page);
    masses(source, page);
}

fn points(source: &Source<'_>, page: &mut Document) {
    let length = |axis| Column::short(name(axis), Unit::LENGTH);
    let heads = [Column::of(text!("head-link")), Column::of(text!("head-point")), length("x"), length("y")];
    let mut table = Table::list(text!("report-points"), heads);
    for (id, link) in source.mechanism.links.iter().enumerate() {
        for (point_id, point) in source.mechanism.points.iter().enumerate() {
            if let Some([x, y]) = source.mechanism.place_in(point_id, id) {
                table.row(row![&link.name, &point.name, x, y]);
            }
        }
    }
    page.table(table);
}

fn slides(source: &Source<'_>, page: &mut Document) {
    let table = Table::each(text!("report-slides"), &source.mechanism.slides)
        .column(text!("head-slide"), |slide| &slide.name)
        .measured(text!("head-point-x"), Unit::LENGTH, |slide| slide.point[0])
        .measured(name("y"), Unit::LENGTH, |slide| slide.point[1])
        .column(text!("head-on"), |slide| link_name(source.mechanism, slide.on))
        .measured(text!("head-through-x"), Unit::LENGTH, |slide| slide.through[0])
        .measured(name("y"), Unit::LENGTH, |slide| slide.through[1])
        .measured(text!("head-angle"), Unit::ANGLE, |slide| slide.angle)
        .measured(text!("head-tilt"), Unit::ANGLE, |slide| slide.tilt);
    page.table(table.table());
}

/// A moment of inertia: a number, or the formula by which it varies, in SI.
fn inertia_given(inertia: &Inertia) -> Cell {
    let Some(VaryingInertia { formula, factor }) = inertia.varying() else {
        return inertia.constant().into();
    };
    let formula = name(formula.text().to_owned());
    if factor.total_cmp(&1.0).is_eq() {
        return formula.into();
    }
    let formula = joined("", [name("("), formula, name(")")]);
    joined(" · ", [Unit::NONE.number(*factor), formula]).into()
}

fn masses(source: &Source<'_>, page: &mut Document) {
    let heavy = source.mechanism.links.iter().skip(1).filter(|link| link.is_heavy());
    let table = Table::each(text!("report-masses"), heavy)
        .column(text!("head-link"), |link| &link.name)
        .measured(text!("head-mass"), Unit::KILOGRAM, |link| link.mass)
        .measured(text!("head-center-x"), Unit::LENGTH, |link| link.center[0])
        .measured(name("y"), Unit::LENGTH, |link| link.center[1])
        .measured(text!("head-inertia"), Unit::INERTIA, |link| inertia_given(&link.inertia))
        .table();
    if table.is_empty() {
        return page.paragraph(text!("report-massless"));
    }
    page.table(table);
}
