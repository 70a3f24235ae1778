//! The columns of one point.

use assur_analysis::results::{Analysis, Named, PairReaction, PositionResult, ScalarMotion};

use crate::row::Cells;

/// Units that depend on the input and the balancing load.
#[derive(Debug, Clone, Copy)]
struct Units {
    coordinate: &'static str,
    speed: &'static str,
    balancing: &'static str,
}

impl Units {
    fn of(analysis: &Analysis) -> Self {
        let (coordinate, speed) =
            if analysis.input.angular { ("rad", "rad_per_s") } else { ("m", "m_per_s") };
        Self { coordinate, speed, balancing: if analysis.input.balancing_is_moment { "Nm" } else { "N" } }
    }
}

/// The columns of an analysis without failures. `groups`: number of solved groups; `transient`: whether the trajectory
/// has an end state.
pub(crate) fn cells(analysis: &Analysis, groups: usize, transient: bool) -> Cells {
    let mut cells = Cells::default();
    let units = Units::of(analysis);
    health(analysis, groups, units, &mut cells);
    balancing(analysis, units, &mut cells);
    reactions(analysis, &mut cells);
    places(analysis, &mut cells);
    dynamics(analysis, units, &mut cells);
    if let Some(end) = analysis.trajectory.last().filter(|_| transient) {
        cells.add("end_time_s", end.time);
        cells.add(format!("end_coordinate_{}", units.coordinate), end.coordinate);
        cells.add(format!("end_speed_{}", units.speed), end.speed);
    }
    cells
}

fn health(analysis: &Analysis, groups: usize, units: Units, cells: &mut Cells) {
    if groups == 0 {
        return;
    }
    // A group whose determinant is zero has no condition.
    let least = |position: &PositionResult| match position.condition.len() {
        known if known < groups => 0.0,
        _ => position.condition.iter().map(|(_, condition)| 1.0 / condition).fold(f64::INFINITY, f64::min),
    };
    // The least value is the negative of the greatest negated one.
    let healths = analysis.positions.iter().map(|position| (position.coordinate, -least(position)));
    if let Some((at, negative)) = greatest(healths) {
        cells.add("smallest_health", -negative);
        cells.add(format!("smallest_health_at_{}", units.coordinate), at);
    }
}

/// The greatest value and where it is; the first of equal ones.
fn greatest(values: impl Iterator<Item = (f64, f64)>) -> Option<(f64, f64)> {
    values.reduce(|best, next| if next.1 > best.1 { next } else { best })
}

fn balancing(analysis: &Analysis, units: Units, cells: &mut Cells) {
    let loads = || analysis.positions.iter().filter_map(|p| Some((p.coordinate, p.balancing?)));
    if let Some((at, load)) = greatest(loads().map(|(at, load)| (at, load.abs()))) {
        let unit = units.balancing;
        cells.add(format!("balancing_greatest_{unit}"), load);
        cells.add(format!("balancing_greatest_at_{}", units.coordinate), at);
        let count = loads().count() as f64;
        let mean = |of: fn(f64) -> f64| loads().map(|(_, load)| of(load)).sum::<f64>() / count;
        cells.add(format!("balancing_mean_{unit}"), mean(|load| load));
        cells.add(format!("balancing_mean_modulus_{unit}"), mean(f64::abs));
    }
}

fn reactions(analysis: &Analysis, cells: &mut Cells) {
    let all = || analysis.positions.iter().filter_map(|position| position.reactions.as_ref());
    let Some(first) = all().next() else { return };
    for (index, (pair, _)) in first.iter().enumerate() {
        let each = || all().filter_map(|named| named.0.get(index)).map(|(_, reaction)| reaction);
        let forces = each().flat_map(|r: &PairReaction| &r.forces).map(|(_, [x, y])| x.hypot(*y));
        cells.add_some(format!("reaction_{pair}_greatest_N"), forces.reduce(f64::max));
        let moments = each().filter_map(|reaction| reaction.moment).map(f64::abs);
        cells.add_some(format!("reaction_{pair}_moment_greatest_Nm"), moments.reduce(f64::max));
    }
}

fn places(analysis: &Analysis, cells: &mut Cells) {
    let Some(first) = analysis.positions.first() else { return };
    for (index, (point, _)) in first.points.iter().enumerate() {
        for (axis, part) in ["x", "y"].into_iter().enumerate() {
            let place = |position: &PositionResult| Some(position.points.0.get(index)?.1.pf0[axis]);
            let [min, max] = extremes(analysis, place);
            cells.add(format!("{point}_{part}_min_m"), min);
            cells.add(format!("{point}_{part}_max_m"), max);
        }
    }
    let value = |named: &Named<ScalarMotion>, index: usize| Some(named.0.get(index)?.1.pf0);
    for (index, (slide, _)) in first.slides.iter().enumerate() {
        let [min, max] = extremes(analysis, |position| value(&position.slides, index));
        cells.add(format!("{slide}_min_m"), min);
        cells.add(format!("{slide}_max_m"), max);
        cells.add(format!("{slide}_travel_m"), max - min);
    }
    for (index, (link, _)) in first.links.iter().enumerate() {
        let [min, max] = extremes(analysis, |position| value(&position.links, index));
        cells.add(format!("{link}_angle_min_rad"), min);
        cells.add(format!("{link}_angle_max_rad"), max);
    }
}

fn extremes(analysis: &Analysis, value: impl Fn(&PositionResult) -> Option<f64>) -> [f64; 2] {
    let values = analysis.positions.iter().filter_map(value);
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[min, max], value| [min.min(value), max.max(value)])
}

fn dynamics(analysis: &Analysis, units: Units, cells: &mut Cells) {
    let Some(found) = &analysis.dynamics else { return };
    cells.add_some("flywheel_kgm2", found.flywheel);
    cells.add_some("ratio", found.ratio);
    cells.add_some("torque_Nm", found.torque);
    cells.add(format!("mean_speed_{}", units.speed), found.mean_speed);
    cells.add("unevenness", found.unevenness);
    cells.add(format!("speed_min_{}", units.speed), found.speed_min);
    cells.add(format!("speed_max_{}", units.speed), found.speed_max);
    cells.add("excess_work_J", found.excess_work);
    cells.add("required_power_W", found.required_power);
}
