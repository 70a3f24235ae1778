//! The plans of the position that is shown: asked of the study when a view wants them, the last ones are kept.

use std::cell::RefCell;
use std::sync::Arc;

use assur_analysis::Calculation;
use assur_diagram::{DiagramError, Sheet};
use assur_force::Construction;

use super::draw::scale::Bounds;

/// The plans of one position.
#[derive(Debug)]
pub(crate) struct Plans {
    /// Polygons, plans of velocities and accelerations, reactions by cause; or why there are none.
    pub(crate) sheet: Result<Sheet, DiagramError>,
    /// The constructions on paper.
    pub(crate) constructions: Vec<Construction>,
}

/// Gives the plans of any position.
#[derive(Debug)]
pub(crate) struct Planner {
    study: Arc<Calculation>,
    /// The last position, since a view is drawn many times.
    kept: RefCell<Option<(usize, Arc<Plans>)>>,
}

impl Planner {
    pub(crate) fn new(study: Arc<Calculation>) -> Self {
        Self { study, kept: RefCell::new(None) }
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
            sheet: self.study.sheet(position),
            constructions: self.study.constructions(position).unwrap_or_default(),
        });
        *kept = Some((position, Arc::clone(&plans)));
        plans
    }
}

/// Box around points.
pub(crate) fn bounds(points: impl Iterator<Item = [f64; 2]>) -> Bounds {
    let mut bounds = Bounds::EMPTY;
    points.for_each(|at| bounds.add(at));
    bounds
}
