//! The drive with the flywheel in its two places, to one scale (S fig. 13): motor, gear, flywheel, crank, with their masses.

use assur_analysis::results::Dynamics;
use assur_figure::number::digits;
use assur_figure::{Bounds, Ink, Item, Key, Panel, Point, Sample, Scale, Sign, Stroke, one_scale};
use assur_mechanism::{InputPair, Mechanism};
use assur_motor::{FlywheelSize, Motor, catalogues};
use assur_report::topic::flywheel_shaft;
use assur_words::{Text, joined, list, name, number, quantity, text};

/// Inks of the parts.
const MOTOR: Ink = Ink::Link(1);
const FLYWHEEL: Ink = Ink::Link(2);
const CRANK: Ink = Ink::Link(3);
/// Distance between two parts, as part of the height of the motor.
const APART: f64 = 0.35;
/// Relative difference below which rated power and synchronous speed count as the same.
const SAME: f64 = 0.01;
/// Height of a motor of which no size is known, m. What has no sizes of its own is drawn dashed: such a motor, and the gear.
const UNKNOWN: f64 = 0.2;
/// Height of the gear and its length, as parts of the height of the motor.
const GEAR: [f64; 2] = [1.2, 2.0];

/// A panel for each place of the flywheel, all to one scale.
pub(crate) fn panels(mechanism: &Mechanism, dynamics: &Dynamics) -> Vec<Panel> {
    let panel = |wheel: &FlywheelSize| {
        let (title, items) = drive(mechanism, dynamics, wheel);
        let bounds = Bounds::around(items.iter().flat_map(Item::points));
        Panel { title, ..Panel::plane(bounds, Scale::of("l", "m"), items) }
    };
    let mut panels: Vec<Panel> = dynamics.flywheel_places.iter().map(panel).collect();
    one_scale(panels.iter_mut());
    panels
}

/// The parts along the shaft from the motor to the crank, seen from the side.
struct Shaft {
    items: Vec<Item>,
    /// Where the next part begins, m.
    at: f64,
    apart: f64,
}

impl Shaft {
    /// A part of this length and height with what is said of it above; one whose own size is not known is dashed.
    fn part(&mut self, [length, height]: [f64; 2], told: Option<Text>, known: bool, ink: Ink) {
        let (from, to) = (self.at, self.at + length);
        let [low, high] = [-0.5 * height, 0.5 * height];
        let outline = vec![[from, low], [to, low], [to, high], [from, high]];
        self.items.push(if known {
            Item::Area { outline, ink }
        } else {
            let closed: Vec<Point> = outline.iter().chain(outline.first()).copied().collect();
            Item::line(closed, Stroke::Dashed, ink)
        });
        self.items.extend(told.map(|told| Item::name([0.5 * (from + to), high], told, Ink::Title)));
        // The shaft to the next part.
        self.at = to + self.apart;
        self.items.push(Item::line([[to, 0.0], [self.at, 0.0]], Stroke::Solid, Ink::Text));
    }
}

/// The motor: its size, whether it is its own, its mass, and how it is called.
struct Drawn {
    size: [f64; 2],
    own: bool,
    mass: Option<f64>,
    name: Text,
}

impl Drawn {
    fn of(dynamics: &Dynamics) -> Self {
        let motor = dynamics.motor.as_ref().map(|found| &*found.motor);
        let own = motor.and_then(size_of);
        let other = motor.filter(|_| own.is_none()).and_then(alike);
        let name = match other {
            Some(other) => text!("places-motor-as", other = name(other.designation.clone())),
            None => text!("places-motor"),
        };
        Self {
            size: own.or_else(|| other.and_then(size_of)).unwrap_or([1.5 * UNKNOWN, UNKNOWN]),
            own: own.is_some(),
            mass: motor.and_then(|motor| motor.mass).or_else(|| other.and_then(|other| other.mass)),
            name,
        }
    }
}

fn kilograms(mass: f64) -> Text {
    quantity(digits(mass, 3), "kg")
}

/// What the parts are, with the ratio of the gear; those without a known size of their own are dashed.
pub(crate) fn legend(dynamics: &Dynamics) -> Vec<Key> {
    let motor = Drawn::of(dynamics);
    let stroke = if motor.own { Stroke::Thick } else { Stroke::Dashed };
    let ratio = dynamics.figures.ratio.map(|ratio| joined("", [name("u = "), number(digits(ratio, 4))]));
    let keys = [
        (stroke, MOTOR, motor.name),
        (Stroke::Dashed, Ink::Dim, list(std::iter::once(text!("places-gear")).chain(ratio))),
        (Stroke::Thick, FLYWHEEL, text!("regime-flywheel")),
        (Stroke::Thick, CRANK, text!("places-crank")),
    ];
    keys.map(|(stroke, ink, text)| Key { sample: Sample::Line(stroke, ink), text }).into()
}

/// A drive with its flywheel on one of the two shafts; its heading has the mass of motor and flywheel.
fn drive(mechanism: &Mechanism, dynamics: &Dynamics, wheel: &FlywheelSize) -> (Text, Vec<Item>) {
    let Drawn { size: [length, height], own, mass, .. } = Drawn::of(dynamics);
    let mut row = Shaft { items: Vec::new(), at: 0.0, apart: APART * height };
    row.part([length, height], mass.map(kilograms), own, MOTOR);
    let flywheel = |row: &mut Shaft| {
        row.part([wheel.width, wheel.diameter], Some(kilograms(wheel.mass)), true, FLYWHEEL);
    };
    let on_motor = wheel.shaft != "input";
    if on_motor {
        flywheel(&mut row);
    }
    row.part([GEAR[1] * height, GEAR[0] * height], None, false, Ink::Dim);
    if !on_motor {
        flywheel(&mut row);
    }
    crank(mechanism, &mut row);
    let shaft = flywheel_shaft(wheel.shaft);
    let title = match mass {
        Some(mass) => text!("places-with-mass", shaft = shaft, sum = kilograms(mass + wheel.mass)),
        None => text!("places-title", shaft = shaft),
    };
    (title, row.items)
}

/// Length and diameter of a motor of a catalogue, m.
fn size_of(motor: &Motor) -> Option<[f64; 2]> {
    Some([motor.length?, motor.diameter?])
}

/// A motor of a catalogue with the same rated power and synchronous speed that has sizes: the lightest one, by which a motor of
/// which only rated data are known is drawn.
fn alike(drive: &Motor) -> Option<&'static Motor> {
    let same = |own: f64, other: f64| (own - other).abs() <= SAME * other;
    let all =
        catalogues().unwrap_or_default().into_iter().filter_map(|catalogue| catalogue.rows().ok()).flatten();
    let fits = all.filter(|motor| {
        size_of(motor).is_some()
            && same(drive.rated_power, motor.rated_power)
            && same(drive.synchronous_speed, motor.synchronous_speed)
    });
    let mass = |motor: &Motor| motor.mass.unwrap_or(f64::INFINITY);
    fits.min_by(|one, other| mass(one).total_cmp(&mass(other)))
}

/// The input link at the end of its shaft, as long as from its pin to its farthest point.
fn crank(mechanism: &Mechanism, row: &mut Shaft) {
    let Some(link) = mechanism.input.crank() else { return };
    let places = || (0..mechanism.points.len()).filter_map(|id| mechanism.place_in(id, link));
    let InputPair::Pin(pin) = mechanism.input.first().pair else { return };
    let pin = mechanism.place_in(pin, link).unwrap_or_default();
    let far = places().map(|at| (at[0] - pin[0]).hypot(at[1] - pin[1])).fold(0.0, f64::max);
    let at = row.at;
    row.items.push(Item::line([[at, 0.0], [at, far]], Stroke::Thick, CRANK));
    row.items.push(Item::sign([at, far], Sign::Pin, CRANK));
}
