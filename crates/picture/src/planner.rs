//! The plans of the position that is shown: computed when a view needs them, the last ones are cached.

use std::cell::RefCell;
use std::ops::Range;
use std::sync::Arc;

use assur_analysis::Calculation;
use assur_diagram::{DiagramError, PlanSheet, Split};
use assur_force::Construction;

/// Positions whose plans are remembered: two beside each other are drawn together.
const KEPT: usize = 2;

/// The plans of one position.
#[derive(Debug)]
pub struct Plans {
    /// Polygons, plans of velocities and accelerations, reactions by cause; or why there are none.
    pub sheet: Result<PlanSheet, DiagramError>,
    /// The constructions on paper, each with the name of its force analyzer.
    pub constructions: Vec<(&'static str, Construction)>,
    position: usize,
}

impl Plans {
    /// Number of steps of all constructions.
    pub fn step_count(&self) -> usize {
        self.constructions.iter().map(|(_, construction)| construction.steps.len()).sum()
    }

    /// The reactions by cause; `None` where there are none.
    pub fn by_cause(&self) -> Option<&Split> {
        self.sheet.as_ref().ok()?.by_cause.as_ref()
    }

    /// The numbers of the steps of a construction among the steps of all.
    pub fn steps_of(&self, construction: usize) -> Range<usize> {
        let count = |(_, construction): &(&str, Construction)| construction.steps.len();
        let before = self.constructions.iter().take(construction).map(count).sum();
        before..before + self.constructions.get(construction).map_or(0, count)
    }
}

/// Gives the plans of any position, of a transient motion those of any sample.
#[derive(Debug)]
pub struct Planner {
    calculation: Arc<Calculation>,
    /// The last positions, at most [`KEPT`], because a view is drawn many times.
    kept: RefCell<Vec<Arc<Plans>>>,
}

impl Planner {
    /// Of this calculation.
    pub fn new(calculation: Arc<Calculation>) -> Self {
        Self { calculation, kept: RefCell::default() }
    }

    /// The calculation whose positions they are, of the whole mechanism.
    pub fn calculation(&self) -> &Arc<Calculation> {
        &self.calculation
    }

    /// The plans of a position.
    pub fn at(&self, position: usize) -> Arc<Plans> {
        let mut kept = self.kept.borrow_mut();
        if let Some(plans) = kept.iter().find(|plans| plans.position == position) {
            return Arc::clone(plans);
        }
        let (sheet, constructions) = match self.calculation.sample(position).0 {
            Some(state) => {
                (self.calculation.sheet_in(&state, true), self.calculation.constructions_in(&state))
            }
            None => (self.calculation.sheet(position), self.calculation.constructions(position)),
        };
        let constructions = constructions.unwrap_or_default();
        let plans = Arc::new(Plans { sheet, constructions, position });
        kept.insert(0, Arc::clone(&plans));
        kept.truncate(KEPT);
        plans
    }
}
