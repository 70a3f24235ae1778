//! A sample with the kernel under test.

use assur_group::plane::vector;
use assur_group::{AssurGroup, Body, GroupError, GroupPlugin, Number, Order, PairGeometry};
use assur_number::Real;

use crate::sample::Sample;

/// A failed check.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Name of the check.
    pub check: &'static str,
    /// Seed of the sample; `None` where the entry in the registry is at fault.
    pub seed: Option<u64>,
    /// The measured numbers.
    pub what: String,
}

impl Fault {
    /// A fault of the entry in the registry.
    pub(crate) fn of_entry(check: &'static str, what: impl std::fmt::Display) -> Fault {
        Fault { check, seed: None, what: format!("{check}: {what}") }
    }
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.seed {
            Some(seed) => write!(f, "{} (seed {seed}): {}", self.check, self.what),
            None => f.write_str(&self.what),
        }
    }
}

impl std::error::Error for Fault {}

/// A sample and its kernel in f64.
#[derive(Debug)]
pub(crate) struct Case {
    /// The kind.
    pub(crate) plugin: &'static GroupPlugin,
    /// The group.
    pub(crate) sample: Sample,
    /// Its kernel.
    pub(crate) kernel: Box<dyn AssurGroup>,
    /// Description for messages.
    pub(crate) seed: u64,
}

impl Case {
    /// Builds the kernel; a fault if the kind refuses the group, or declares another number of ways than it has.
    pub(crate) fn new(plugin: &'static GroupPlugin, sample: Sample, seed: u64) -> Result<Self, Fault> {
        let fault = |what| Fault { check: "build", seed: Some(seed), what };
        if !plugin.fits(&sample.frame) {
            return Err(fault("does not match a group of its own kind".into()));
        }
        let kernel = f64::build(&plugin.builders, &sample.frame).map_err(|error| fault(error.to_string()))?;
        // A kind that iterates may tell its modes apart otherwise than by their number.
        if !plugin.iterates && kernel.ways() != plugin.ways.most {
            return Err(fault(format!("declares {} ways, and has {}", plugin.ways.most, kernel.ways())));
        }
        Ok(Self { plugin, sample, kernel, seed })
    }

    /// A fault of this case.
    pub(crate) fn fault(&self, check: &'static str, what: impl Into<String>) -> Fault {
        Fault { check, seed: Some(self.seed), what: what.into() }
    }

    /// A failed call of the kernel as a fault.
    pub(crate) fn called<R>(&self, check: &'static str, result: Result<R, GroupError>) -> Result<R, Fault> {
        result.map_err(|error| self.fault(check, error.to_string()))
    }

    /// Places the bodies in a way; `None` if a kind with a varying number of ways does not have this one here.
    pub(crate) fn placed(&self, bodies: &mut [Body<f64>], way: usize) -> Result<Option<f64>, Fault> {
        match self.kernel.place(bodies, way) {
            Err(GroupError::NoAssembly { .. }) if self.plugin.ways.varies || self.plugin.iterates => Ok(None),
            other => self.called("place", other).map(Some),
        }
    }

    /// Requires |difference| <= limit; a NaN fails.
    pub(crate) fn within(
        &self,
        check: &'static str,
        what: &str,
        difference: f64,
        limit: f64,
    ) -> Result<(), Fault> {
        if difference.abs() <= limit {
            return Ok(());
        }
        Err(self.fault(check, format!("{what} differs by {difference:.3e}, allowed {limit:.1e}")))
    }

    /// The kernel in another number type.
    pub(crate) fn kernel_in<T: Number>(&self) -> Result<Box<dyn AssurGroup<T>>, Fault> {
        T::build(&self.plugin.builders, &self.sample.frame)
            .map_err(|error| self.fault("build", error.to_string()))
    }

    /// All bodies at q, solved in this way.
    pub(crate) fn solved<T: Number>(
        &self,
        kernel: &dyn AssurGroup<T>,
        q: T,
        way: usize,
    ) -> Result<Vec<Body<T>>, GroupError> {
        Self::solved_from(kernel, self.sample.bodies(q), way)
    }

    /// The same from given starting poses.
    pub(crate) fn solved_from<T: Number>(
        kernel: &dyn AssurGroup<T>,
        mut bodies: Vec<Body<T>>,
        way: usize,
    ) -> Result<Vec<Body<T>>, GroupError> {
        kernel.place(&mut bodies, way)?;
        kernel.derive(&mut bodies, Order::Second)?;
        Ok(bodies)
    }

    /// Greatest error of a pair's constraints: lengths in m, angles as sines.
    pub(crate) fn residual<T: Real>(&self, bodies: &[Body<T>]) -> f64 {
        let mut worst = 0.0_f64;
        for pair in self.sample.frame.pairs() {
            let (a, b) = (&bodies[pair.a], &bodies[pair.b]);
            let (one, two) = match pair.geometry {
                PairGeometry::Pin { at_a, at_b } => {
                    let (p, q) = (a.point(vector(at_a)), b.point(vector(at_b)));
                    (p[0] - q[0], p[1] - q[1])
                }
                PairGeometry::Slide { point, through, angle, tilt } => {
                    let (p, q) = (a.point(vector(point)), b.point(vector(through)));
                    let (s, c) = T::from_f64(angle).sin_cos();
                    let t = b.turned([c, s]);
                    let (s, c) = (T::from_f64(angle) + T::from_f64(tilt)).sin_cos();
                    let x = b.turned([c, s]);
                    (t[0] * (p[1] - q[1]) - t[1] * (p[0] - q[0]), x[0] * a.s - x[1] * a.c)
                }
            };
            for part in [one, two] {
                let size = part.abs().greatest();
                worst = if size.is_nan() { f64::INFINITY } else { worst.max(size) };
            }
        }
        worst
    }
}
