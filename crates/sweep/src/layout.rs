//! What a sweep writes of each point: the columns of its measures, and what is gathered for them.

use assur_analysis::plan::Wanted;
use assur_analysis::results::{Column, Owner, Quantity, Schema};
use assur_analysis::{Calculation, Options, plan, unwatched};
use assur_book::catalogue::{self, PathStep};
use assur_force::{Joint, joints};
use assur_kinematics::decompose;
use assur_mechanism::{Drive, Mechanism, Motion, PairId, Torque};
use assur_words::{list, name, text};

use crate::measure::{BY_COORDINATE, COLUMNS, Find, In, MeasureColumn, Of, PLAIN};
use crate::measured::Gathered;
use crate::reach::Reach;
use crate::{Measure, SweepError, Target};

/// A column of a measure.
#[derive(Debug, Clone)]
pub(crate) struct Value {
    /// The name of its measure.
    measure: &'static str,
    /// Whether it is where another one is found.
    is_place: bool,
    pub(crate) name: String,
    pub(crate) of: usize,
    pub(crate) find: Find,
}

/// What a sweep writes of each point; the same at every point.
#[derive(Debug, Clone, Default)]
pub(crate) struct Layout {
    /// The columns of the measures.
    pub(crate) values: Vec<Value>,
    /// What has columns of its own.
    asked: Vec<Of>,
    /// Whether a motor is chosen or given.
    pub(crate) has_motor: bool,
    /// What has a statistic, each once.
    pub(crate) gathered: Vec<Gathered>,
    /// Places from which a point's distance is measured: the number of the point among those that are wanted, its name, and the
    /// place, m.
    pub(crate) targets: Vec<(usize, String, [f64; 2])>,
    /// The force analyzer, where forces are calculated.
    pub(crate) analyzer: Option<&'static str>,
}

/// What is measured: the beginning of the names of its columns, its quantity, and where its numbers are.
struct Measurand {
    prefix: String,
    column: Column,
    source: Source,
}

/// Where the numbers of columns are: in a statistic, or under a number.
enum Source {
    Statistic(Gathered),
    Nth(usize),
}

/// Collects the columns of measures.
struct Builder<'a> {
    mechanism: &'a Mechanism,
    /// The names of the parts.
    schema: Schema,
    wanted: Wanted,
    /// Whether a balancing load is found at the positions.
    balances: bool,
    /// Whether there is a group.
    has_groups: bool,
    /// Pins and slides whose reactions are found.
    joints: Vec<Joint>,
    reach: Reach,
    /// Whether columns that no parameter can change are written too.
    whole: bool,
    layout: Layout,
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
        to.layout.has_motor = !to.measurands(Of::Motor).is_empty();
        let found = || Calculation::of(mechanism.clone(), options, &mut unwatched).ok();
        let results = measures.iter().any(|measure| measure.is_plain).then(found).flatten();
        let results = results.map(|found| found.columns());
        // Over time there is no one coordinate by which they would be.
        let is_timed = mechanism.input.kind().is_time();
        for measure in measures.iter().filter(|measure| !(is_timed && BY_COORDINATE.contains(&measure.name)))
        {
            to.whole = measure.whole;
            if measure.is_plain {
                if let Some(schema) = &results {
                    to.add_plain(schema, measure.name);
                }
                continue;
            }
            // Each number of the motion between positions has all parts one after the other.
            let same = |one: &MeasureColumn, other: &MeasureColumn| {
                one.of != Of::Parts && (one.measure, one.of) == (other.measure, other.of)
            };
            for family in COLUMNS.chunk_by(same).filter(|family| family[0].measure == measure.name) {
                to.add(family[0].of, family);
            }
        }
        Ok(to.layout)
    }

    /// The numbers of the values of a measure, without the places at which they are found.
    pub(crate) fn values_of<'a>(&'a self, measure: &'a str) -> impl Iterator<Item = usize> + 'a {
        let own = move |(_, value): &(usize, &Value)| value.measure == measure && !value.is_place;
        self.values.iter().enumerate().filter(own).map(|(number, _)| number)
    }

    /// Whether one of these has columns.
    pub(crate) fn asks(&self, wanted: &[Of]) -> bool {
        self.asked.iter().any(|of| wanted.contains(of))
    }
}

impl<'a> Builder<'a> {
    /// No columns yet; there is little to measure where the mechanism can't be decomposed into groups.
    fn of(mechanism: &'a Mechanism, options: &Options, reach: Reach) -> Self {
        let mut to = Self {
            mechanism,
            schema: Schema::new(mechanism),
            wanted: Wanted::default(),
            balances: false,
            has_groups: false,
            joints: Vec::new(),
            reach,
            whole: false,
            layout: Layout::default(),
        };
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

    /// Adds columns of the same things, one thing after the other.
    fn add(&mut self, of: Of, columns: &[MeasureColumn]) {
        let measurands = self.measurands(of);
        self.layout.asked.extend((!measurands.is_empty()).then_some(of));
        for Measurand { prefix, column, source } in measurands {
            let of = match source {
                Source::Statistic(what) => self.gather(what),
                Source::Nth(nth) => nth,
            };
            for MeasureColumn { measure, word, unit, find, .. } in columns {
                let unit = match *unit {
                    In::Unit(unit) => unit,
                    In::Coordinate => catalogue::unit(&self.schema, Column::COORDINATE),
                    In::Own => catalogue::unit(&self.schema, column),
                    In::Quantity(of) => catalogue::unit(&self.schema, Column::of(of, column.owner)),
                };
                let name = unit.column(format!("{prefix}{word}"));
                let is_place = word.ends_with("_at");
                self.layout.values.push(Value { measure, is_place, name, of, find: *find });
            }
        }
    }

    /// What has columns.
    fn measurands(&self, of: Of) -> Vec<Measurand> {
        let (motion, drive) = (&self.mechanism.motion, self.mechanism.drive.as_ref());
        let is_steady = matches!(motion, Some(Motion::Steady { .. }));
        let is_driven = |by: fn(&Drive) -> bool| is_steady && drive.is_some_and(by);
        let has_groups = self.has_groups && (self.whole || self.reach.moves_anything());
        let one = |is_there: bool, column, source| {
            let measurand = is_there.then(|| Measurand { prefix: String::new(), column, source });
            measurand.into_iter().collect()
        };
        let whole = |is_there| one(is_there, Column::COORDINATE, Source::Nth(0));
        let least = |what| one(has_groups, Column::COORDINATE, Source::Statistic(what));
        // Over time each drive has a load.
        let drives =
            (0..self.schema.drives.len()).map(|drive| Column::of(Quantity::Balancing, Owner::Drive(drive)));
        let balancing = |what: fn(Column) -> Gathered| {
            let of_drive = |column: Column| Measurand {
                prefix: format!("{}_", self.schema.name(column.owner)),
                column,
                source: Source::Statistic(what(column)),
            };
            if self.schema.drives.is_empty() {
                return one(self.balances, Column::BALANCING, Source::Statistic(what(Column::BALANCING)));
            }
            drives.clone().filter(|_| self.balances).map(of_drive).collect()
        };
        match of {
            Of::Regime => whole(is_steady),
            Of::Flywheel => whole(is_driven(|drive| drive.flywheel.is_some())),
            Of::Motor => whole(is_driven(|drive| matches!(drive.torque, Torque::Motor { .. }))),
            Of::Torque => {
                whole(is_driven(|drive| matches!(drive.torque, Torque::Balance | Torque::Constant(_))))
            }
            Of::End => whole(matches!(motion, Some(Motion::Transient { .. }))),
            Of::Friction => whole(!self.mechanism.frictions.is_empty()),
            Of::Shaking => whole(true),
            Of::Health => least(Gathered::Health),
            Of::Transmission => least(Gathered::Transmission),
            Of::Balancing => balancing(Gathered::Column),
            Of::BalancingSize => balancing(Gathered::BalancingSize),
            Of::Reactions => self.joints.iter().flat_map(|joint| self.reactions(joint)).collect(),
            Of::Targets => {
                let targets = self.layout.targets.iter().enumerate().map(|(nth, (_, point, _))| {
                    let prefix = format!("{point}_distance_{}_", nth + 1);
                    Measurand { prefix, column: Column::COORDINATE, source: Source::Nth(nth) }
                });
                targets.collect()
            }
            Of::Points | Of::Slides | Of::Links | Of::Moving | Of::Parts => {
                let Wanted { points, slides, links, .. } = &self.wanted;
                let points = points.iter().map(|(point, _)| Owner::Point(*point));
                let parts = points.chain(slides.iter().copied().map(Owner::Slide));
                let parts = parts.chain(links.iter().copied().map(Owner::Link)).enumerate();
                parts.flat_map(|(nth, owner)| self.part(of, nth, owner)).collect()
            }
        }
    }

    /// The force of a pin or slide, and the moment of a slide.
    fn reactions(&self, joint: &Joint) -> Vec<Measurand> {
        let owner = Owner::Pair(joint.id);
        let reaction = |word, quantity, what| Measurand {
            prefix: format!("reaction_{}_{word}", self.schema.name(owner)),
            column: Column::of(quantity, owner),
            source: Source::Statistic(what),
        };
        let force = || reaction("", Quantity::Force, Gathered::Force(joint.clone()));
        let moment = || reaction("moment_", Quantity::Moment, Gathered::Moment(joint.clone()));
        match joint.id {
            _ if !self.has(owner) => Vec::new(),
            PairId::Pin(_) => vec![force()],
            PairId::Slide(_) => vec![force(), moment()],
        }
    }

    /// Where a part is, or how it moves; `nth`: its number among points, then slides, then links.
    fn part(&self, of: Of, nth: usize, owner: Owner) -> Vec<Measurand> {
        let place = Column::of(Quantity::Transfer(0), owner);
        let [x, y] = Column::vector(Quantity::Transfer(0), owner);
        let measurand = |word, column, source| {
            let prefix = format!("{}{word}", self.schema.name(owner));
            Measurand { prefix, column, source }
        };
        let gathered = |word, of| measurand(word, of, Source::Statistic(Gathered::Column(of)));
        match (of, owner) {
            (Of::Parts, _) | (Of::Moving, Owner::Slide(_) | Owner::Link(_)) => {
                vec![measurand("_", place, Source::Nth(nth))]
            }
            _ if !self.has(owner) => Vec::new(),
            (Of::Points, Owner::Point(_)) => vec![gathered("_x_", x), gathered("_y_", y)],
            (Of::Slides, Owner::Slide(_)) => vec![gathered("_", place)],
            (Of::Links, Owner::Link(_)) => vec![gathered("_angle_", place)],
            _ => Vec::new(),
        }
    }

    /// Whether the number of a part is of interest.
    fn has(&self, owner: Owner) -> bool {
        self.whole || self.reach.has(owner, self.mechanism)
    }

    /// The number of a statistic.
    fn gather(&mut self, what: Gathered) -> usize {
        let gathered = &mut self.layout.gathered;
        gathered.iter().position(|known| *known == what).unwrap_or_else(|| {
            gathered.push(what);
            gathered.len() - 1
        })
    }

    /// Adds the columns of the positions under a key of the JSON, as they are.
    fn add_plain(&mut self, schema: &Schema, key: &str) {
        let is_there = |column: &&Column| {
            let path = catalogue::path(schema, **column).unwrap_or_default();
            path.first().is_some_and(|step| *step == PathStep::Key(key.into()))
        };
        for column in schema.columns().iter().filter(is_there) {
            for (word, find) in PLAIN {
                if let Some(name) = catalogue::csv_of(schema, *column, word) {
                    let of = self.gather(Gathered::Plain(*column));
                    // Of these, conditions name the columns.
                    self.layout.values.push(Value { measure: "", is_place: false, name, of, find });
                }
            }
        }
    }
}
