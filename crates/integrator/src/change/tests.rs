use super::*;

/// The parts of a step lie within their bounds, and end where the step does.
#[test]
fn bounds_hold_what_the_step_holds() {
    let numbers = |seed: f64| std::array::from_fn(|i| (seed + 7.3 * i as f64).sin());
    let dense = Dense { time: 2.0, step: 0.5, coordinate: numbers(0.4), speed: numbers(1.9) };
    let mut parts = vec![StepPart::whole(&dense)];
    for _ in 0..3 {
        parts = parts.iter().flat_map(StepPart::halves).collect();
        for part in &parts {
            let [from, to] = part.ends;
            let Stretch { states, acceleration, end } = part.stretch();
            let last = dense.at(to);
            assert!((end.coordinate - last.coordinate).abs() + (end.speed - last.speed).abs() < 1e-14);
            let within = |[low, high]: [f64; 2], x: f64| low - 1e-14 <= x && x <= high + 1e-14;
            for k in 0..=16 {
                let at = dense.at(from + (to - from) * f64::from(k) / 16.0);
                assert!(within(states.coordinate, at.coordinate) && within(states.speed, at.speed));
                assert!(within(states.time, at.time));
            }
            let mean = (last.speed - dense.at(from).speed) / ((to - from) * dense.step);
            assert!(within(acceleration, mean), "{acceleration:?} {mean}");
        }
    }
}
