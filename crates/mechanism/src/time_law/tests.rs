#![expect(clippy::float_cmp, reason = "values of small whole numbers are exact")]

use std::f64::consts::TAU;

use super::TimeLaw;

const ROWS: [[f64; 2]; 5] = [[0.0, 0.4], [1.0, 0.52], [1.2, 0.9], [2.5, 0.56], [4.0, 0.7]];

fn close(found: [f64; 3], wanted: [f64; 3], limit: f64) {
    let apart = found.iter().zip(wanted).map(|(one, other)| (one - other).abs());
    assert!(apart.fold(0.0, f64::max) < limit, "{found:?}, wanted {wanted:?}");
}

/// The speeds of both lines at the middle row are equal: m0 + 4 m1 + m2 = 6 (-1 - 1), so that m1 = -3, with m0 = m2 = 0.
#[test]
fn a_natural_spline_through_three_rows_is_the_one_solved_by_hand() {
    let law = TimeLaw::smooth(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.5]], 2.0);
    assert!((law.at(1.0)[2] - 6.0 * -1.5 / 4.0).abs() < 1e-15);
    let law = TimeLaw::smooth(&[[0.0, 0.1], [1.0, 1.1], [2.0, 0.100_000_1]], 2.0);
    close(law.at(0.0), [0.1, 1.5, 0.0], 1e-6);
    close(law.at(1.0), [1.1, 0.0, -3.0], 1e-6);
    close(law.at(2.0), [0.1, -1.5, 0.0], 1e-6);
    // 1.5 t - t^3/2.
    close(law.at(0.5), [0.1 + 0.75 - 0.0625, 1.5 - 0.375, -1.5], 1e-6);
    let line = TimeLaw::smooth(&[[0.0, 1.0], [2.0, 5.0]], 2.0);
    assert_eq!(line.at(0.5), [2.0, 2.0, 0.0]);
}

/// Two steps of 1 up and down: by symmetry the speeds at the rows are 0, and 6 (-2) = 4 m1 + 2 m0 with m0 = -m1 gives m1 = -6.
#[test]
fn a_periodic_spline_through_two_steps_is_the_one_solved_by_hand() {
    let law = TimeLaw::smooth(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]], 5.0);
    for (time, wanted) in
        [(0.0, [0.0, 0.0, 6.0]), (1.0, [1.0, 0.0, -6.0]), (4.0, [0.0, 0.0, 6.0]), (4.5, [0.5, 1.5, 0.0])]
    {
        close(law.at(time), wanted, 1e-13);
    }
    assert_eq!(law.end(), None);
    assert_eq!(law.breaks().count(), 0);
}

#[test]
fn a_spline_goes_through_its_rows_without_a_jump_to_the_second_derivative() {
    let closed = [&ROWS[..4], &[[4.0, 0.4]]].concat();
    for rows in [&ROWS[..], &closed] {
        let law = TimeLaw::smooth(rows, 8.0);
        for row in &rows[..rows.len() - 1] {
            assert!((law.at(row[0])[0] - row[1]).abs() < 1e-14);
            let [before, after] = [row[0] - 2e-8, row[0] + 2e-8].map(|time| law.at(time));
            close(if row[0] > 0.0 { before } else { after }, after, 1e-6);
        }
        assert!((law.at(4.0 - 2e-8)[0] - rows[4][1]).abs() < 1e-7);
    }
    let natural = TimeLaw::smooth(&ROWS, 4.0);
    assert!(natural.at(0.0)[2].abs().max(natural.at(4.0)[2].abs()) < 1e-12);
    assert_eq!(natural.end(), Some(4.0));
    let periodic = TimeLaw::smooth(&closed, 12.0);
    close(periodic.at(4.0 - 2e-8), periodic.at(4.0 + 2e-8), 1e-6);
    close(periodic.at(0.7), periodic.at(8.7), 1e-12);
}

/// Halving the steps of a smooth periodic function divides the error by 16.
#[test]
fn a_periodic_spline_approaches_a_sine_with_order_four() {
    let error = |count: u32| {
        let step = TAU / f64::from(count);
        let mut rows: Vec<_> =
            (0..count).map(|row| f64::from(row) * step).map(|time| [time, time.sin()]).collect();
        rows.push([TAU, 0.0]);
        let law = TimeLaw::smooth(&rows, TAU);
        let off = |time: f64| (law.at(time)[0] - time.sin()).abs();
        (0..1000).map(|part| off(TAU * f64::from(part) / 1000.0)).fold(0.0, f64::max)
    };
    let [coarse, fine, finest] = [20, 40, 80].map(error);
    for ratio in [coarse / fine, fine / finest] {
        assert!((14.0..18.0).contains(&ratio), "{coarse} {fine} {finest}");
    }
}

#[test]
fn speed_and_acceleration_are_the_slopes_of_the_coordinate() {
    let formula = assur_formula::Formula::read("0.1*t^3 + sin(2*t)*exp(-t)").unwrap();
    let laws = [
        TimeLaw::smooth(&ROWS, 4.0),
        TimeLaw::linear(&ROWS, 4.0),
        TimeLaw::Formula { formula, factor: 0.5 },
        TimeLaw::uniform(2.0, -3.0),
    ];
    for law in laws {
        for time in [0.3, 0.77, 1.11, 1.9, 3.4] {
            let step = 1e-4;
            let [before, here, after] = [time - step, time, time + step].map(|time| law.at(time));
            for (of, slope) in [(0, 1), (1, 2)] {
                let wanted = (after[of] - before[of]) / (2.0 * step);
                assert!((here[slope] - wanted).abs() < 1e-5, "{law:?} {time}: {here:?}, {wanted}");
            }
        }
    }
}

/// On a row the line after it holds, on the last row the one before.
#[test]
fn lines_have_the_side_after_a_row_and_tell_where_their_speed_jumps() {
    let rows = [[0.0, 0.4], [1.0, 0.6], [1.5, 0.7], [2.0, 0.55], [4.0, 0.7]];
    let law = TimeLaw::linear(&rows, 4.0);
    for (time, speed) in [
        (0.0, 0.2),
        (1.0, 0.2),
        (1.5, -0.3),
        (2.0, 0.075),
        (2.0 - 3e-9, 0.075),
        (2.0 - 5e-9, -0.3),
        (4.0, 0.075),
    ] {
        let at = law.at(time);
        assert!((at[1] - speed).abs() < 1e-12 && at[2] == 0.0, "{time}: {at:?}");
    }
    assert_eq!(law.breaks().collect::<Vec<_>>(), [(1.5, 1), (2.0, 1)]);
    assert_eq!(TimeLaw::linear(&rows, 1.5).breaks().count(), 0);
}

/// A table of lines that closes repeats: its seam jumps in the motion, and the end of the motion belongs to the side before.
#[test]
fn a_closed_table_of_lines_repeats_and_jumps_at_its_seam() {
    let rows = [[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]];
    let law = TimeLaw::linear(&rows, 6.0);
    for (time, wanted) in
        [(3.0, [0.0, 2.0, 0.0]), (3.5, [1.0, 2.0, 0.0]), (5.0, [1.0, -1.0, 0.0]), (6.0, [0.0, -1.0, 0.0])]
    {
        close(law.at(time), wanted, 1e-14);
    }
    assert_eq!(law.breaks().map(|(time, _)| time).collect::<Vec<_>>(), [1.0, 3.0, 4.0]);
    close(TimeLaw::linear(&rows, 3.0).at(3.0), [0.0, -1.0, 0.0], 1e-14);
}

#[test]
fn only_the_numbers_of_an_even_motion_are_set_by_key() {
    let mut law = TimeLaw::uniform(1.0, 2.0);
    *law.number("from").unwrap() = 5.0;
    *law.number("rate").unwrap() = -1.0;
    assert_eq!(law.at(2.0), [3.0, -1.0, 0.0]);
    assert_eq!(law.number("to"), None);
    assert_eq!(TimeLaw::linear(&ROWS, 4.0).number("from"), None);
}
