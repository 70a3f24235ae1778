//! Tests of `number`.

use super::{number, plain};

#[test]
fn six_digits() {
    assert_eq!(number(0.0), "0");
    assert_eq!(number(-0.0), "0");
    assert_eq!(number(123.456_789), "123.457");
    assert_eq!(number(-0.001_234_567_8), "-0.00123457");
    assert_eq!(number(1.5e-9), "1.50000e-9");
    assert_eq!(number(-1.339_534e-6), "-1.33953e-6");
    assert_eq!(number(2.873_97e-6), "2.87397e-6");
    assert_eq!(number(f64::NAN), "-");
    assert_eq!(plain(0.5), "0.5");
    assert_eq!(plain(1500.0), "1500");
    assert_eq!(plain(-2.0), "-2");
}
