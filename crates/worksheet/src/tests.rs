use crate::{Entry, Expr, Names, Sheet, Units, WIDTH, text};

fn sheet() -> Sheet {
    Sheet::new(Names { bodies: vec!["ground".into(), "rod".into()], ..Names::default() }, Units::ANGULAR)
}

#[test]
fn a_line_shows_symbols_numbers_and_result() {
    let mut sheet = sheet();
    let a = sheet.given("a", 3.0, "m", "");
    let b = sheet.given("b", -4.0, "m", "side");
    sheet.work("c", &(a.squared() + b.squared()).sqrt(), "m");
    let wanted = "Working\n-------\n  a = 3 m\n  b = -4 m  (side)\n  \
                  c = sqrt(a^2 + b^2) = sqrt(3^2 + (-4)^2) = 5.00000 m\n";
    assert_eq!(text(&sheet.sections, WIDTH), wanted);
}

#[test]
fn digits_grow_where_a_difference_needs_them() {
    let mut sheet = sheet();
    let a = sheet.given("a", 1.000_000_123_4, "", "");
    let b = sheet.given("b", 1.0, "", "");
    sheet.work("c", &(a - b), "");
    let Some(Entry::Line(line)) = sheet.sections[0].entries.last() else { panic!("no line") };
    assert_eq!(line.result, "1.23400e-7");
    assert_eq!(line.substituted, "1.0000001234 - 1");
}

#[test]
fn minus_and_parentheses() {
    let [a, b, c] = [-2.0, 3.0, 4.0].map(|v| Expr::symbol("s", v));
    let shown = |expr: &Expr| expr.show(crate::line::Show::Digits(6));
    assert_eq!(shown(&(&b - (&a - &c))), "3 - (-2 - 4)");
    assert_eq!(shown(&(&a * &b)), "-2*3");
    assert_eq!(shown(&(&b * &a)), "3*(-2)");
    assert_eq!(shown(&(&b / (&a * &c))), "3/(-2*4)");
    assert_eq!(shown(&-(&a + &b)), "-(-2 + 3)");
    assert_eq!(shown(&a.squared()), "(-2)^2");
    assert_eq!(shown(&(Expr::zero() * &a + Expr::zero() - &b)), "-3");
}

#[test]
fn what_rounding_leaves_is_zero() {
    let mut sheet = sheet();
    let alpha = sheet.given("alpha", std::f64::consts::FRAC_PI_2, "rad", "");
    let t = sheet.work("t", &alpha.cos(), "");
    assert_eq!(t.value().to_bits(), 0.0_f64.to_bits());
    assert!(
        text(&sheet.sections, WIDTH).ends_with("t = cos(alpha) = cos(1.5708) = 0.00000\n"),
        "{}",
        text(&sheet.sections, WIDTH)
    );
}

#[test]
fn an_equation_without_result_makes_the_sheet_unfit() {
    let mut sheet = sheet();
    let a = sheet.given("a", -1.0, "", "");
    sheet.work("b", &a.sqrt(), "");
    assert!(sheet.is_unfit());
}
