mod search;

use proptest::prelude::*;

use crate::{Dd, Lanes, Real};

fn close(a: Dd, b: Dd, limit: f64) -> bool {
    (a - b).abs().to_f64() <= limit
}

#[test]
fn double_double_knows_32_digits_of_sqrt_2() {
    // sqrt 2 = 1.41421356237309504880168872420969807857; hi + lo of it.
    let root = Dd::from_f64(2.0).sqrt();
    assert!(close(root * root, Dd::from_f64(2.0), 1e-31));
    assert!((root.lo - -9.667_293_313_452_913e-17).abs() < 1e-31);
}

#[test]
fn sine_of_known_angles() {
    // sin(1) = 0.84147098480789650665250232163029899962256...; sin(1) - fl(sin(1)) from these digits.
    let (s, c) = Dd::ONE.sin_cos();
    let digits = Dd::new(0.841_470_984_807_896_5, 0.0);
    let rest = s - digits;
    // 0.84147098480789650665250232163029900 - 0.8414709848078965048756572286947630345821380615234375
    assert!((rest.to_f64() - 1.776_845_092_935_6e-18).abs() < 1e-30, "{rest:?}");
    assert!(close(s * s + c * c, Dd::ONE, 1e-31));
}

#[test]
fn a_nan_lane_is_not_hidden() {
    let x = Lanes([1.0, f64::NAN, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    assert!(x.least().is_nan() && x.greatest().is_nan());
    assert!(Lanes::from_f64(-1.0).sqrt().least().is_nan());
}

proptest! {
    #[test]
    fn addition_theorem_holds_in_double_double(a in -300.0..300.0f64, b in -3.0..3.0f64) {
        let (sa, ca) = Dd::from_f64(a).sin_cos();
        let (sb, cb) = Dd::from_f64(b).sin_cos();
        let (s, c) = (Dd::from_f64(a) + Dd::from_f64(b)).sin_cos();
        prop_assert!(close(s, sa * cb + ca * sb, 1e-29));
        prop_assert!(close(c, ca * cb - sa * sb, 1e-29));
        prop_assert!((s.to_f64() - (a + b).sin()).abs() < 1e-13);
    }

    #[test]
    fn division_undoes_multiplication(a in -1e3..1e3f64, b in 0.1..1e3f64) {
        let (x, y) = (Dd::ratio(a, 3.0), Dd::ratio(b, 7.0));
        prop_assert!(close(x * y / y, x, 1e-28));
    }

    #[test]
    fn lanes_do_what_each_number_does(a in prop::array::uniform8(0.1..9.0f64), b in prop::array::uniform8(0.1..9.0f64)) {
        let x = (Lanes(a) * Lanes(b) + Lanes(a)) / Lanes(b) - Lanes(b).sqrt();
        for i in 0..Lanes::WIDTH {
            prop_assert_eq!(x.0[i].to_bits(), ((a[i] * b[i] + a[i]) / b[i] - b[i].sqrt()).to_bits());
        }
        prop_assert_eq!(Lanes(a).least().to_bits(), a.iter().copied().fold(f64::INFINITY, f64::min).to_bits());
    }
}
