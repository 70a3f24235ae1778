//! Sums over stages, shared by both methods.

/// A stage: its slopes, which are its speed and its acceleration.
pub(crate) type Slope = [f64; 2];

/// Sum of the slopes with these weights; the weights end where the stages that they use end.
#[inline]
pub(crate) fn weighted<const N: usize>(weights: &[f64; N], slopes: &[Slope]) -> Slope {
    let mut sum = [0.0; 2];
    for (weight, slope) in weights.iter().zip(slopes) {
        sum[0] += weight * slope[0];
        sum[1] += weight * slope[1];
    }
    sum
}
