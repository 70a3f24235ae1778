use super::{Series, value};

#[test]
fn value_is_the_sum_of_cosines() {
    let series: Series = std::array::from_fn(|k| 1.0 / (1.0 + k as f64) - 0.3);
    for i in 0..=40 {
        let angle = std::f64::consts::PI * f64::from(i) / 40.0;
        let sum: f64 = series.iter().enumerate().map(|(k, c)| c * (k as f64 * angle).cos()).sum();
        assert!((value(&series, angle.cos()) - sum).abs() < 1e-14, "{angle}");
    }
}
