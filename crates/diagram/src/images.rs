//! Common parts of the plans of velocities and accelerations: points of links, and slides.

use assur_force::State;
use assur_group::plane::minus;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{GROUND, LinkId, Place, PointId, Slide};

use crate::plan::length;

/// Speed and acceleration of the coordinate; per unit of it without a motion.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rate {
    pub(crate) w: f64,
    pub(crate) e: f64,
}

impl Rate {
    pub(crate) fn of(state: Option<&State>) -> Self {
        state.map_or(Self { w: 1.0, e: 0.0 }, |state| Self { w: state.speed, e: state.acceleration })
    }
}

/// Unit of derivatives: by time with a motion, else by the coordinate.
pub(crate) fn unit(linkage: &Linkage, moves: bool, order: usize) -> &'static str {
    match (moves, linkage.angular(), order) {
        (true, _, 1) => "m/s",
        (true, _, _) => "m/s^2",
        (false, true, 1) => "m/rad",
        (false, true, _) => "m/rad^2",
        (false, false, 1) => "m/m",
        (false, false, _) => "m/m^2",
    }
}

/// Place in the solving order: ground, input link, groups.
fn rank(linkage: &Linkage, link: LinkId) -> usize {
    let group = linkage.structure.groups.iter().position(|group| group.frame.links.contains(&link));
    match group {
        Some(group) => group + 2,
        None => usize::from(link != GROUND),
    }
}

/// The named points of a link. The first one, from which the others are found, is known before the link.
pub(crate) fn points_of(linkage: &Linkage, link: LinkId) -> Vec<PointId> {
    let points = linkage.mechanism.points.iter().enumerate();
    let mut own: Vec<PointId> = points
        .filter(|(_, point)| point.places.iter().any(|place| place.link == link))
        .map(|(id, _)| id)
        .collect();
    let before = |id: &PointId| {
        let places = linkage.mechanism.points[*id].places.iter();
        places.map(|place| rank(linkage, place.link)).min().unwrap_or(usize::MAX)
    };
    if let Some(first) = (0..own.len()).min_by_key(|&index| before(&own[index])) {
        own[..=first].rotate_right(1);
    }
    own
}

/// Whether a point belongs to the ground.
pub(crate) fn is_fixed(linkage: &Linkage, point: PointId) -> bool {
    linkage.mechanism.points[point].places.iter().any(|place| place.link == GROUND)
}

/// A slide on a moving link: the sliding point, and the point of the guide under it.
#[derive(Debug)]
pub(crate) struct Sliding {
    pub(crate) slide: usize,
    pub(crate) carrier: LinkId,
    /// Name of the sliding point.
    pub(crate) name: String,
    /// `A on rocker`.
    pub(crate) under: String,
    /// The sliding point.
    pub(crate) place: Place,
    /// From the origin of the carrier to it, ground's frame, m.
    pub(crate) arm: [f64; 2],
    /// Direction of the guide, ground's frame.
    pub(crate) along: [f64; 2],
}

pub(crate) fn slidings(linkage: &Linkage, position: &Position) -> Vec<Sliding> {
    let slides = linkage.mechanism.slides.iter().enumerate().filter(|(_, slide)| slide.on != GROUND);
    slides.map(|(id, slide)| sliding(linkage, position, id, slide)).collect()
}

fn sliding(linkage: &Linkage, position: &Position, id: usize, slide: &Slide) -> Sliding {
    let mechanism = &linkage.mechanism;
    let carrier = &position.bodies[slide.on];
    let place = Place { link: slide.link, at: slide.point };
    let world = position.bodies[slide.link].point(slide.point);
    let near = 1e-12 * linkage.structure.scale;
    let named = mechanism.points.iter().find(|point| {
        point.places.iter().any(|own| own.link == slide.link && length(minus(own.at, slide.point)) <= near)
    });
    let name = named.map_or_else(|| format!("point of {}", slide.name), |point| point.name.clone());
    Sliding {
        slide: id,
        carrier: slide.on,
        under: format!("{name} on {}", mechanism.links[slide.on].name),
        name,
        place,
        arm: minus(world, [carrier.x, carrier.y]),
        along: carrier.turned([slide.angle.cos(), slide.angle.sin()]),
    }
}
