//! The remarks that a row of a catalogue may carry.

/// Flags and what they mean. `*` stands for the printed value.
const FLAGS: &[(&str, &str)] = &[
    ("cos_phi_sources_differ", "two sources differ in cos phi; left empty"),
    ("current_implausible_removed_*", "the printed current cannot be right; removed"),
    ("current_power_mismatch", "printed current, efficiency and cos phi disagree by more than 8 %"),
    ("designation_completed", "a letter or digit of the type was lost in the transcription and is restored"),
    ("designation_repaired", "a letter or digit of the type was wrong in the transcription and is repaired"),
    ("designation_swapped_in_one_source", "one source exchanges this type with its neighbor"),
    ("inertia_*_removed", "the printed rotor inertia cannot be right; removed"),
    ("inertia_not_monotone", "rotor inertia falls where the frame grows; printed so, verify before use"),
    ("inertia_vs_same_frame", "rotor inertia falls with power in one frame; printed so, verify before use"),
    ("maker_max_torque_*", "the maker's list prints this breakdown torque ratio instead"),
    ("mass_vs_same_frame", "mass falls with power in one frame; printed so, verify before use"),
    ("power_22_printed_22.5", "22.5 kW printed; the winding table has 22 kW"),
    ("printed_slip_over_12", "printed slip above 12 %"),
    ("single_source_eta_cos_mass", "efficiency, cos phi and mass rest on one transcription"),
    ("slip_out_of_0.5_12", "rated slip outside 0.5-12 %; printed so"),
    ("slip_printed_vs_speed", "printed slip and printed speed differ by more than 0.7 points; both kept"),
    ("speed_sources_differ", "two sources differ in the rated speed"),
    ("start_gt_max", "starting torque above the maximum torque"),
];

/// What a flag of a row means; `None` for a flag that is not of the common list.
pub fn flag_meaning(flag: &str) -> Option<&'static str> {
    FLAGS.iter().find(|(pattern, _)| fits(pattern, flag)).map(|&(_, meaning)| meaning)
}

/// Whether the flag is the pattern, with a number in place of `*`.
fn fits(pattern: &str, flag: &str) -> bool {
    let Some((head, tail)) = pattern.split_once('*') else { return pattern == flag };
    flag.strip_prefix(head)
        .and_then(|rest| rest.strip_suffix(tail))
        .is_some_and(|value| value.parse::<f64>().is_ok_and(f64::is_finite))
}
