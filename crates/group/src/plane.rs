//! Vectors of the plane, generic over the number type, with complex products for rotations.

use assur_number::{Real, elementary};

/// A vector of constants in another number type.
#[inline(always)]
pub fn vector<T: Real>(of: [f64; 2]) -> [T; 2] {
    [T::from_f64(of[0]), T::from_f64(of[1])]
}

/// Unit vector at an angle, rad; its sine and cosine in the precision of `T`.
pub fn direction<T: Real>(angle: f64) -> [T; 2] {
    let (s, c) = T::from_f64(angle).sin_cos();
    [c, s]
}

/// Whether a vector is zero, in all lanes.
pub fn is_zero<T: Real>(a: [T; 2]) -> bool {
    a.into_iter().all(|component| component.abs().greatest() == 0.0)
}

/// a + b.
#[inline(always)]
pub fn plus<T: Real>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// a - b.
#[inline(always)]
pub fn minus<T: Real>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The length of a vector, rounded.
pub fn length<T: Real>(a: [T; 2]) -> f64 {
    elementary::hypot(a[0].to_f64(), a[1].to_f64())
}

/// -a.
#[inline(always)]
pub fn opposite<T: Real>(a: [T; 2]) -> [T; 2] {
    [-a[0], -a[1]]
}

/// k a.
#[inline(always)]
pub fn scaled<T: Real>(k: T, a: [T; 2]) -> [T; 2] {
    [k * a[0], k * a[1]]
}

/// Scalar product.
#[inline(always)]
pub fn dot<T: Real>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[0] + a[1] * b[1]
}

/// Vector product of two plane vectors (its component normal to the plane); positive where `b` is counter-clockwise
/// from `a`.
#[inline(always)]
pub fn cross<T: Real>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[1] - a[1] * b[0]
}

/// a turned by +90 degrees.
#[inline(always)]
pub fn perp<T: Real>(a: [T; 2]) -> [T; 2] {
    [-a[1], a[0]]
}

/// Complex product: `a` rotated by the angle of `b` and scaled by its length.
#[inline(always)]
pub fn times<T: Real>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// The vector with given scalar products with two others.
#[inline(always)]
pub fn meet<T: Real>(n: [[T; 2]; 2], [a, b]: [T; 2]) -> [T; 2] {
    let inverse = T::ONE / cross(n[0], n[1]);
    [(a * n[1][1] - b * n[0][1]) * inverse, (b * n[0][0] - a * n[1][0]) * inverse]
}

/// Complex conjugate: the opposite rotation.
#[inline(always)]
pub fn mirrored<T: Real>(a: [T; 2]) -> [T; 2] {
    [a[0], -a[1]]
}
