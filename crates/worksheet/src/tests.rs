use assur_words::{Language, Text, name};

use crate::term::Show;
use crate::{Entry, Expr, Names, Section, Sheet, Symbol, Units, WIDTH};

fn text(sections: &[Section], language: &str) -> String {
    crate::text(sections, WIDTH, Language::find(language).unwrap_or_else(Language::english))
}

fn plain(expr: &Expr, show: Show) -> String {
    expr.terms(show).iter().fold(String::new(), |line, term| line + &term.text().to_string())
}

fn sheet() -> Sheet {
    Sheet::new(Names { bodies: vec![name("ground"), name("rod")], ..Names::default() }, Units::ANGULAR)
}

#[test]
fn a_line_shows_symbols_numbers_and_result() {
    let mut sheet = sheet();
    let a = sheet.given("a", 3.0, "m", Text::default());
    let b = sheet.given("b", -4.0, "m", name("side"));
    sheet.work("c", &(a.squared() + b.squared()).sqrt(), "m");
    let wanted = "Working\n-------\n  a = 3 m\n  b = -4 m  (side)\n  \
                  c = sqrt(a^2 + b^2) = sqrt(3^2 + (-4)^2) = 5.00000 m\n";
    assert_eq!(text(&sheet.sections, "en"), wanted);
}

#[test]
fn digits_grow_where_a_difference_needs_them() {
    let mut sheet = sheet();
    let a = sheet.given("a", 1.000_000_123_4, "", Text::default());
    let b = sheet.given("b", 1.0, "", Text::default());
    sheet.work("c", &(a - b), "");
    let Some(Entry::Line(line)) = sheet.sections[0].entries.last() else { panic!("no line") };
    assert_eq!(line.result, "1.23400e-7");
    assert_eq!(plain(&line.formula, Show::Digits(line.digits)), "1.0000001234 - 1");
}

#[test]
fn minus_and_parentheses() {
    let [a, b, c] = [-2.0, 3.0, 4.0].map(|v| Expr::symbol("s", v));
    let shown = |expr: &Expr| plain(expr, Show::Digits(6));
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
    let alpha = sheet.given("α", std::f64::consts::FRAC_PI_2, "rad", Text::default());
    let t = sheet.work("t", &alpha.cos(), "");
    assert_eq!(t.value().to_bits(), 0.0_f64.to_bits());
    assert!(
        text(&sheet.sections, "en").ends_with("t = cos(α) = cos(1.5708) = 0.00000\n"),
        "{}",
        text(&sheet.sections, "en")
    );
}

#[test]
fn an_equation_without_result_makes_the_sheet_unfit() {
    let mut sheet = sheet();
    let a = sheet.given("a", -1.0, "", Text::default());
    sheet.work("b", &a.sqrt(), "");
    assert!(sheet.is_unfit());
}

#[test]
fn subscripts_are_words_of_a_language_and_names_are_not() {
    let mut sheet = sheet();
    let x =
        sheet.given(Symbol::from("x").prime(1).of(Symbol::from("S").of("m/n")), -0.25, "m", Text::default());
    let q = sheet.given("q", 1.5, "kg·m²", assur_words::text!("worksheet-fixed"));
    sheet.work(Symbol::from("φ").of(assur_words::unit("deg")), &q.atan2(&x), "rad");
    let wanted = "Розрахунок\n----------\n  x′_S_m_n = −0,25 м\n  q = 1,5 кг·м²  (нерухома)\n  \
                  φ_град = atan2(q; x′_S_m_n) = atan2(1,5; −0,25) = 1,73595 рад\n";
    assert_eq!(text(&sheet.sections, "uk"), wanted);
    let Some(Entry::Line(line)) = sheet.sections[0].entries.last() else { panic!("no line") };
    assert_eq!(Text::from(&line.symbol).to_string(), "φ_deg");
}
