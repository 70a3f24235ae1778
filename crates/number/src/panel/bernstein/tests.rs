use super::*;

/// 1 - 3 x + 2 x³ through four nodes, its halves and its derivative.
#[test]
fn a_cubic_through_its_values() {
    let cubic = |x: f64| 1.0 - 3.0 * x + 2.0 * x.powi(3);
    let nodes = [0.0, 0.2, 0.55, 1.0];
    let found = Bernstein::through(&nodes, &nodes.map(cubic));
    let near = |found: &[f64], wanted: &[f64]| {
        assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {wanted:?}");
    };
    near(&found.0, &[1.0, 0.0, -1.0, 0.0]);
    let [first, second] = found.halves();
    near(&[first.end(), second.0[0], second.end()], &[cubic(0.5), cubic(0.5), 0.0]);
    near(&found.slopes(1.0), &[-3.0, 3.0]);
    near(&first.slopes(0.5), &[-3.0, -1.5]);
    near(&first.bounds(), &[cubic(0.5), 1.0]);
    near(&found.within([0.5, 1.0]).0, &second.0);
    near(&found.within([0.25; 2]).0, &[cubic(0.25); 4]);
    // -3 + 6 x² over an interval of length 2.
    let derivative = found.derivative(2.0);
    near(&[0.0, 0.5, 1.0].map(|x| derivative.within([x; 2]).0[0]), &[-1.5, -0.75, 1.5]);
}
