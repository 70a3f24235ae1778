//! The results of the analysis, with their series.

use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;

use assur_analysis::results::{Analysis, Checks, Column, Edges, Quantity, Table, Turn};
use assur_analysis::{AnalysisError, Calculation, Options, Watch};
use assur_book::{Fact, Range};
use assur_kinematics::Linkage;
use assur_report::topic::{self, About};

use crate::gather::{Gather, Reaction};
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
    ranges: RefCell<HashMap<Column, Option<Range>>>,
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
        let ranges = RefCell::default();
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
            ranges,
        })
    }

    /// What a quantity reaches, between the positions too; `None` where no position has a value.
    pub fn range(&self, series: &Series) -> Option<Range> {
        let find = || assur_book::range(self.plans.calculation(), &series.course, series.column);
        *self.ranges.borrow_mut().entry(series.column).or_insert_with(find)
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
