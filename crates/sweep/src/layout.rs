//! What of a mechanism is measured, by name and by place.

use std::iter::once;

use assur_analysis::results::{Column, Owner, Part, Quantity};
use assur_analysis::{Calculation, Options, plan};
use assur_book::catalogue::{self, PathStep};
use assur_force::{Joint, joints};
use assur_kinematics::decompose;
use assur_mechanism::{LinkId, Mechanism, Motion, PairId, PointId, SlideId, Torque};
use assur_structure::name_of;

use assur_words::{list, name, text};

use crate::reach::Reach;
use crate::{SweepError, Target};

/// What of a mechanism is measured; the same at every point of a sweep.
#[derive(Debug, Clone)]
pub(crate) struct Layout {
    /// Whether there is a group.
    pub(crate) groups: bool,
    /// Whether a balancing load is found at the positions.
    pub(crate) balancing: bool,
    /// Pins and slides whose reactions are found.
    pub(crate) joints: Vec<Named<Joint>>,
    /// Points, each with the link in which it is placed first.
    pub(crate) points: Vec<Named<(PointId, LinkId)>>,
    /// Slides.
    pub(crate) slides: Vec<Named<SlideId>>,
    /// Moving links.
    pub(crate) links: Vec<Named<LinkId>>,
    /// Places from which a point's distance is measured: the number of the point among `points`, and the place, m.
    pub(crate) targets: Vec<(usize, [f64; 2])>,
    /// Whether there is dry friction in pairs.
    pub(crate) friction: bool,
    /// The force analyzer, where forces are calculated.
    pub(crate) analyzer: Option<&'static str>,
    /// The motion, unless it is prescribed.
    pub(crate) motion: Option<Sought>,
    /// Units of coordinate, speed and balancing load, as ends of column names.
    pub(crate) units: Units,
    /// Columns of the positions that are measured as they are.
    pub(crate) plain: Vec<Plain>,
    /// What has a statistic: first what belongs to the places, then what belongs to loads and motion, then the plain columns.
    pub(crate) gathered: Vec<Gathered>,
    /// How many of them belong to the places.
    pub(crate) places: usize,
}

/// A number of a position of which there is a statistic.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Gathered {
    /// Least determinant of all groups.
    Health,
    /// Least transmission angle of all groups.
    Transmission,
    /// A column of the results.
    Column(Column),
    /// The modulus of a column.
    Size(Column),
    /// The greatest force of a pin or slide on one of its links: their moduli. The statistic at the positions is of its square.
    Force(Vec<Column>),
}

/// A column of the positions that is measured as it is.
#[derive(Debug, Clone)]
pub(crate) struct Plain {
    /// Its key in the JSON of a position.
    pub(crate) key: &'static str,
    /// The names of its least and greatest value, its mean and its root mean square.
    pub(crate) names: [String; 4],
    /// The number of its statistic.
    pub(crate) first: usize,
}

/// Something with its name in the scene.
#[derive(Debug, Clone)]
pub(crate) struct Named<T> {
    pub(crate) name: String,
    pub(crate) id: T,
    /// The number of its first statistic.
    pub(crate) first: usize,
    /// Whether a parameter can change it.
    pub(crate) reached: bool,
}

/// A motion that is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sought {
    /// The periodic regime.
    Steady { flywheel: bool, motor: bool, torque: bool },
    /// From an initial state.
    Transient,
}

/// Units that depend on the input and the balancing load, as ends of column names.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units {
    pub(crate) coordinate: &'static str,
    pub(crate) speed: &'static str,
    pub(crate) balancing: &'static str,
}

impl Layout {
    /// The layout for a mechanism; it is empty where the mechanism can't be decomposed into groups.
    pub(crate) fn of(mechanism: &Mechanism, options: &Options) -> Self {
        let (coordinate, speed) =
            if mechanism.input.is_angle() { ("rad", "rad_per_s") } else { ("m", "m_per_s") };
        let balancing = if mechanism.balances_by_moment() { "Nm" } else { "N" };
        let mut layout = Self {
            groups: false,
            balancing: false,
            joints: Vec::new(),
            points: Vec::new(),
            slides: Vec::new(),
            links: Vec::new(),
            targets: Vec::new(),
            friction: !mechanism.frictions.is_empty(),
            analyzer: None,
            motion: sought(mechanism),
            units: Units { coordinate, speed, balancing },
            plain: Vec::new(),
            gathered: Vec::new(),
            places: 0,
        };
        let Ok(structure) = decompose(mechanism) else { return layout };
        let plan = plan(mechanism, &structure, options);
        let wanted = plan.wanted;
        layout.groups = plan.groups_needed.contains(&true);
        layout.balancing = plan.forces && layout.motion != Some(Sought::Transient);
        let analyzer = assur_force::choose(
            options.analyzer.as_deref(),
            !mechanism.frictions.is_empty(),
            !structure.passive.is_empty(),
        );
        let analyzer = analyzer.ok().filter(|_| plan.forces);
        layout.analyzer = analyzer.map(|plugin| plugin.name);
        if layout.balancing && analyzer.is_some_and(|plugin| plugin.gives_reactions) {
            let joints = joints(mechanism, &structure).into_iter();
            let joints = joints.filter(|joint| wanted.reactions.contains(&joint.id));
            layout.joints = named(joints, |joint| name_of(mechanism, joint.id));
        }
        let points = wanted.points.into_iter().map(|(id, place)| (id, place.link));
        layout.points = named(points, |(id, _)| &mechanism.points[*id].name);
        layout.slides = named(wanted.slides.into_iter(), |id| &mechanism.slides[*id].name);
        layout.links = named(wanted.links.into_iter(), |id| &mechanism.links[*id].name);
        layout.number();
        layout
    }

    /// Numbers the statistics.
    fn number(&mut self) {
        let Self { gathered, points, slides, links, joints, places, .. } = self;
        gathered.extend([Gathered::Health, Gathered::Transmission]);
        let mut place = |owner, first: &mut usize| {
            *first = gathered.len();
            let column = Column::of(Quantity::Transfer(0), owner);
            let is_vector = matches!(owner, Owner::Point(_));
            let parts = if is_vector { &[Part::X, Part::Y][..] } else { &[Part::Whole] };
            gathered.extend(parts.iter().map(|part| Gathered::Column(column.part(*part))));
        };
        for point in points {
            place(Owner::Point(point.id.0), &mut point.first);
        }
        for slide in slides {
            place(Owner::Slide(slide.id), &mut slide.first);
        }
        for link in links {
            place(Owner::Link(link.id), &mut link.first);
        }
        *places = gathered.len();
        gathered.extend([Gathered::Column(Column::BALANCING), Gathered::Size(Column::BALANCING)]);
        for joint in joints {
            joint.first = gathered.len();
            // The forces on two links are opposite.
            let ends = if joint.id.links.len() == 2 { 1 } else { joint.id.links.len() };
            let force = |link: &LinkId| Column::of(Quantity::Force, Owner::PairOn(joint.id.id, *link));
            let forces = joint.id.links[..ends].iter().map(|link| force(link).part(Part::Modulus));
            let moment = Gathered::Size(Column::of(Quantity::Moment, Owner::Pair(joint.id.id)));
            gathered
                .extend(once(Gathered::Force(forces.collect())).chain(joint.is_slide().then_some(moment)));
        }
    }

    /// Adds the columns of the positions under some keys of the JSON.
    pub(crate) fn add_plain(&mut self, calculation: &Calculation, keys: &[&'static str]) {
        let schema = calculation.columns();
        for column in schema.columns() {
            let path = catalogue::path(&schema, *column).unwrap_or_default();
            let is_at = |key: &&&str| path.first().is_some_and(|step| *step == PathStep::Key((**key).into()));
            let Some(key) = keys.iter().find(is_at) else { continue };
            let name = |word| catalogue::csv_of(&schema, *column, word).unwrap_or_default();
            let names = ["min", "max", "mean", "rms"].map(name);
            if names[0].is_empty() {
                continue;
            }
            self.plain.push(Plain { key, names, first: self.gathered.len() });
            self.gathered.push(Gathered::Column(*column));
        }
    }

    /// Adds places from which the distance of a point is measured.
    pub(crate) fn aim(&mut self, targets: &[Target]) -> Result<(), SweepError> {
        for target in targets {
            let Some(point) = self.points.iter().position(|point| point.name == target.point) else {
                let points = list(self.points.iter().map(|point| name(point.name.clone())));
                return Err(SweepError::vary(&target.text, text!("sweep-no-point", points = points)));
            };
            self.targets.push((point, target.at));
        }
        Ok(())
    }

    /// The same with what parameters can change marked; without groups where they can't change a place.
    pub(crate) fn reached(&self, reach: &Reach, mechanism: &Mechanism) -> Self {
        let mut layout = self.clone();
        layout.groups &= reach.moves_anything();
        layout.joints.iter_mut().for_each(|joint| joint.reached = reach.pair(joint.id.id, mechanism));
        layout.points.iter_mut().for_each(|point| point.reached = reach.point(point.id.0, mechanism));
        layout.slides.iter_mut().for_each(|slide| slide.reached = reach.slide(slide.id, mechanism));
        layout.links.iter_mut().for_each(|link| link.reached = reach.link(link.id));
        layout
    }

    /// Whether a motor is chosen or given.
    pub(crate) fn has_motor(&self) -> bool {
        matches!(self.motion, Some(Sought::Steady { motor: true, .. }))
    }
}

impl Named<Joint> {
    pub(crate) fn is_slide(&self) -> bool {
        matches!(self.id.id, PairId::Slide(_))
    }
}

fn named<'m, T>(ids: impl Iterator<Item = T>, name: impl Fn(&T) -> &'m str) -> Vec<Named<T>> {
    ids.map(|id| Named { name: name(&id).to_owned(), id, first: 0, reached: true }).collect()
}

fn sought(mechanism: &Mechanism) -> Option<Sought> {
    let drive = mechanism.drive.as_ref();
    let torque = drive.map(|drive| &drive.torque);
    match mechanism.motion.as_ref()? {
        Motion::Prescribed { .. } => None,
        Motion::Transient { .. } => Some(Sought::Transient),
        Motion::Steady { .. } => Some(Sought::Steady {
            flywheel: drive.is_some_and(|drive| drive.flywheel.is_some()),
            motor: matches!(torque, Some(Torque::Motor { .. })),
            torque: matches!(torque, Some(Torque::Balance | Torque::Constant(_))),
        }),
    }
}
