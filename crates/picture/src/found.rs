//! The results of the analysis, with their columns as series with names: rates, reduction, reactions, loads, residuals.

use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;

use assur_analysis::results::{Analysis, Checks, Column, Edges, Owner, Part, Quantity, Table, Turn};
use assur_analysis::{AnalysisError, Calculation, Options, Watch};
use assur_book::{Course, Fact, ROUNDING, Range, catalogue};
use assur_kinematics::Linkage;
use assur_mechanism::{LinkId, Named, PairId};
use assur_report::topic::{self, About};
use assur_words::Text;

use crate::{Planner, Series};

/// The results of the analysis of a scene.
#[derive(Debug)]
pub struct Found {
    /// The compiled mechanism, with all its groups.
    pub linkage: Arc<Linkage>,
    /// Name of the force analyzer.
    pub analyzer: String,
    /// The results; their checks are empty until they are done.
    pub analysis: Analysis,
    /// What lies between and after the positions, through which the curves lead.
    pub edges: Edges,
    /// What is asked for first, each with what it is about; without the checks until they are done.
    pub results: Vec<(About, Fact)>,
    /// What there was just before the samples at which the motion comes to rest.
    pub stops: Table,
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
        let stops = calculation.stops();
        // The whole mechanism is checked and has plans, whatever results the scene requests.
        let whole =
            if calculation.plan.all { None } else { calculation.whole(Arc::clone(&linkage), options).ok() };
        let plans = Planner::new(Arc::new(whole.unwrap_or(calculation)));
        let mut gather = Gather { table: &analysis.positions, edges: &edges, series: Vec::new() };
        let motion = gather.motion();
        gather.rates();
        let reactions = gather.reactions();
        gather.others();
        gather.mark_rounding();
        let series = gather.series;
        let reach = RefCell::default();
        Ok(Self {
            linkage,
            analyzer,
            analysis,
            edges,
            results,
            stops,
            series,
            reactions,
            plans,
            motion,
            reach,
        })
    }

    /// What a quantity reaches, between the positions too; `None` where no position has a value.
    pub fn range(&self, series: &Series) -> Option<Range> {
        let find = || assur_book::range(self.plans.calculation(), &series.course, series.column);
        *self.reach.borrow_mut().entry(series.column).or_insert_with(find)
    }

    /// A local extreme of a series as it is found between the positions too.
    pub fn extreme(&self, series: &Series, turn: Turn) -> Turn {
        assur_book::extreme(self.plans.calculation(), &series.course, series.column, turn)
    }

    /// Adds the checks, and the residuals as series.
    pub fn take_checks(&mut self, checks: Checks) {
        self.analysis.add_checks(checks);
        self.results.extend(topic::checks_fact(&self.analysis).map(|fact| (About::Checks, fact)));
        let table = &self.analysis.positions;
        let mut gather = Gather { table, edges: &self.edges, series: std::mem::take(&mut self.series) };
        let all = table.schema().columns().iter();
        let residuals = all.filter(|column| matches!(column.quantity, Quantity::Residual(_)));
        for column in residuals {
            gather.add(*column);
        }
        self.series = gather.series;
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

/// Series that are being collected from the positions of an analysis.
struct Gather<'a> {
    table: &'a Table,
    /// What lies between and after them.
    edges: &'a Edges,
    series: Vec<Series>,
}

impl Gather<'_> {
    /// Adds a column as a series if any position has it, and returns its index.
    fn add(&mut self, column: Column) -> Option<usize> {
        let course = Course::of(self.table, Some(self.edges), Column::COORDINATE, column);
        if course.is_empty() {
            return None;
        }
        self.series.push(Series::of(self.table.schema(), column, course, 0.0));
        Some(self.series.len() - 1)
    }

    /// Adds a whole quantity, or both projections of a vector and its modulus.
    fn add_all(&mut self, whole: Column) -> Vec<usize> {
        let is_vector = self.table.schema().find(whole.part(Part::X)).is_some();
        let parts: &[Part] = if is_vector { &[Part::X, Part::Y, Part::Modulus] } else { &[Part::Whole] };
        parts.iter().filter_map(|part| self.add(whole.part(*part))).collect()
    }

    fn motion(&mut self) -> Vec<usize> {
        let all = [
            Quantity::Velocity,
            Quantity::Acceleration,
            Quantity::ReducedInertia,
            Quantity::ReducedInertiaDerivative,
            Quantity::ReducedMoment,
        ];
        all.into_iter().filter_map(|quantity| self.add(Column::of(quantity, Owner::Input))).collect()
    }

    fn rates(&mut self) {
        let schema = self.table.schema();
        for quantity in [Quantity::Velocity, Quantity::Acceleration] {
            let owners = schema.owners(quantity).into_iter().filter(|owner| *owner != Owner::Input);
            owners.for_each(|owner| drop(self.add_all(Column::of(quantity, owner))));
        }
    }

    /// Force and moment of every pair, then the balancing load.
    fn reactions(&mut self) -> Vec<Reaction> {
        let schema = self.table.schema();
        let mut found = Vec::new();
        for (id, on) in catalogue::reactions(schema) {
            let pair = schema.named(Owner::Pair(id)).map(|name| Named { id, name: name.clone() });
            let of = pair.map(|pair| (pair, Named { id: on, name: schema.links[on].clone() }));
            let force = Column::of(Quantity::Force, Owner::PairOn(id, on));
            let (name, series) = (catalogue::owner(schema, force), self.add_all(force));
            let moment = self.add(Column::of(Quantity::Moment, Owner::Pair(id)));
            if series.len() == 3 {
                found.push(Reaction { of, name, series, moment });
            }
        }
        if let Some(index) = self.add(Column::BALANCING) {
            let name = catalogue::kind(Column::BALANCING);
            found.push(Reaction { of: None, name, series: vec![index], moment: None });
        }
        found
    }

    /// What else a position has: loads, inertia loads, friction, what shakes the ground, how well each group is conditioned.
    fn others(&mut self) {
        let schema = self.table.schema();
        for &column in schema.columns() {
            let whole = column.part(Part::Whole);
            // Transfer functions are those of the scene; of the two forces of a pair one is shown; shares have a view of their own.
            let is_elsewhere =
                matches!(column.quantity, Quantity::Transfer(_) | Quantity::Force) || column.cause.is_some();
            let is_new = self.series.iter().all(|series| series.column.part(Part::Whole) != whole);
            if is_new && !is_elsewhere && catalogue::path(schema, column).is_some() {
                self.add_all(whole);
            }
        }
    }

    /// Raises the limits below which values count as zero to what is rounding beside the greatest value in their unit.
    fn mark_rounding(&mut self) {
        let mut greatest: HashMap<&str, f64> = HashMap::new();
        for series in &self.series {
            let most = greatest.entry(&series.unit).or_default();
            *most = most.max(series.course.size());
        }
        let floors: Vec<f64> =
            self.series.iter().map(|series| ROUNDING * greatest[series.unit.as_str()]).collect();
        let of_units = self.series.iter_mut().zip(floors);
        for (series, floor) in of_units.filter(|(series, _)| !catalogue::is_ratio(series.column)) {
            series.floor = series.floor.max(floor);
        }
    }
}
