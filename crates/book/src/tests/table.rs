//! Digits and columns.

use assur_words::{Text, name};

use crate::number::short;
use crate::{Cell, Column, Fact, Table, Unit, row};

fn column(values: &[Option<f64>], beside: f64) -> Vec<String> {
    let own = Column::numbers(name("own"), Unit::NONE, values.iter().copied());
    let other = Column::numbers(name("other"), Unit::NONE, [Some(beside)]);
    let (_, groups) = Table::over(Text::default(), Vec::new(), vec![own, other]).printed();
    groups[0][0].cells.iter().map(ToString::to_string).collect()
}

#[test]
fn a_column_has_the_digits_of_its_largest_value() {
    let cells = column(&[Some(1500.0), Some(-0.25), None, Some(0.0)], 1500.0);
    assert_eq!(cells, ["1500.00", "-0.25", "-", "0.00"]);
    assert_eq!(column(&[Some(0.012_345_678), Some(-1e-9)], 0.0123), ["0.0123457", "0.0000000"]);
    assert_eq!(column(&[Some(2e9), Some(0.0)], 2e9), ["2.00000e9", "0"]);
}

#[test]
fn what_is_rounding_beside_its_kind_is_zero() {
    assert_eq!(column(&[Some(3e-15), Some(-2e-15)], 60.0), ["0", "0"]);
    assert_eq!(column(&[Some(3e-9), Some(-2e-9)], 60.0), ["3.00000e-9", "-2.00000e-9"]);
}

#[test]
fn single_numbers_have_six_digits() {
    assert_eq!([short(2007.9712), short(0.25), short(-1e-5)], ["2007.97", "0.25", "-1.00000e-5"]);
    assert_eq!([short(100.0), short(0.04), short(0.0), short(-12.5)], ["100", "0.04", "0", "-12.5"]);
}

#[test]
fn no_number_that_is_not_finite_is_shown() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(column(&[Some(value), Some(2.5), None], 1.0), ["-", "2.50000", "-"]);
        assert_eq!(short(value), "-");
        assert_eq!(Fact::number("fact-value", value, Unit::NONE).value().to_string(), "-");
    }
}

#[test]
fn few_rows_of_many_owners_stand_as_a_row_for_each_owner() {
    let column = |head, value| Column::numbers(name(head), Unit::LENGTH, [Some(value), None]);
    let group = |owner, columns| crate::Group { owner: name(owner), columns };
    let keys = vec![Column::counted(name("No."), [3, 27])];
    let groups =
        vec![group("A", vec![column("x", 1.0)]), group("B", vec![column("x", 2.0), column("y", 3.0)])];
    let table = Table { caption: Text::default(), keys, owners: name("point"), groups }.by_owner();
    let heads: Vec<_> = table.columns().map(|column| column.head.to_string()).collect();
    assert_eq!(heads, ["point", "No.", "x", "y"]);
    let cells: Vec<_> = table.columns().map(|column| column.cells.clone()).collect();
    assert_eq!(cells[0], ["A", "A", "B", "B"].map(|letter| Cell::Text(name(letter))));
    assert_eq!(cells[2], row![1.0, None::<f64>, 2.0, None::<f64>]);
    assert_eq!(cells[3], [Cell::None, Cell::None, Cell::Number(3.0), Cell::None]);
}

#[test]
fn a_small_ratio_beside_a_great_one_is_no_rounding() {
    let sizes = [4e15, 4e15];
    assert_eq!(crate::Digits::Ratio.write(3.86, sizes, 6).to_string(), "3.86");
    assert_eq!(crate::Digits::Even.write(3.86, sizes, 6).to_string(), "0");
}

#[test]
fn an_iteration_has_two_thirds_more_digits_than_the_table() {
    let told = |value, significant| crate::Digits::Long.write(value, [7.0; 2], significant).to_string();
    assert_eq!([told(6.437_669_937_1, 6), told(6.437_669_937_1, 4)], ["6.437669937", "6.43767"]);
    assert_eq!(told(2.5e-5, 4), "2.50000e-5");
}
