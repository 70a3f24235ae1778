//! The plans of the position that is shown: computed when a view needs them, the last ones are cached.

use std::cell::RefCell;
use std::sync::Arc;

use assur_analysis::Calculation;
use assur_diagram::{DiagramError, Sheet};
use assur_force::Construction;

/// The plans of one position.
#[derive(Debug)]
pub(crate) struct Plans {
    /// Polygons, plans of velocities and accelerations, reactions by cause; or why there are none.
    pub(crate) sheet: Result<Sheet, DiagramError>,
    /// The constructions on paper.
    pub(crate) constructions: Vec<Construction>,
}

impl Plans {
    /// Number of steps of all constructions.
    pub(crate) fn step_count(&self) -> usize {
        self.constructions.iter().map(|construction| construction.steps.len()).sum()
    }
}

/// Gives the plans of any position.
#[derive(Debug)]
pub(crate) struct Planner {
    calculation: Arc<Calculation>,
    /// The last position, cached because a view is drawn many times.
    kept: RefCell<Option<(usize, Arc<Plans>)>>,
}

impl Planner {
    pub(crate) fn new(calculation: Arc<Calculation>) -> Self {
        Self { calculation, kept: RefCell::new(None) }
    }

    /// The plans of a position.
    pub(crate) fn at(&self, position: usize) -> Arc<Plans> {
        let mut kept = self.kept.borrow_mut();
        if let Some((known, plans)) = &*kept
            && *known == position
        {
            return Arc::clone(plans);
        }
        let plans = Arc::new(Plans {
            sheet: self.calculation.sheet(position),
            constructions: self.calculation.constructions(position).unwrap_or_default(),
        });
        *kept = Some((position, Arc::clone(&plans)));
        plans
    }
}
