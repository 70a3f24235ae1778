//! A key that follows a parameter.

use assur_scene::edit::{ParsedText, decimal};
use assur_scene::{Reading, quantity};
use assur_words::{Describe, name, text};

use crate::axis::Axis;
use crate::vary::Written;
use crate::{SweepError, Tie, Vary};
/// How a parameter follows another one.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Following {
    /// The number of that parameter.
    pub(crate) leader: usize,
    /// By which its value is multiplied.
    pub(crate) factor: f64,
    /// What is added, in the unit of that parameter.
    pub(crate) added: f64,
    /// The tie behind the key, as it is written.
    pub(crate) text: String,
}

impl Axis {
    /// Finds a key that follows one of the parameters; its ends follow from theirs.
    pub(crate) fn tied(
        tie: &Tie,
        parameters: &[Self],
        document: &ParsedText<'_>,
        scene: &Reading,
    ) -> Result<Self, SweepError> {
        let fault = |problem| SweepError::vary(tie.key.to_string(), problem);
        let follows = tie.follows.to_string();
        let number = parameters.iter().position(|axis| axis.key == follows);
        let Some(number) = number else {
            return Err(fault(text!("sweep-tie-not-varied", key = name(follows))));
        };
        let leader = &parameters[number];
        if leader.words().is_some() {
            return Err(fault(text!("sweep-tie-to-texts", key = name(follows))));
        }
        let factor = tie.factor.unwrap_or(1.0);
        let added = leader.added(tie)?;
        let [from, to] = [leader.from, leader.to].map(|end| leader.shown(decimal(end * factor + added)));
        let values = Written::Range { from, to, count: 1 };
        let axis = Self::of(&Vary { key: tie.key.clone(), values }, document, scene)?;
        if let ([Some(own), Some(other)], None) = ([axis.measures, leader.measures], tie.factor)
            && own != other
        {
            let [own, other] = [own, other].map(|kind| kind.describe());
            return Err(fault(text!("sweep-tie-other-quantity", own, key = name(follows), other)));
        }
        let constant = tie.added.as_ref().map(|added| format!("+{added}")).unwrap_or_default();
        let text = format!("{follows}*{factor}{constant}");
        Ok(axis.following(Following { leader: number, factor, added, text }))
    }

    /// What a tie adds to a multiple of this parameter, in the unit of its values.
    fn added(&self, tie: &Tie) -> Result<f64, SweepError> {
        let Some(added) = &tie.added else { return Ok(0.0) };
        let si = match self.measures {
            Some(dimension) => quantity(added, dimension).map_err(|error| error.describe()),
            None => added.parse().map_err(|_| text!("sweep-no-number", text = name(added.clone()))),
        };
        let si: f64 = si.map_err(|problem| SweepError::vary(tie.key.to_string(), problem))?;
        Ok(si / self.si(1.0))
    }
}
