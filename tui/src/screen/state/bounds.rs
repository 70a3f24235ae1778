//! The part of the plane that a drawing covers, and how it is enlarged and shifted.

/// A rectangle of the plane, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) low: [f64; 2],
    pub(crate) high: [f64; 2],
}

impl Bounds {
    pub(crate) const EMPTY: Self = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };

    /// The least rectangle around points.
    pub(crate) fn around(points: impl Iterator<Item = [f64; 2]>) -> Self {
        let mut bounds = Self::EMPTY;
        points.for_each(|at| bounds.add(at));
        bounds
    }

    /// Extends the rectangle to a point; a coordinate that is not finite is ignored.
    pub(crate) fn add(&mut self, at: [f64; 2]) {
        for ((low, high), x) in self.low.iter_mut().zip(&mut self.high).zip(at).filter(|(_, x)| x.is_finite())
        {
            *low = low.min(x);
            *high = high.max(x);
        }
    }

    /// Width and height; 0 where it is empty.
    pub(crate) fn size(&self) -> [f64; 2] {
        [0, 1].map(|axis| (self.high[axis] - self.low[axis]).max(0.0))
    }

    pub(crate) fn center(&self) -> [f64; 2] {
        [0, 1].map(|axis| 0.5 * (self.low[axis] + self.high[axis]))
    }
}

/// Zoom and pan of a drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Zoom {
    /// Factor of enlargement.
    pub(crate) factor: f64,
    /// Shift of the middle as part of the drawn size.
    pub(crate) shift: [f64; 2],
}

impl Zoom {
    pub(crate) const WHOLE: Self = Self { factor: 1.0, shift: [0.0; 2] };
}
