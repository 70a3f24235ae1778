//! The second-order cone of the plane and the scaling of Nesterov and Todd.

/// A modulus and a vector; inside the cone the modulus is greater than that of the vector.
pub(crate) type Cone = [f64; 3];

/// The square of the modulus less that of the vector.
pub(crate) fn inner([t, x, y]: Cone) -> f64 {
    let size = x.hypot(y);
    (t - size) * (t + size)
}

/// How many steps a point inside the cone stays in it.
pub(crate) fn most(at: Cone, step: Cone) -> f64 {
    let cross = at[0] * step[0] - at[1] * step[1] - at[2] * step[2];
    // Zero of inner(at + part step), by its reciprocal.
    let root = cross * cross - inner(at) * inner(step);
    let reciprocal = if root >= 0.0 { root.sqrt() - cross } else { 0.0 };
    if reciprocal > 0.0 { inner(at) / reciprocal } else { f64::INFINITY }
}

/// The map W of the cone onto itself with `W dual = W⁻¹ slack`.
pub(crate) struct Scaling {
    size: f64,
    axis: Cone,
}

impl Scaling {
    /// `None` where slack or dual are not strictly inside their cones.
    pub(crate) fn of(slack: Cone, dual: Cone) -> Option<Self> {
        let inside = |at: Cone| at[0] > 0.0 && inner(at) > 0.0;
        if !(inside(slack) && inside(dual)) {
            return None;
        }
        let [s, z] = [slack, dual].map(|at| at.map(|part| part / inner(at).sqrt()));
        let middle = (0.5 * (1.0 + s[0] * z[0] + s[1] * z[1] + s[2] * z[2])).sqrt();
        let axis = [s[0] + z[0], s[1] - z[1], s[2] - z[2]].map(|part| 0.5 * part / middle);
        Some(Self { size: (inner(slack) / inner(dual)).sqrt().sqrt(), axis })
    }

    /// W v.
    pub(crate) fn times(&self, v: Cone) -> Cone {
        turned(self.axis, v).map(|part| self.size * part)
    }

    /// W⁻¹ v.
    pub(crate) fn divided(&self, v: Cone) -> Cone {
        let [t, x, y] = self.axis;
        turned([t, -x, -y], v).map(|part| part / self.size)
    }
}

/// The hyperbolic rotation with an axis of inner product 1.
fn turned([t, x, y]: Cone, [a, b, c]: Cone) -> Cone {
    let along = x * b + y * c;
    let more = a + along / (1.0 + t);
    [t * a + along, b + x * more, c + y * more]
}

#[cfg(test)]
mod tests;
