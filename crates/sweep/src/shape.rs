//! That a text in place of another leaves the mechanism its parts and the rows their columns.

use assur_kinematics::decompose;
use assur_mechanism::Mechanism;
use assur_words::{name, text};

use crate::SweepError;
use crate::axis::Axis;
use crate::layout::Layout;
use crate::variants::Variants;

/// Parts, groups, coordinate and columns of a mechanism.
#[derive(PartialEq)]
struct Shape {
    parts: [usize; 4],
    groups: Option<String>,
    is_timed: bool,
    columns: Vec<String>,
}

impl Shape {
    fn of(mechanism: &Mechanism, layout: &Layout) -> Self {
        let Mechanism { links, points, slides, loads, .. } = mechanism;
        let motor = layout.has_motor.then(|| "motor".to_owned());
        Self {
            parts: [links.len(), points.len(), slides.len(), loads.len()],
            groups: decompose(mechanism).ok().map(|structure| structure.formula.as_str().to_owned()),
            is_timed: mechanism.input.kind().is_time(),
            columns: layout.values.iter().map(|value| value.name.clone()).chain(motor).collect(),
        }
    }
}

/// Refuses texts with which the mechanism has other parts, groups or columns than with the first one that the reader accepts.
pub(crate) fn same_shape(
    axes: &[Axis],
    variants: &Variants,
    layout: &impl Fn(&Mechanism) -> Result<Layout, SweepError>,
) -> Result<(), SweepError> {
    let mut numbers: Vec<f64> = axes.iter().map(|axis| axis.from).collect();
    for (index, axis) in axes.iter().enumerate().filter(|(_, axis)| axis.words().is_some()) {
        let mut first: Option<Shape> = None;
        for number in axis.compared() {
            numbers[index] = number;
            let Ok(mechanism) = variants.read(axes, &numbers) else { continue };
            let shape = Shape::of(&mechanism, &layout(&mechanism)?);
            if first.as_ref().is_some_and(|first| *first != shape) {
                let word = name(axis.shown(number));
                return Err(SweepError::vary(&axis.key, text!("sweep-other-shape", word)));
            }
            first.get_or_insert(shape);
        }
        numbers[index] = axis.from;
    }
    Ok(())
}
