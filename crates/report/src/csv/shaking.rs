//! The shaking force, one row for each position.

use assur_shaking::Shaking;

use super::{Cell, CsvError, write};

/// Shaking force and moment, input torque, and the force with each set of counterweights, in every position, SI.
///
/// # Errors
///
/// [`CsvError`] for a number that is not finite.
pub fn shaking(found: &Shaking, ascii: bool) -> Result<String, CsvError> {
    let (unit, torque) = if found.angular { ("rad", "torque_Nm") } else { ("m", "driving_force_N") };
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
        cells.into_iter().map(Cell::Number).collect::<Vec<_>>()
    };
    write(&header, found.positions.iter().map(row), ascii)
}
