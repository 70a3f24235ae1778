//! What a sweep writes of each point: the columns of its measures, and the statistics from which they follow.

use std::sync::Arc;

use assur_analysis::plan::Wanted;
use assur_analysis::results::{Column, Owner, Quantity, Schema};
use assur_analysis::{Calculation, Options, plan, unwatched};
use assur_book::Unit;
use assur_book::catalogue::unit;
use assur_force::{Joint, joints};
use assur_kinematics::decompose;
use assur_mechanism::{LinkId, Mechanism, Motion, SlideId, Torque};
use assur_words::{list, name, text};

use crate::measured::Measured;
use crate::reach::Reach;
use crate::{Measure, SweepError, Target};

/// How a number of a point is found, by the number of what it belongs to: a statistic, a part, a place.
pub(crate) type Find = fn(&Measured, usize) -> Option<f64>;

/// A column of a measure.
#[derive(Debug, Clone)]
pub(crate) struct Value {
    pub(crate) name: String,
    pub(crate) of: usize,
    pub(crate) find: Find,
}

/// A number of a position of which there is a statistic.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Gathered {
    /// Least determinant of all groups.
    Health,
    /// Least transmission angle of all groups.
    Transmission,
    /// A coordinate of a point, by its number among the points that are wanted.
    Point(usize, Column),
    /// Displacement of a slide.
    Slide(SlideId),
    /// Continuous angle of a link.
    Link(LinkId),
    /// The balancing load, and its magnitude.
    Balancing,
    BalancingSize,
    /// The greatest force of a pin or slide on one of its links; the statistic at the positions is of its square.
    Force(Joint),
    /// The magnitude of the moment of a slide.
    Moment(Joint),
    /// A column of the results as it is.
    Plain(Column),
}

/// What a sweep writes of each point; the same at every point.
#[derive(Debug, Clone, Default)]
pub(crate) struct Layout {
    /// The columns of the measures.
    pub(crate) values: Vec<Value>,
    /// What has a statistic, each once.
    pub(crate) gathered: Vec<Gathered>,
    /// Places from which a point's distance is measured: the number of the point among those that are wanted, its name, and the
    /// place, m.
    pub(crate) targets: Vec<(usize, String, [f64; 2])>,
    /// The force analyzer, where forces are calculated.
    pub(crate) analyzer: Option<&'static str>,
    /// Whether a motor is chosen or given.
    pub(crate) has_motor: bool,
}

/// Collects the columns of measures.
pub(crate) struct Builder<'a> {
    pub(crate) mechanism: &'a Mechanism,
    /// The names of the parts.
    pub(crate) schema: Schema,
    /// The columns of the results, where a measure has them as they are.
    pub(crate) results: Option<Arc<Schema>>,
    pub(crate) wanted: Wanted,
    /// Whether a balancing load is found at the positions.
    pub(crate) balances: bool,
    /// Whether there is a group.
    has_groups: bool,
    /// Pins and slides whose reactions are found.
    joints: Vec<Joint>,
    reach: Reach,
    /// Whether columns that no parameter can change are written too.
    whole: bool,
    pub(crate) layout: Layout,
}

impl Layout {
    /// What `measures` write of a mechanism.
    ///
    /// # Errors
    ///
    /// [`SweepError::Request`] for a target that is no point of the results.
    pub(crate) fn of(
        mechanism: &Mechanism,
        options: &Options,
        reach: Reach,
        (measures, targets): (&[Measure], &[Target]),
    ) -> Result<Self, SweepError> {
        let mut to = Builder::of(mechanism, options, reach);
        let points = to.wanted.points.iter();
        let names: Vec<_> = points.map(|(id, _)| to.schema.name(Owner::Point(*id)).into_owned()).collect();
        let aimed = |target: &Target| {
            let unknown = || text!("sweep-no-point", points = list(names.iter().cloned().map(name)));
            let point = names.iter().position(|name| *name == target.point);
            let point = point.ok_or_else(|| SweepError::vary(&target.text, unknown()))?;
            Ok::<_, SweepError>((point, target.point.clone(), target.at))
        };
        to.layout.targets = targets.iter().map(aimed).collect::<Result<_, _>>()?;
        if measures.iter().any(|measure| measure.put.is_none()) {
            let found = Calculation::of(mechanism.clone(), options, &mut unwatched);
            to.results = found.ok().map(|found| found.columns());
        }
        for measure in measures {
            to.whole = measure.whole;
            measure.columns(&mut to);
        }
        Ok(to.layout)
    }
}

impl<'a> Builder<'a> {
    /// No columns yet; there is little to measure where the mechanism can't be decomposed into groups.
    fn of(mechanism: &'a Mechanism, options: &Options, reach: Reach) -> Self {
        let mut to = Self {
            mechanism,
            schema: Schema::new(mechanism),
            results: None,
            wanted: Wanted::default(),
            balances: false,
            has_groups: false,
            joints: Vec::new(),
            reach,
            whole: false,
            layout: Layout::default(),
        };
        let torque = mechanism.drive.as_ref().map(|drive| &drive.torque);
        to.layout.has_motor =
            matches!((&mechanism.motion, torque), (Some(Motion::Steady { .. }), Some(Torque::Motor { .. })));
        let Ok(structure) = decompose(mechanism) else { return to };
        let plan = plan(mechanism, &structure, options);
        to.has_groups = plan.groups_needed.contains(&true);
        to.balances = plan.forces && !matches!(mechanism.motion, Some(Motion::Transient { .. }));
        let has_friction = !mechanism.frictions.is_empty();
        let analyzer =
            assur_force::choose(options.analyzer.as_deref(), has_friction, !structure.passive.is_empty());
        let analyzer = analyzer.ok().filter(|_| plan.forces);
        to.layout.analyzer = analyzer.map(|plugin| plugin.name);
        if to.balances && analyzer.is_some_and(|plugin| plugin.gives_reactions) {
            to.joints = joints(mechanism, &structure);
            to.joints.retain(|joint| plan.wanted.reactions.contains(&joint.id));
        }
        to.wanted = plan.wanted;
        to
    }

    /// Whether there is a group whose positions are of interest.
    pub(crate) fn has_groups(&self) -> bool {
        self.has_groups && (self.whole || self.reach.moves_anything())
    }

    /// Whether the number of a part is of interest.
    pub(crate) fn has(&self, owner: Owner) -> bool {
        self.whole || self.reach.has(owner, self.mechanism)
    }

    /// The pins and slides whose reactions are found and of interest.
    pub(crate) fn joints(&self) -> Vec<Joint> {
        let all = self.joints.iter().filter(|joint| self.has(Owner::Pair(joint.id)));
        all.cloned().collect()
    }

    /// The unit of a quantity.
    pub(crate) fn unit(&self, quantity: Quantity, owner: Owner) -> Unit {
        unit(&self.schema, Column::of(quantity, owner))
    }

    /// The unit of the coordinate of the input.
    pub(crate) fn coordinate(&self) -> Unit {
        self.unit(Quantity::Transfer(0), Owner::Input)
    }

    /// Adds a column, whose name ends with its unit.
    pub(crate) fn put(&mut self, name: &str, unit: Unit, of: usize, find: Find) {
        let suffix = unit.suffix();
        let name = if suffix.is_empty() { name.to_owned() } else { format!("{name}_{suffix}") };
        self.layout.values.push(Value { name, of, find });
    }

    /// The number of a statistic.
    pub(crate) fn gather(&mut self, what: Gathered) -> usize {
        let gathered = &mut self.layout.gathered;
        gathered.iter().position(|known| *known == what).unwrap_or_else(|| {
            gathered.push(what);
            gathered.len() - 1
        })
    }

    /// Points, then slides, then links: what has a course.
    pub(crate) fn parts(&self) -> Vec<Owner> {
        let Wanted { points, slides, links, .. } = &self.wanted;
        let points = points.iter().map(|(point, _)| Owner::Point(*point));
        let slides = slides.iter().map(|slide| Owner::Slide(*slide));
        points.chain(slides).chain(links.iter().map(|link| Owner::Link(*link))).collect()
    }
}

impl Gathered {
    /// Whether it is the same under all loads.
    pub(crate) fn is_of_places(&self) -> bool {
        matches!(self, Self::Health | Self::Transmission | Self::Point(..) | Self::Slide(_) | Self::Link(_))
    }
}

/// How many links of a pin or slide are looked at for its greatest force: the forces on two links are opposite.
pub(crate) fn ends(joint: &Joint) -> usize {
    if joint.links.len() == 2 { 1 } else { joint.links.len() }
}
