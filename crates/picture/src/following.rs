//! What follows while a point or a guide is moved: the path of the point, the strokes of the slides, the transmission angle.

use assur_analysis::results::{Owner, Quantity};
use assur_book::Unit;
use assur_figure::{Axis, Bounds, Figure, Frame, Ink, Item, Panel, Point, Scale, Sign, Stroke};
use assur_kinematics::Position;
use assur_mechanism::PointId;
use assur_words::{Text, joined, list, text, unit};

use crate::plots::{STYLES, coordinate_axis};
use crate::{Look, Results, coordinate_unit};

/// Around a path, as part of its size.
const MARGIN: f64 = 0.1;

/// The path of a point of a moving link, the displacements of all slides, and the transmission angle of the group that has the least one;
/// a panel each, without what the mechanism lacks.
pub fn figure(results: &Results, look: &Look<'_>, point: Option<PointId>) -> Figure {
    let path = point.and_then(|point| path(results, look, point));
    let panels = path.into_iter().chain(displacements(results)).chain(transmission(results));
    Figure { panels: panels.collect(), columns: 1, ..Figure::default() }
}

fn path(results: &Results, look: &Look<'_>, point: PointId) -> Option<Panel> {
    let path = results.outline.paths.get(point).filter(|path| !path.is_empty())?;
    let mut items = vec![Item::line(path.as_slice(), Stroke::Solid, Ink::Trace)];
    let now = results.pose(look.position, look.part);
    items.extend(
        now.map(|pose| Item::sign(results.linkage.point_motion(point, &pose).pf0, Sign::Cross, Ink::Marked)),
    );
    let bounds = Bounds::around(path.iter().copied()).widened(MARGIN);
    let title = text!("following-path", point = &results.linkage.mechanism.points[point].name);
    Some(Panel { title, ..Panel::plane(bounds, Scale::of("l", "m"), items) })
}

fn displacements(results: &Results) -> Option<Panel> {
    let is_slide = |owner: Owner, quantity: Quantity| {
        matches!(owner, Owner::Slide(_)) && quantity == Quantity::Transfer(0)
    };
    let of_cycle = results.of_cycle().iter();
    let slides: Vec<_> =
        of_cycle.filter(|series| is_slide(series.column.owner, series.column.quantity)).collect();
    let factor = coordinate_unit(&results.linkage).1;
    let of = slides.first()?.unit;
    let lines = slides.iter().map(|series| series.course.points([factor, of.factor]));
    let names = slides.iter().take(STYLES.len()).map(|series| series.of.clone());
    Some(over_cycle(results, (list(names), of), lines.collect()))
}

/// The transmission angle of the group in which it is least somewhere.
fn transmission(results: &Results) -> Option<Panel> {
    let linkage = &results.linkage;
    let groups = &linkage.structure.groups;
    let course = |number: usize| {
        let group = &groups[number];
        let angle = |pose: &Position| {
            group.plugin.force_angle.transmission(&group.frame, &pose.bodies, pose.health[number].abs())
        };
        let angles =
            results.outline.fine.iter().map(|pose| pose.as_ref().map(|pose| (pose.coordinate, angle(pose))));
        (number, angles.collect::<Vec<_>>())
    };
    let least = |angles: &[Option<(f64, f64)>]| {
        angles.iter().flatten().map(|(_, angle)| *angle).fold(f64::INFINITY, f64::min)
    };
    let joined_groups = (0..groups.len()).filter(|number| groups[*number].class > 1);
    let all = joined_groups.map(course).filter(|(_, angles)| least(angles).is_finite());
    let (number, angles) = all.min_by(|a, b| least(&a.1).total_cmp(&least(&b.1)))?;
    let (factor, of) = (coordinate_unit(linkage).1, Unit::ANGLE);
    let place = |at: Option<(f64, f64)>| {
        at.map_or([f64::NAN; 2], |(coordinate, angle)| [factor * coordinate, of.factor * angle])
    };
    let line = angles.into_iter().map(place).collect();
    let group = linkage.structure.group_name(&linkage.mechanism, number).short();
    let title = joined(": ", [text!("following-transmission"), group]);
    Some(over_cycle(results, (title, of), vec![line]))
}

/// Curves over the cycle, in the order of the styles.
fn over_cycle(results: &Results, (title, of): (Text, Unit), lines: Vec<Vec<Point>>) -> Panel {
    let styled = lines.into_iter().zip(STYLES);
    let items: Vec<Item> = styled.map(|(line, (stroke, ink))| Item::line(line, stroke, ink)).collect();
    let heights: Vec<f64> = items.iter().flat_map(Item::points).map(|at| at[1]).collect();
    let y = Axis::around(unit(of.name), heights, 0.0);
    let x = coordinate_axis(&results.linkage);
    Panel { title, frame: Frame::Axes { x, y, cursor: None }, items }
}
