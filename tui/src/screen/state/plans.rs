//! The plans and the working of the position that is shown: computed when a view needs them, the last ones are cached.

use std::cell::RefCell;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

use assur_analysis::Calculation;
use assur_diagram::{DiagramError, PlanSheet};
use assur_force::Construction;
use assur_working::WorkingError;
use assur_worksheet::Section;

use crate::working;

/// Positions whose plans are remembered: two beside each other are drawn together.
const KEPT: usize = 2;

/// The plans of one position.
#[derive(Debug)]
pub(crate) struct Plans {
    /// Polygons, plans of velocities and accelerations, reactions by cause; or why there are none.
    pub(crate) sheet: Result<PlanSheet, DiagramError>,
    /// The constructions on paper, each with the name of its force analyzer.
    pub(crate) constructions: Vec<(&'static str, Construction)>,
    calculation: Arc<Calculation>,
    position: usize,
    working: OnceLock<Result<Vec<Section>, WorkingError>>,
}

impl Plans {
    /// Number of steps of all constructions.
    pub(crate) fn step_count(&self) -> usize {
        self.constructions.iter().map(|(_, construction)| construction.steps.len()).sum()
    }

    /// The numbers of the steps of a construction among the steps of all.
    pub(crate) fn steps_of(&self, construction: usize) -> Range<usize> {
        let count = |(_, construction): &(&str, Construction)| construction.steps.len();
        let before = self.constructions.iter().take(construction).map(count).sum();
        before..before + self.constructions.get(construction).map_or(0, count)
    }

    /// Every equation of the position with its numbers; or why there are none.
    pub(crate) fn working(&self) -> &Result<Vec<Section>, WorkingError> {
        self.working.get_or_init(|| {
            working::of_position(&self.calculation, self.position).map(|working| working.sections)
        })
    }
}

/// Gives the plans of any position.
#[derive(Debug)]
pub(crate) struct Planner {
    calculation: Arc<Calculation>,
    /// The last positions, at most [`KEPT`], because a view is drawn many times.
    kept: RefCell<Vec<Arc<Plans>>>,
}

impl Planner {
    pub(crate) fn new(calculation: Arc<Calculation>) -> Self {
        Self { calculation, kept: RefCell::default() }
    }

    /// The calculation whose positions they are, of the whole mechanism.
    pub(crate) fn calculation(&self) -> &Arc<Calculation> {
        &self.calculation
    }

    /// The plans of a position.
    pub(crate) fn at(&self, position: usize) -> Arc<Plans> {
        let mut kept = self.kept.borrow_mut();
        if let Some(plans) = kept.iter().find(|plans| plans.position == position) {
            return Arc::clone(plans);
        }
        let plans = Arc::new(Plans {
            sheet: self.calculation.sheet(position),
            constructions: self.calculation.constructions(position).unwrap_or_default(),
            calculation: Arc::clone(&self.calculation),
            position,
            working: OnceLock::new(),
        });
        kept.insert(0, Arc::clone(&plans));
        kept.truncate(KEPT);
        plans
    }
}
