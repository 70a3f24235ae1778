//! Measures the motion of a mechanism over its cycle.

use std::f64::consts::TAU;

use assur_group::{Order, plane::dot};
use assur_kinematics::{Linkage, PositionError};
use assur_mechanism::{GROUND, LinkId, Named, Place, PointId, SlideId};
use assur_number::elementary;
use assur_words::{Describe, Text, text};

use crate::course::{Cycle, Motion, Rest, VectorCourse};
use crate::data::Each;
use crate::rigid::RigidParts;
use crate::{
    AtPosition, Centers, Curvature, Extremes, ForceAngles, Geometry, PartCourse, Stroke, centers_of,
};

/// Version of the format of the JSON.
const FORMAT: u32 = 1;

/// Difference from a whole number below which a link has made whole turns.
const WHOLE: f64 = 1e-9;

/// Why there is no geometry of the motion.
#[derive(Clone, PartialEq)]
pub enum GeometryError {
    /// A part of the cycle has no solution.
    Position(PositionError),
}

assur_words::errors!(GeometryError; Position(PositionError));

impl Describe for GeometryError {
    fn describe(&self) -> Text {
        let Self::Position(error) = self;
        text!("geometry-part-of-cycle", cause = error.describe())
    }
}

/// The geometry of the motion of a mechanism over its cycle; `against` is the link from which the centers are seen, the
/// ground for absolute ones.
pub fn geometry(linkage: &Linkage, against: LinkId) -> Result<Geometry, GeometryError> {
    let mechanism = &linkage.mechanism;
    let cycle = Cycle::of(linkage)?;
    let parts = RigidParts::of(&cycle);
    let moving = || (1..mechanism.links.len()).map(|id| mechanism.named_link(id));
    let points = (0..mechanism.points.len()).filter(|id| mechanism.place_in(*id, GROUND).is_none());
    let slides = 0..mechanism.slides.len();
    let links = each(moving(), |id| link(&cycle, id, &parts))?;
    let points = each(points.map(|id| mechanism.named_point(id)), |id| point(&cycle, id))?;
    let slides = each(slides.map(|id| mechanism.named_slide(id)), |id| slide(&cycle, id))?;
    let groups = (0..linkage.structure.groups.len())
        .map(|group| Ok((linkage.structure.group_name(mechanism, group), force_angles(&cycle, group)?)))
        .collect::<Result<_, PositionError>>()?;
    let is_rigid = |link: LinkId| parts.joins(link, against);
    let positions = positions(linkage, against, &is_rigid, &points)?;
    let rigid = moving().filter(|link| link.id != against && is_rigid(link.id));
    Ok(Geometry {
        format: FORMAT,
        title: mechanism.title.clone(),
        kind: linkage.kind(),
        against: mechanism.named_link(against),
        rigid: rigid.collect(),
        links,
        points,
        slides,
        groups,
        positions,
    })
}

/// What is measured of each.
fn each<T>(
    all: impl Iterator<Item = Named<usize>>,
    measure: impl Fn(usize) -> Result<T, PositionError>,
) -> Result<Each<T>, PositionError> {
    all.map(|of| measure(of.id).map(|found| (of, found))).collect()
}

/// The strokes and swings of the outputs of a machine, and the least transmission angle.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Overview {
    /// The slides on the ground that go to and fro: the outputs of the machine.
    pub slides: Vec<(SlideId, PartCourse)>,
    /// The links that rock about a point of the ground.
    pub links: Vec<(LinkId, PartCourse)>,
    /// The least transmission angle of all groups, rad, with its coordinate and its group.
    pub transmission: Option<(usize, f64, f64)>,
    /// Whether this angle is the same over the whole cycle.
    pub constant_transmission: bool,
}

/// Measures the strokes and swings of the outputs of a machine, and the least transmission angle.
pub fn overview(linkage: &Linkage) -> Result<Overview, GeometryError> {
    let mechanism = &linkage.mechanism;
    let cycle = Cycle::of(linkage)?;
    let parts = RigidParts::of(&cycle);
    let mut found = Overview::default();
    for id in (0..mechanism.slides.len()).filter(|id| mechanism.slides[*id].on == GROUND) {
        let course = slide(&cycle, id)?;
        found.slides.extend(course.stroke.is_some().then_some((id, course)));
    }
    let on_ground = |link: &LinkId| {
        let is_pin = |point| [*link, GROUND].iter().all(|on| mechanism.place_in(point, *on).is_some());
        (0..mechanism.points.len()).any(is_pin)
    };
    for id in (1..mechanism.links.len()).filter(on_ground) {
        let course = link(&cycle, id, &parts)?;
        found.links.extend(course.stroke.is_some().then_some((id, course)));
    }
    // A driven link on a moving one transmits whatever it is given.
    let groups = linkage.structure.groups.iter().enumerate().filter(|(_, group)| group.class > 1);
    for (number, group) in groups {
        let course = VectorCourse::of(&cycle, |position| {
            let health = position.health[number].abs();
            alone(group.plugin.force_angle.transmission(&group.frame, &position.bodies, health))
        });
        let least = course.extremes(ORDERS[0])?;
        if found.transmission.is_none_or(|(_, angle, _)| least.min < angle) {
            found.transmission = Some((number, least.min, least.at_min));
            found.constant_transmission = least.max - least.min <= assur_number::ROUNDING * least.max;
        }
    }
    Ok(found)
}

/// The motion of some parts over the cycle: of the points, then of the slides, then of the links.
pub fn courses(
    linkage: &Linkage,
    points: impl Iterator<Item = PointId>,
    slides: impl Iterator<Item = SlideId>,
    links: impl Iterator<Item = LinkId>,
) -> Result<Vec<PartCourse>, GeometryError> {
    let cycle = Cycle::of(linkage)?;
    let parts = RigidParts::of(&cycle);
    let points = points.map(|id| point(&cycle, id));
    let slides = slides.map(|id| slide(&cycle, id));
    let all = points.chain(slides).chain(links.map(|id| link(&cycle, id, &parts)));
    Ok(all.collect::<Result<_, PositionError>>()?)
}

/// The distances of points of links from places in the frame of the ground over the cycle, m.
pub fn distances(
    linkage: &Linkage,
    targets: impl Iterator<Item = (Place, [f64; 2])>,
) -> Result<Vec<Extremes>, GeometryError> {
    let cycle = Cycle::of(linkage)?;
    let of = |(place, from): (Place, [f64; 2])| {
        // Of the square, which is smooth where the distance is zero.
        let square = VectorCourse::of(&cycle, |position| {
            let body = &position.bodies[place.link];
            let (at, [first, second]) = (body.point(place.at), body.motion(body.arm(place.at)));
            let away = [at[0] - from[0], at[1] - from[1]];
            let slope = 2.0 * dot(away, first);
            [[dot(away, away)], [slope], [2.0 * (dot(first, first) + dot(away, second))]]
        });
        let found = square.extremes(ORDERS[0])?;
        Ok(Extremes { min: found.min.max(0.0).sqrt(), max: found.max.sqrt(), ..found })
    };
    targets.map(of).collect()
}

fn coordinates(rests: &[Rest]) -> Vec<f64> {
    rests.iter().map(|rest| rest.coordinate).collect()
}

/// The three orders of a scalar, for [`VectorCourse::extremes`]: value, first and second derivative of each.
const ORDERS: [fn(&Motion<1>) -> [f64; 3]; 3] = [
    |motion| motion.map(|[value]| value),
    |motion| [motion[1][0], motion[2][0], f64::NAN],
    |motion| [motion[2][0], f64::NAN, f64::NAN],
];

/// A value whose derivatives are not known.
const fn alone(value: f64) -> Motion<1> {
    [[value], [f64::NAN], [f64::NAN]]
}

fn link(cycle: &Cycle<'_>, id: LinkId, parts: &RigidParts) -> Result<PartCourse, PositionError> {
    let linkage = cycle.linkage;
    let angle = VectorCourse::angle(cycle, |position| {
        let found = linkage.link_motion(id, position);
        [[found.pf0], [found.pf1], [found.pf2]]
    });
    let unit = 1.0 / linkage.coordinate_unit();
    let scale = linkage.structure.scale;
    let whole = VectorCourse::of(cycle, |position| {
        let body = &position.bodies[id];
        [[body.x, body.y, 0.0], [body.x1, body.y1, scale * body.w1], [body.x2, body.y2, scale * body.w2]]
    });
    let rests_always = parts.joins(id, GROUND) || whole.rests_always(scale * unit);
    let ends = [&angle.samples[0], &angle.samples[angle.samples.len() - 1]].map(|motion| motion[0][0]);
    let turns = (ends[1] - ends[0]) / TAU;
    let is_whole = cycle.period.is_some() && turns.round() != 0.0 && (turns - turns.round()).abs() < WHOLE;
    let turns = is_whole.then(|| linkage.mechanism.input.sign() * turns.round());
    let pf0 = if is_whole { None } else { Some(angle.extremes(ORDERS[0])?) };
    let swings = angle.rests(unit)?;
    Ok(PartCourse {
        turns,
        pf0,
        stroke: pf0.and_then(|pf0| Stroke::of(&swings, cycle.period, &linkage.mechanism, pf0.range())),
        pf1: angle.extremes(ORDERS[1])?,
        pf2: angle.extremes(ORDERS[2])?,
        rests: if rests_always { Vec::new() } else { coordinates(&whole.rests(scale * unit)?) },
        rests_always: Some(rests_always),
        ..PartCourse::default()
    })
}

fn slide(cycle: &Cycle<'_>, id: SlideId) -> Result<PartCourse, PositionError> {
    let linkage = cycle.linkage;
    let course = VectorCourse::of(cycle, |position| {
        let found = linkage.slide_motion(id, position);
        [[found.pf0], [found.pf1], [found.pf2]]
    });
    let pf0 = course.extremes(ORDERS[0])?;
    let rests = course.rests(linkage.structure.scale / linkage.coordinate_unit())?;
    Ok(PartCourse {
        pf0: Some(pf0),
        stroke: Stroke::of(&rests, cycle.period, &linkage.mechanism, pf0.range()),
        pf1: course.extremes(ORDERS[1])?,
        pf2: course.extremes(ORDERS[2])?,
        rests: coordinates(&rests),
        ..PartCourse::default()
    })
}

fn point(cycle: &Cycle<'_>, id: PointId) -> Result<PartCourse, PositionError> {
    let linkage = cycle.linkage;
    let course = VectorCourse::of(cycle, |position| {
        let found = linkage.point_motion(id, position);
        [found.pf0, found.pf1, found.pf2]
    });
    let coordinate =
        |axis: usize| course.extremes(move |motion: &Motion<2>| [0, 1, 2].map(|order| motion[order][axis]));
    let modulus = |v: &[f64; 2]| elementary::hypot(v[0], v[1]);
    let rests = course.rests(linkage.structure.scale / linkage.coordinate_unit())?;
    let mut position = linkage.position();
    let mut places = Vec::new();
    for rest in rests.iter().filter(|rest| rest.reverses) {
        places.push(course.at(rest.coordinate, 0, &mut position)?[0]);
    }
    let farthest =
        places.iter().flat_map(|a| places.iter().map(move |b| elementary::hypot(a[0] - b[0], a[1] - b[1])));
    let stroke = farthest.fold(0.0, f64::max);
    Ok(PartCourse {
        x: Some(coordinate(0)?),
        y: Some(coordinate(1)?),
        stroke: Stroke::of(&rests, cycle.period, &linkage.mechanism, stroke),
        pf1: course.extremes(|motion| [modulus(&motion[1]), dot(motion[1], motion[2]), f64::NAN])?,
        pf2: course.extremes(|motion| [modulus(&motion[2]), f64::NAN, f64::NAN])?,
        rests: coordinates(&rests),
        ..PartCourse::default()
    })
}

fn force_angles(cycle: &Cycle<'_>, group: usize) -> Result<ForceAngles, PositionError> {
    let found = &cycle.linkage.structure.groups[group];
    let force_angle = &found.plugin.force_angle;
    let course = VectorCourse::of(cycle, |position| {
        alone((force_angle.of)(&found.frame, &position.bodies, position.health[group].abs()))
    });
    Ok(ForceAngles { what: force_angle.words.clone(), extremes: course.extremes(ORDERS[0])? })
}

fn positions(
    linkage: &Linkage,
    against: LinkId,
    is_rigid: &dyn Fn(LinkId) -> bool,
    points: &Each<PartCourse>,
) -> Result<Vec<AtPosition>, PositionError> {
    let mechanism = &linkage.mechanism;
    let scale = linkage.structure.scale;
    let mut position = linkage.position();
    let mut found = Vec::with_capacity(mechanism.input.positions);
    for index in 0..mechanism.input.positions {
        linkage.solve_index(index, Order::Second, &mut position)?;
        let bodies = &position.bodies;
        let links = (1..linkage.structure.links).filter(|&link| link != against).map(|link| {
            let centers = if is_rigid(link) {
                Centers::RIGID
            } else {
                centers_of(&bodies[link], &bodies[against], scale)
            };
            (mechanism.named_link(link), centers)
        });
        let curved = points.iter().filter_map(|(point, course)| {
            let motion = linkage.point_motion(point.id, &position);
            Some((point.clone(), Curvature::of(&motion, course.pf1.max)?))
        });
        let groups = linkage.structure.groups.iter().zip(&position.health);
        let angles =
            groups.map(|(group, health)| (group.plugin.force_angle.of)(&group.frame, bodies, health.abs()));
        let (links, points, angles) = (links.collect(), curved.collect(), angles.collect());
        found.push(AtPosition { index, coordinate: position.coordinate, links, points, angles });
    }
    Ok(found)
}
