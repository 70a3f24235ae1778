//! Formulas compiled for several sets of instructions, of which the machine's widest is taken at run time.

use pulp::Arch;

use crate::Formula;

struct Widest<F>(F);

impl<F: Formula> pulp::WithSimd for Widest<F> {
    type Output = F::Value;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> F::Value {
        self.0.evaluate()
    }
}

/// Evaluates a formula with the widest instructions that the machine has.
#[inline(always)]
pub(crate) fn evaluate<F: Formula>(formula: F) -> F::Value {
    Arch::new().dispatch(Widest(formula))
}
