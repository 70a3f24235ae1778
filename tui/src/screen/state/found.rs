//! The results of the analysis, with their series.

use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;

use assur_analysis::results::{Analysis, Checks, Column, Edges, Quantity, Table};
use assur_analysis::{AnalysisError, Options, Watch};
use assur_book::{Fact, Range};
use assur_report::topic::{self, About};

use super::gather::{Gather, Reaction};
use super::plans::Planner;
use super::scene::Scene;
use crate::session::Session;
use crate::verdict::Verdict;
use assur_picture::{Results, Series};

#[derive(Debug)]
pub(crate) struct Found {
    /// Name of the force analyzer.
    pub(crate) analyzer: String,
    /// Its checks are empty until they are done.
    pub(crate) analysis: Analysis,
    /// What lies between and after the positions, through which the curves lead.
    pub(crate) edges: Edges,
    /// What is asked for first, each with what it is about; without the checks until they are done.
    pub(crate) results: Vec<(About, Fact)>,
    /// What there was just before the samples at which the motion comes to rest.
    pub(crate) stops: Table,
    pub(crate) verdict: Verdict,
    pub(crate) series: Vec<Series>,
    /// Reactions, and the balancing load as the last.
    pub(crate) reactions: Vec<Reaction>,
    pub(crate) plans: Planner,
    /// Indices in `series` of the content of the motion view.
    pub(crate) motion: Vec<usize>,
    /// What quantities reach, kept because a view is drawn many times.
    ranges: RefCell<HashMap<Column, Option<Range>>>,
}

impl Found {
    /// Calculates what a scene requests, and gathers its series.
    ///
    /// # Errors
    ///
    /// [`AnalysisError`] where the scene can't be calculated, or where `watch` breaks.
    pub(crate) fn of(
        session: &Session,
        options: &Options,
        watch: &mut Watch<'_>,
    ) -> Result<Self, AnalysisError> {
        let calculation = session.calculation(options, watch)?;
        let mut analysis = calculation.analyze(watch)?;
        let analyzer = calculation.analyzer.map_or("", |plugin| plugin.name).to_owned();
        let edges = calculation.edges(&analysis.positions);
        analysis.peaks = assur_book::peaks(&calculation, &analysis.positions, &edges);
        let mut results = topic::results(&analysis, &calculation.linkage);
        // The view of the structure has it.
        results.retain(|(_, fact)| fact.id != "fact-formula");
        let stops = calculation.stops();
        // The whole mechanism is checked and has plans, whatever results the scene requests.
        let whole = if calculation.plan.all {
            None
        } else {
            session.calculation(&Options { whole: true, ..options.clone() }, watch).ok()
        };
        let plans = Planner::new(Arc::new(whole.unwrap_or(calculation)));
        let mut gather = Gather { table: &analysis.positions, edges: &edges, series: Vec::new() };
        let motion = gather.motion();
        gather.rates();
        let reactions = gather.reactions();
        gather.others();
        gather.mark_rounding();
        let series = gather.series;
        let verdict = Verdict::of(&analysis, plans.calculation(), None);
        let ranges = RefCell::default();
        Ok(Self {
            analyzer,
            analysis,
            edges,
            results,
            stops,
            verdict,
            series,
            reactions,
            plans,
            motion,
            ranges,
        })
    }

    /// What pictures are drawn from.
    pub(crate) fn results<'a>(&'a self, scene: &'a Scene) -> Results<'a> {
        Results { linkage: &scene.linkage, analysis: &self.analysis, edges: &self.edges, stops: &self.stops }
    }

    /// What a quantity reaches, between the positions too; `None` where no position has a value.
    pub(crate) fn range(&self, series: &Series) -> Option<Range> {
        let find = || assur_book::range(self.plans.calculation(), &series.course, series.column);
        *self.ranges.borrow_mut().entry(series.column).or_insert_with(find)
    }

    /// Adds the checks, and the residuals as series.
    pub(crate) fn take_checks(&mut self, checks: Checks) {
        self.analysis.add_checks(checks);
        self.results.extend(topic::checks_fact(&self.analysis).map(|fact| (About::Checks, fact)));
        self.verdict = Verdict::of(&self.analysis, self.plans.calculation(), None);
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
    pub(crate) fn balancing(&self) -> Option<&Series> {
        let balancing = self.reactions.iter().find(|reaction| reaction.of.is_none())?;
        self.series.get(*balancing.series.first()?)
    }
}
