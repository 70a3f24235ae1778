//! The part of the plane that a drawing covers, and how it is enlarged and shifted.

/// A rectangle of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Its lower left corner.
    pub low: [f64; 2],
    /// Its upper right corner.
    pub high: [f64; 2],
}

impl Bounds {
    /// A rectangle without any point.
    pub const EMPTY: Self = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };

    /// The least rectangle around points.
    pub fn around(points: impl Iterator<Item = [f64; 2]>) -> Self {
        let mut bounds = Self::EMPTY;
        points.for_each(|at| bounds.add(at));
        bounds
    }

    /// Extends the rectangle to a point; a coordinate that is not finite is ignored.
    pub fn add(&mut self, at: [f64; 2]) {
        for ((low, high), x) in self.low.iter_mut().zip(&mut self.high).zip(at).filter(|(_, x)| x.is_finite())
        {
            *low = low.min(x);
            *high = high.max(x);
        }
    }

    /// Width and height; 0 where it is empty, or what it holds lies in one place but for rounding.
    pub fn size(&self) -> [f64; 2] {
        /// A width or height this small compared with the greatest coordinate is rounding.
        const ROUNDING: f64 = 1e-12;
        let size = [0, 1].map(|axis| (self.high[axis] - self.low[axis]).max(0.0));
        let far = self.low.iter().chain(&self.high).fold(0.0_f64, |far, x| far.max(x.abs()));
        if size[0].max(size[1]) <= ROUNDING * far { [0.0; 2] } else { size }
    }

    /// The rectangle extended on all sides by a part of its greater side.
    #[must_use]
    pub fn widened(self, part: f64) -> Self {
        let [width, height] = self.size();
        let by = part * width.max(height);
        Self { low: self.low.map(|x| x - by), high: self.high.map(|x| x + by) }
    }

    /// Whether a point lies in it.
    pub fn holds(&self, at: [f64; 2]) -> bool {
        (0..2).all(|axis| (self.low[axis]..=self.high[axis]).contains(&at[axis]))
    }

    /// The part of a straight piece that lies in it; `None` where it lies outside.
    pub fn cut(&self, [from, to]: [[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
        let at = |part: f64| [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]));
        inside([from, to], self.low, self.high).map(|parts| parts.map(at))
    }

    /// Its middle.
    pub fn center(&self) -> [f64; 2] {
        [0, 1].map(|axis| 0.5 * (self.low[axis] + self.high[axis]))
    }
}

/// Zoom and pan of a drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zoom {
    /// Factor of enlargement.
    pub factor: f64,
    /// Shift of the middle as part of the drawn size.
    pub shift: [f64; 2],
}

impl Default for Zoom {
    fn default() -> Self {
        Self::WHOLE
    }
}

impl Zoom {
    /// The whole figure, as large as it fits.
    pub const WHOLE: Self = Self { factor: 1.0, shift: [0.0; 2] };
}

/// The ends of the part of a straight piece that lies in a rectangle, as parts of its length (Liang and Barsky); `None` where
/// it lies outside, or an end is not finite.
pub(crate) fn inside([from, to]: [[f64; 2]; 2], low: [f64; 2], high: [f64; 2]) -> Option<[f64; 2]> {
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let along = to[axis] - from[axis];
        if !along.is_finite() {
            return None;
        }
        let [a, b] = [low[axis] - from[axis], high[axis] - from[axis]];
        if along == 0.0 {
            if a > 0.0 || b < 0.0 {
                return None;
            }
            continue;
        }
        (first, last) = (first.max((a / along).min(b / along)), last.min((a / along).max(b / along)));
    }
    (first <= last).then_some([first, last])
}
