use approx::assert_relative_eq;

use super::{motors, table};
use crate::parse_table;

fn fault(row: &str) -> String {
    let error = parse_table("TEST", &table(&["good,4,1.1,1500,1410,2.2", row])).unwrap_err().to_string();
    let (place, fault) = error.split_once("`: ").unwrap();
    assert!(place.starts_with("catalogue `TEST`, line 3, "), "{place}");
    fault.to_owned()
}

#[test]
fn a_row_comes_out_in_si_units() {
    let header = "designation,poles,rated_power_kw,synchronous_speed_rpm,rated_speed_rpm,efficiency_percent,\
                  rotor_inertia_kg_m2,diameter_mm,mass_kg,flags,source,rated_slip_percent";
    let text = format!(
        "{header}\nX 1,4,1.5,1500,1400,77.5,0.004,90,12.5,start_gt_max cos_phi_sources_differ,p. 1,6.5\n"
    );
    let m = &parse_table("TEST", &text).unwrap()[0];
    assert_eq!((m.catalogue.as_str(), m.designation.as_str(), m.source.as_str()), ("TEST", "X 1", "p. 1"));
    assert_eq!((m.rated_power, m.poles, m.mass, m.diameter), (1500.0, 4, Some(12.5), Some(0.09)));
    assert_relative_eq!(m.synchronous_speed, 50.0 * std::f64::consts::PI, max_relative = 1e-15);
    assert_relative_eq!(m.efficiency.unwrap(), 0.775, max_relative = 1e-15);
    assert_relative_eq!(m.printed_slip.unwrap(), 0.065, max_relative = 1e-15);
    assert_eq!((m.rotor_inertia, m.max_torque_ratio, m.length), (Some(0.004), None, None));
    assert_eq!(m.flags, ["start_gt_max", "cos_phi_sources_differ"]);
}

#[test]
fn an_empty_field_is_unknown_not_zero() {
    assert_eq!(motors(&["x,4,1.1,1500,1410,"])[0].max_torque_ratio, None);
}

#[test]
fn impossible_rows_are_refused() {
    let out_of_range = |fault: String| fault.contains(", must be above ");
    assert!(out_of_range(fault("x,4,0,1500,1410,2.2")));
    assert!(out_of_range(fault("x,4,nan,1500,1410,2.2")));
    assert!(out_of_range(fault("x,4,inf,1500,1410,2.2")));
    assert!(out_of_range(fault("x,4,1.1,1500,1500,2.2")), "no slip");
    assert!(out_of_range(fault("x,4,1.1,1500,0,2.2")));
    assert!(out_of_range(fault("x,4,1.1,1500,1410,1")), "no breakdown");
    assert_eq!(fault("x,3,1.1,1500,1410,2.2"), "poles = 3, must be even and positive");
    assert_eq!(
        fault("x,6,1.1,1500,1410,2.2"),
        "synchronous_speed_rpm = 1500 does not belong to 6 poles at 50 Hz or 60 Hz"
    );
    assert_eq!(fault(" GOOD ,4,1.1,1500,1410,2.2"), "the designation occurs twice in the table");
}

#[test]
fn sixty_hertz_is_fine() {
    assert_eq!(motors(&["x,4,1.1,1800,1710,2.2"]).len(), 1);
}

#[test]
fn errors_name_catalogue_line_and_value() {
    let error = parse_table("TEST", &table(&["x,4,-1.1,1500,1410,2.2"])).unwrap_err();
    assert_eq!(
        error.to_string(),
        format!(
            "catalogue `TEST`, line 2, `x`: rated_power_kw = -1.1, must be above 0 and at most {}",
            f64::MAX
        )
    );
}

#[test]
fn what_is_no_table_is_refused() {
    for text in ["designation\nx\n", "a,b\n1,2\n", &table(&["x,four,1,1500,1400,2"]), &table(&["x,4"])] {
        let error = parse_table("TEST", text).unwrap_err();
        assert_eq!(error.0.identity(), Some("motor-table-unreadable"), "{text}");
    }
    for text in ["", &table(&[])] {
        assert_eq!(
            parse_table("TEST", text).unwrap_err().to_string(),
            "catalogue `TEST` has no rows",
            "{text}"
        );
    }
}
