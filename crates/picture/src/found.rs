//! The results of the analysis, with their columns as series with names: rates, reduction, reactions, loads, residuals.

use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;

use assur_analysis::results::{Analysis, Checks, Column, Edges, Owner, Part, Quantity, Table, Turn};
use assur_analysis::{AnalysisError, Calculation, Options, Watch};
use assur_book::{Course, Fact, ROUNDING, Range, catalogue};
use assur_kinematics::Linkage;
use assur_mechanism::{LinkId, Named, PairId};
use assur_report::topic::{self, About, Event};
use assur_words::Text;

use crate::{Planner, Series};

/// Over time the content of the motion view, of each drive.
const OF_DRIVES: [Quantity; 2] = [Quantity::Transfer(0), Quantity::Balancing];

/// The content of the motion view.
const MOTION: [Quantity; 5] = [
    Quantity::Velocity,
    Quantity::Acceleration,
    Quantity::ReducedInertia,
    Quantity::ReducedInertiaDerivative,
    Quantity::ReducedMoment,
];

/// The results of the analysis of a scene.
#[derive(Debug)]
pub struct Found {
    /// The compiled mechanism, with all its groups.
    pub linkage: Arc<Linkage>,
    /// Name of the force analyzer.
    pub analyzer: String,
    /// The results; their checks are empty until they are done.
    pub analysis: Analysis,
    /// The samples of a transient motion, which are shown in place of the positions; `None` of another motion.
    pub samples: Option<Table>,
    /// What lies between and after the positions or samples, through which the curves lead.
    pub edges: Edges,
    /// What is asked for first, each with what it is about; without the checks until they are done.
    pub results: Vec<(About, Fact)>,
    /// What happens over the cycle.
    pub events: Vec<Event>,
    /// Every quantity of the results over the positions.
    pub series: Vec<Series>,
    /// Reactions, and the balancing load as the last.
    pub reactions: Vec<Reaction>,
    /// The plans of the positions.
    pub plans: Planner,
    /// Indices in `series` of the content of the motion view.
    pub motion: Vec<usize>,
    /// What quantities reach, kept because a view is drawn many times.
    reach: RefCell<HashMap<Column, Option<Range>>>,
}

impl Found {
    /// Calculates what a scene requests, and gathers its series; `linkage`: that of the calculation, with all groups.
    pub fn of(
        mut calculation: Calculation,
        linkage: Arc<Linkage>,
        options: &Options,
        watch: &mut Watch<'_>,
    ) -> Result<Self, AnalysisError> {
        calculation.tells_poles = true;
        let mut analysis = calculation.analyze(watch)?;
        let analyzer = calculation.analyzer.map_or("", |plugin| plugin.name).to_owned();
        let edges = calculation.edges(&analysis.positions);
        analysis.peaks = assur_book::peaks(&calculation, &analysis.positions, &edges);
        let mut results = topic::results(&analysis, &calculation.linkage);
        // The view of the structure has it.
        results.retain(|(_, fact)| fact.id != "fact-formula");
        let events = topic::events(&analysis, &assur_analysis::modes(&linkage));
        // The whole mechanism is checked and has plans, whatever results the scene requests.
        let whole =
            if calculation.plan.all { None } else { calculation.whole(Arc::clone(&linkage), options).ok() };
        let plans = Planner::new(Arc::new(whole.unwrap_or(calculation)));
        let over_time = plans.calculation().over_time().filter(|(samples, _)| !samples.is_empty());
        let (samples, edges) = match over_time {
            Some((samples, edges)) => (Some(samples), edges),
            None => (None, edges),
        };
        let (table, over) = rows(samples.as_ref(), &analysis.positions);
        let mut series = Vec::new();
        gather(&mut series, table, &edges, over);
        mark_rounding(&mut series);
        let reactions = reactions(&series, table);
        let of_input = |of: &Quantity| index(&series, Column::of(*of, Owner::Input));
        let of_drives = |of: &Quantity| {
            let drives = 0..analysis.positions.schema().drives.len();
            drives
                .filter_map(|drive| index(&series, Column::of(*of, Owner::Drive(drive))))
                .collect::<Vec<_>>()
        };
        let motion = MOTION.iter().filter_map(of_input).chain(OF_DRIVES.iter().flat_map(of_drives)).collect();
        let reach = RefCell::default();
        Ok(Self {
            linkage,
            analyzer,
            analysis,
            samples,
            edges,
            results,
            events,
            series,
            reactions,
            plans,
            motion,
            reach,
        })
    }

    /// What a quantity reaches, between the positions too; `None` where no position has a value.
    pub fn range(&self, series: &Series) -> Option<Range> {
        // Between the samples of a motion over time nothing is looked for.
        let find = || match self.samples {
            Some(_) => Range::of_course(&series.course),
            None => assur_book::range(self.plans.calculation(), &series.course, series.column),
        };
        *self.reach.borrow_mut().entry(series.column).or_insert_with(find)
    }

    /// A local extreme of a series as it is found between the positions too.
    pub fn extreme(&self, series: &Series, turn: Turn) -> Turn {
        if self.samples.is_some() {
            return turn;
        }
        assur_book::extreme(self.plans.calculation(), &series.course, series.column, turn)
    }

    /// The rows over which everything is drawn, and the column of their places: positions over the coordinate, or samples over time.
    pub fn rows(&self) -> (&Table, Column) {
        rows(self.samples.as_ref(), &self.analysis.positions)
    }

    /// Adds the checks, and the residuals as series.
    pub fn take_checks(&mut self, checks: Checks) {
        self.analysis.add_checks(checks);
        self.results.extend(topic::checks_fact(&self.analysis).map(|fact| (About::Checks, fact)));
        let (table, over) = rows(self.samples.as_ref(), &self.analysis.positions);
        gather(&mut self.series, table, &self.edges, over);
    }

    /// The balancing load over the positions.
    pub fn balancing(&self) -> Option<&Series> {
        let balancing = self.reactions.iter().find(|reaction| reaction.of.is_none())?;
        self.series.get(*balancing.series.first()?)
    }
}

/// The force that a pair exerts on one link, as indices of series.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reaction {
    /// The pin or slide, and the link on which it acts; `None` for the balancing load.
    pub of: Option<(Named<PairId>, Named<LinkId>)>,
    /// `A on crank`, `balancing load`.
    pub name: Text,
    /// Fx, Fy, modulus; for the balancing load its one series.
    pub series: Vec<usize>,
    /// Moment of a slide.
    pub moment: Option<usize>,
}

fn rows<'a>(samples: Option<&'a Table>, positions: &'a Table) -> (&'a Table, Column) {
    samples.map_or((positions, Column::COORDINATE), |samples| (samples, Column::TIME))
}

/// Adds the columns of the positions that are not there yet, in the order of the results: a whole quantity, or both projections of a
/// vector and its modulus.
fn gather(series: &mut Vec<Series>, table: &Table, edges: &Edges, over: Column) {
    let schema = table.schema();
    let shown = catalogue::reactions(schema);
    for column in schema.columns().iter().filter(|column| column.cause.is_none()) {
        let is_shown = match (column.quantity, column.owner) {
            // Transfer functions are those of the scene.
            (Quantity::Transfer(_), Owner::Drive(_)) => true,
            (Quantity::Transfer(_), _) => false,
            // Of the two forces of a pair one is shown.
            (Quantity::Force, Owner::PairOn(pair, link)) => shown.contains(&(pair, link)),
            _ => catalogue::path(schema, *column).is_some(),
        };
        let whole = column.part(Part::Whole);
        if !is_shown || series.iter().any(|series| series.column.part(Part::Whole) == whole) {
            continue;
        }
        let parts: &[Part] =
            if *column == whole { &[Part::Whole] } else { &[Part::X, Part::Y, Part::Modulus] };
        // Residuals are those of positions alone, so that nothing interrupts their curve between them.
        let edges = Some(edges).filter(|_| !matches!(column.quantity, Quantity::Residual(_)));
        series.extend(parts.iter().filter_map(|part| {
            let course = Course::of(table, edges, over, whole.part(*part));
            (!course.is_empty()).then(|| Series::of(schema, whole.part(*part), course, 0.0))
        }));
    }
}

/// The place of a column among series.
fn index(series: &[Series], column: Column) -> Option<usize> {
    series.iter().position(|series| series.column == column)
}

/// Force and moment of every pair, then the balancing load.
fn reactions(series: &[Series], table: &Table) -> Vec<Reaction> {
    let schema = table.schema();
    let mut found = Vec::new();
    for (id, on) in catalogue::reactions(schema) {
        let pair = schema.named(Owner::Pair(id)).map(|name| Named { id, name: name.clone() });
        let of = pair.map(|pair| (pair, Named { id: on, name: schema.links[on].clone() }));
        let force = Column::of(Quantity::Force, Owner::PairOn(id, on));
        let parts = [Part::X, Part::Y, Part::Modulus].map(|part| index(series, force.part(part)));
        let moment = index(series, Column::of(Quantity::Moment, Owner::Pair(id)));
        if let [Some(x), Some(y), Some(modulus)] = parts {
            let (name, series) = (catalogue::owner(schema, force), vec![x, y, modulus]);
            found.push(Reaction { of, name, series, moment });
        }
    }
    // The balancing load, or over time that of each drive.
    for owner in schema.owners(Quantity::Balancing) {
        let column = Column::of(Quantity::Balancing, owner);
        let owner = catalogue::owner(schema, column);
        let name = if owner.is_empty() { catalogue::kind(column) } else { owner };
        found.extend(index(series, column).map(|index| Reaction {
            of: None,
            name,
            series: vec![index],
            moment: None,
        }));
    }
    found
}

/// Raises the limits below which values count as zero to what is rounding beside the greatest value in their unit.
fn mark_rounding(series: &mut [Series]) {
    let mut greatest: HashMap<&str, f64> = HashMap::new();
    for one in &*series {
        let most = greatest.entry(one.unit.name).or_default();
        *most = most.max(one.course.size());
    }
    let inertia = index(series, Column::of(Quantity::ReducedInertia, Owner::Input));
    let range = inertia.and_then(|index| series[index].course.highest_and_lowest());
    let is_constant =
        range.is_some_and(|[[_, most], [_, least]]| most - least <= assur_number::ROUNDING * most);
    for one in series.iter_mut().filter(|one| !catalogue::is_ratio(one.column)) {
        one.floor = one.floor.max(ROUNDING * greatest[one.unit.name]);
        // J' of a J that is constant to its rounding is rounding.
        if is_constant && one.column.quantity == Quantity::ReducedInertiaDerivative {
            one.floor = one.floor.max(one.course.size());
        }
    }
}
