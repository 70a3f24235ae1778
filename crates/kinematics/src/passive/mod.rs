//! Passive links and pairs: those that repeat constraints of others.
//!
//! By count such a part takes a degree of freedom away, by rank of the constraints it does not. Whether it does is a question of lengths, and of the whole
//! motion: in a dead center or at a change point the rank is smaller although nothing repeats. So a part is passive if the
//! mechanism without it has the same mobility and fewer surplus constraints, and if the part then fits in every position of the
//! cycle.

pub(crate) mod hang;
mod misfit;
mod search;

use std::f64::consts::{PI, TAU};

use assur_mechanism::{GROUND, Mechanism};
use assur_structure::{Structure, StructureError};

pub(crate) use misfit::misfits;
pub use misfit::{Closing, Misfit};

/// Slides that hold a link at two different angles, which no position can satisfy: a slide fixes the angle of one link to the other's.
fn angles_of_slides(mechanism: &Mechanism, links: &[String]) -> Option<StructureError> {
    /// Directions that differ by less are the same, rad: the rounding of angles in degrees.
    const SAME: f64 = 1e-9;
    let mut angles: Vec<Option<f64>> = vec![None; mechanism.links.len()];
    angles[GROUND] = Some(0.0);
    // Each round knows the angle of one link more, or all that slides tell.
    for _ in 0..mechanism.slides.len() {
        for slide in &mechanism.slides {
            let turn = slide.angle + slide.tilt;
            match (angles[slide.link], angles[slide.on]) {
                (Some(own), Some(on)) => {
                    let off = (on + turn - own + PI).rem_euclid(TAU) - PI;
                    if off.abs() > SAME {
                        return Some(StructureError::SlideAngles {
                            slide: Box::new(slide.name.clone()),
                            off: off.abs(),
                            tilt: (slide.tilt - off + PI).rem_euclid(TAU) - PI,
                            links: links.to_vec(),
                        });
                    }
                }
                (Some(own), None) => angles[slide.on] = Some(own - turn),
                (None, Some(on)) => angles[slide.link] = Some(on + turn),
                (None, None) => {}
            }
        }
    }
    None
}

/// Decomposes a mechanism into Assur groups, without its passive parts where it counts constraints that repeat others.
pub fn decompose(mechanism: &Mechanism) -> Result<Structure, StructureError> {
    match Structure::of(mechanism) {
        Err(StructureError::Surplus { counted, inputs, pairs, links, block, .. }) => {
            search::without_passive(mechanism).map_err(|why| {
                let angles = angles_of_slides(mechanism, &links);
                angles.unwrap_or(StructureError::Surplus {
                    counted,
                    inputs,
                    pairs,
                    links,
                    block,
                    why: why.into(),
                })
            })
        }
        found => found,
    }
}
