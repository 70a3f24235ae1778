//! Measures the motion of a mechanism over its cycle.

use std::f64::consts::TAU;

use assur_group::Order;
use assur_group::plane::dot;
use assur_kinematics::{Linkage, PositionError};
use assur_mechanism::{GROUND, LinkId, Place, Point, PointId, SlideId};
use assur_number::elementary;
use assur_words::{Describe, Text, text};

use crate::course::Cycle;
use crate::course::{Extremes, Motion, Rest, VectorCourse};
use crate::data::{
    AtPosition, Each, ForceAngles, Geometry, LinkCourse, PartCourses, PointCourse, SlideCourse,
};
use crate::rigid::RigidParts;
use crate::{Centers, Curvature, Stroke, centers_of};

/// Version of the format of the JSON.
const FORMAT: u32 = 1;

/// Difference from a whole number below which a link has made whole turns.
const WHOLE: f64 = 1e-9;

/// Why there is no geometry of the motion.
#[derive(Clone, PartialEq)]
pub struct GeometryError(pub PositionError);

assur_words::errors!(GeometryError);

impl Describe for GeometryError {
    fn describe(&self) -> Text {
        text!("geometry-part-of-cycle", cause = self.0.describe())
    }
}

impl From<PositionError> for GeometryError {
    fn from(error: PositionError) -> Self {
        Self(error)
    }
}

/// The geometry of the motion of a mechanism over its cycle; `against` is the link from which the centers are seen, the
/// ground for absolute ones.
pub fn geometry(linkage: &Linkage, against: LinkId) -> Result<Geometry, GeometryError> {
    let mechanism = &linkage.mechanism;
    let cycle = Cycle::of(linkage)?;
    let parts = RigidParts::of(&cycle);
    let moving = || (1..mechanism.links.len()).map(|id| mechanism.named_link(id));
    let links = moving()
        .map(|of| Ok((of.clone(), link(&cycle, of.id, &parts)?)))
        .collect::<Result<_, PositionError>>()?;
    let moves = |point: &Point| point.places.iter().all(|place| place.link != GROUND);
    let points = mechanism.points.iter().enumerate().filter(|(_, point)| moves(point));
    let points = points
        .map(|(id, _)| Ok((mechanism.named_point(id), point(&cycle, id)?)))
        .collect::<Result<_, PositionError>>()?;
    let slides = (0..mechanism.slides.len())
        .map(|id| Ok((mechanism.named_slide(id), slide(&cycle, id)?)))
        .collect::<Result<_, PositionError>>()?;
    let groups = (0..linkage.structure.groups.len())
        .map(|group| Ok((linkage.structure.group_name(mechanism, group), force_angles(&cycle, group)?)))
        .collect::<Result<_, PositionError>>()?;
    let is_rigid = |link: LinkId| parts.joins(link, against);
    let positions = positions(linkage, against, &is_rigid, &points)?;
    let rigid = moving().filter(|link| link.id != against && is_rigid(link.id));
    Ok(Geometry {
        format: FORMAT,
        title: mechanism.title.clone(),
        angular: linkage.angular(),
        against: mechanism.named_link(against),
        rigid: rigid.collect(),
        links,
        points,
        slides,
        groups,
        positions,
    })
}

/// The strokes and swings of the outputs of a machine, and the least transmission angle.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Overview {
    /// The slides on the ground that go to and fro: the outputs of the machine.
    pub slides: Vec<(SlideId, SlideCourse)>,
    /// The links that rock about a point of the ground.
    pub links: Vec<(LinkId, LinkCourse)>,
    /// The least transmission angle of all groups, rad, with its coordinate and its group.
    pub transmission: Option<(usize, f64, f64)>,
}

/// Measures the strokes and swings of the outputs of a machine, and the least transmission angle.
pub fn overview(linkage: &Linkage) -> Result<Overview, GeometryError> {
    let mechanism = &linkage.mechanism;
    let cycle = Cycle::of(linkage)?;
    let parts = RigidParts::of(&cycle);
    let mut found = Overview::default();
    for id in (0..mechanism.slides.len()).filter(|id| mechanism.slides[*id].on == GROUND) {
        found.slides.extend(Some((id, slide(&cycle, id)?)).filter(|(_, course)| course.stroke.is_some()));
    }
    let on_ground = |link: LinkId| {
        let on = |point: &Point, wanted: LinkId| point.places.iter().any(|place| place.link == wanted);
        mechanism.points.iter().any(|point| on(point, link) && on(point, GROUND))
    };
    for id in (1..mechanism.links.len()).filter(|id| on_ground(*id)) {
        found
            .links
            .extend(Some((id, link(&cycle, id, &parts)?)).filter(|(_, course)| course.stroke.is_some()));
    }
    for (number, group) in linkage.structure.groups.iter().enumerate() {
        let course = VectorCourse::of(&cycle, |position| {
            let health = position.health[number].abs();
            [
                [group.plugin.force_angle.transmission(&group.frame, &position.bodies, health)],
                [f64::NAN],
                [f64::NAN],
            ]
        });
        let least = course.extremes(ORDERS[0])?;
        if found.transmission.is_none_or(|(_, angle, _)| least.min < angle) {
            found.transmission = Some((number, least.min, least.at_min));
        }
    }
    Ok(found)
}

/// The motion of some parts over the cycle.
pub fn courses(
    linkage: &Linkage,
    links: impl Iterator<Item = LinkId>,
    slides: impl Iterator<Item = SlideId>,
    points: impl Iterator<Item = PointId>,
) -> Result<PartCourses, GeometryError> {
    let cycle = Cycle::of(linkage)?;
    let parts = RigidParts::of(&cycle);
    Ok(PartCourses {
        links: links.map(|id| link(&cycle, id, &parts)).collect::<Result<_, _>>()?,
        slides: slides.map(|id| slide(&cycle, id)).collect::<Result<_, _>>()?,
        points: points.map(|id| point(&cycle, id)).collect::<Result<_, _>>()?,
    })
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

fn link(cycle: &Cycle<'_>, id: LinkId, parts: &RigidParts) -> Result<LinkCourse, PositionError> {
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
    let swings = if angle.rests_always(unit) { Vec::new() } else { angle.rests()? };
    Ok(LinkCourse {
        turns,
        pf0,
        stroke: pf0
            .and_then(|pf0| Stroke::of(&swings, cycle.period, &linkage.mechanism, |_| pf0.max - pf0.min)),
        pf1: angle.extremes(ORDERS[1])?,
        pf2: angle.extremes(ORDERS[2])?,
        rests: if rests_always { Vec::new() } else { coordinates(&whole.rests()?) },
        rests_always,
    })
}

fn slide(cycle: &Cycle<'_>, id: SlideId) -> Result<SlideCourse, PositionError> {
    let linkage = cycle.linkage;
    let course = VectorCourse::of(cycle, |position| {
        let found = linkage.slide_motion(id, position);
        [[found.pf0], [found.pf1], [found.pf2]]
    });
    let pf0 = course.extremes(ORDERS[0])?;
    let unit = linkage.structure.scale / linkage.coordinate_unit();
    let rests = if course.rests_always(unit) { Vec::new() } else { course.rests()? };
    Ok(SlideCourse {
        pf0,
        stroke: Stroke::of(&rests, cycle.period, &linkage.mechanism, |_| pf0.max - pf0.min),
        pf1: course.extremes(ORDERS[1])?,
        pf2: course.extremes(ORDERS[2])?,
        rests: coordinates(&rests),
    })
}

fn point(cycle: &Cycle<'_>, id: PointId) -> Result<PointCourse, PositionError> {
    let linkage = cycle.linkage;
    let course = VectorCourse::of(cycle, |position| {
        let found = linkage.point_motion(id, position);
        [found.pf0, found.pf1, found.pf2]
    });
    let coordinate =
        |axis: usize| course.extremes(move |motion: &Motion<2>| [0, 1, 2].map(|order| motion[order][axis]));
    let modulus = |v: &[f64; 2]| elementary::hypot(v[0], v[1]);
    let unit = linkage.structure.scale / linkage.coordinate_unit();
    let rests = if course.rests_always(unit) { Vec::new() } else { course.rests()? };
    let mut position = linkage.position();
    let mut places = Vec::new();
    for rest in rests.iter().filter(|rest| rest.reverses) {
        places.push(course.at(rest.coordinate, 0, &mut position)?[0]);
    }
    let farthest =
        places.iter().flat_map(|a| places.iter().map(move |b| elementary::hypot(a[0] - b[0], a[1] - b[1])));
    let stroke = farthest.fold(0.0, f64::max);
    Ok(PointCourse {
        x: coordinate(0)?,
        y: coordinate(1)?,
        stroke: Stroke::of(&rests, cycle.period, &linkage.mechanism, |_| stroke),
        pf1: course.extremes(|motion| {
            let size = modulus(&motion[1]);
            let slope = motion[1][0] * motion[2][0] + motion[1][1] * motion[2][1];
            [size, slope, f64::NAN]
        })?,
        pf2: course.extremes(|motion| [modulus(&motion[2]), f64::NAN, f64::NAN])?,
        rests: coordinates(&rests),
    })
}

fn force_angles(cycle: &Cycle<'_>, group: usize) -> Result<ForceAngles, PositionError> {
    let found = &cycle.linkage.structure.groups[group];
    let force_angle = &found.plugin.force_angle;
    let course = VectorCourse::of(cycle, |position| {
        let angle = (force_angle.of)(&found.frame, &position.bodies, position.health[group].abs());
        [[angle], [f64::NAN], [f64::NAN]]
    });
    Ok(ForceAngles { what: force_angle.words.clone(), extremes: course.extremes(ORDERS[0])? })
}

fn positions(
    linkage: &Linkage,
    against: LinkId,
    is_rigid: &dyn Fn(LinkId) -> bool,
    points: &Each<PointCourse>,
) -> Result<Vec<AtPosition>, PositionError> {
    let mechanism = &linkage.mechanism;
    let scale = linkage.structure.scale;
    let mut position = linkage.position();
    let mut found = Vec::with_capacity(mechanism.input.positions);
    for index in 0..mechanism.input.positions {
        linkage.solve_index(index, Order::Second, &mut position)?;
        let bodies = &position.bodies;
        let links = (1..bodies.len()).filter(|&link| link != against).map(|link| {
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
        let angles = linkage.structure.groups.iter().zip(&position.health);
        let angles =
            angles.map(|(group, health)| (group.plugin.force_angle.of)(&group.frame, bodies, health.abs()));
        found.push(AtPosition {
            index,
            coordinate: position.coordinate,
            links: links.collect(),
            points: curved.collect(),
            angles: angles.collect(),
        });
    }
    Ok(found)
}
