//! The geometry of the motion, one row for each position.

use assur_book::Unit;
use assur_geometry::{AtPosition, Geometry};
use assur_shaking::Shaking;

use super::{CsvCell, CsvError, write};

/// Centers of the links, curvature of the paths and force angles in every position, SI.
pub fn geometry(found: &Geometry, ascii: bool) -> Result<String, CsvError> {
    let unit = if found.kind.is_angle() { "rad" } else { "m" };
    let mut header = vec!["position".to_owned(), format!("coordinate_{unit}")];
    let first = found.positions.first();
    for link in first.iter().flat_map(|at| at.links.keys()) {
        for center in ["center", "center_on_link", "inflection_pole", "acceleration_pole"] {
            header.extend(["x", "y"].map(|axis| format!("{link}_{center}_{axis}_m")));
        }
    }
    for point in found.points.keys() {
        header.extend([
            Unit::CURVATURE.column(format!("{point}_curvature")),
            format!("{point}_curvature_center_x_m"),
            format!("{point}_curvature_center_y_m"),
        ]);
    }
    header.extend(
        found.groups.iter().map(|(group, at)| format!("{group}_{}_rad", at.what).replace([' ', ':'], "_")),
    );
    write(&header, found.positions.iter().map(|at| row(found, at)), ascii)
}

fn row(found: &Geometry, at: &AtPosition) -> Vec<CsvCell<'static>> {
    let mut cells = vec![Some(at.index as f64), Some(at.coordinate)];
    let both = |place: Option<[f64; 2]>| [0, 1].map(|axis| place.map(|place| place[axis]));
    for centers in at.links.values() {
        let all =
            [centers.center.point(), centers.on_link, centers.inflection_pole, centers.acceleration_pole];
        cells.extend(all.into_iter().flat_map(both));
    }
    for name in found.points.keys() {
        let curvature = at.points.get(name);
        cells.push(curvature.map(|found| found.curvature));
        cells.extend(both(curvature.and_then(|found| found.center)));
    }
    cells.extend(at.angles.iter().map(|&angle| Some(angle)));
    cells.into_iter().map(|cell| cell.map_or(CsvCell::Empty, CsvCell::Number)).collect()
}

/// Shaking force and moment, input torque, and the force with each set of counterweights, in every position, SI.
pub fn shaking(found: &Shaking, ascii: bool) -> Result<String, CsvError> {
    let (unit, torque) = if found.kind.is_angle() { ("rad", "torque_Nm") } else { ("m", "driving_force_N") };
    let mut header: Vec<String> = vec!["position".to_owned(), format!("coordinate_{unit}")];
    header.extend(["force_x_N", "force_y_N", "moment_Nm", torque].map(str::to_owned));
    for number in 1..=found.balances.len() {
        header.extend(["x", "y"].map(|axis| format!("balanced_{number}_force_{axis}_N")));
    }
    let row = |at: &assur_shaking::AtPosition| {
        let mut cells = vec![at.index as f64, at.coordinate];
        cells.extend(at.force);
        cells.extend([at.moment, at.torque]);
        cells.extend(at.balanced.iter().flatten());
        cells.into_iter().map(CsvCell::Number).collect::<Vec<_>>()
    };
    write(&header, found.positions.iter().map(row), ascii)
}
