//! Dry friction: moments, forces and powers of the pairs, efficiency, losses over the cycle, where it brakes itself or jams.

use assur_analysis::results::{FrictionCycle, Owner, Quantity};
use assur_book::{Column, Document, Fact, Group, Table, Unit, catalogue, row};
use assur_words::{Text, joined, number, text};

use super::{Source, Values};

/// The friction of the pairs, with its heading.
pub(super) fn friction(source: &Source<'_>, page: &mut Document) {
    if source.analysis.friction.is_some() {
        page.heading(text!("report-friction"));
        friction_tables(source, page);
    }
}

/// The friction of the pairs in each position and over the cycle.
pub fn friction_tables(source: &Source<'_>, page: &mut Document) {
    let Some(cycle) = &source.analysis.friction else { return };
    page.paragraph(text!("report-friction-text"));
    page.facts(Text::default(), facts(cycle, source.coordinate()));
    of_pairs(source, page);
    efficiency(source, page);
    losses(source, cycle, page);
}

/// Efficiency of the cycle, and the intervals in which the mechanism brakes itself or jams.
pub(super) fn facts(cycle: &FrictionCycle, unit: Unit) -> Vec<Fact> {
    let mut facts = Vec::new();
    facts.extend(cycle.efficiency.map(|found| Fact::number("fact-efficiency", found, Unit::NONE)));
    let [wide, narrow] = cycle.self_braking_by_length();
    // By its length, at its ends.
    let fact = |id, ends: &[f64; 2]| Fact::number(id, ends[1] - ends[0], unit).at(ends, unit);
    facts.extend(wide.iter().map(|ends| fact("fact-self-braking", ends)));
    match &narrow[..] {
        [] => {}
        [only] => facts.push(fact("fact-self-braking", only)),
        all => facts.push(narrow_ones(all, cycle.step, unit)),
    }
    facts.extend(cycle.dead_angles.iter().map(|ends| fact("fact-dead-angle", ends)));
    facts
}

/// Several intervals shorter than a step as one fact: their whole length, at the middle of each.
fn narrow_ones(all: &[[f64; 2]], step: f64, unit: Unit) -> Fact {
    let length = all.iter().map(|ends| ends[1] - ends[0]).sum();
    let middles: Vec<f64> = all.iter().map(|[from, to]| 0.5 * (from + to)).collect();
    let fact = Fact::number("fact-self-braking-narrow", length, unit).at(&middles, unit);
    fact.of("count", number(all.len())).of("step", unit.show(step))
}

/// Moments (forces) and powers in the shown positions.
fn of_pairs(source: &Source<'_>, page: &mut Document) {
    let schema = source.positions.schema();
    let owners =
        schema.owners(Quantity::FrictionMoment).into_iter().chain(schema.owners(Quantity::FrictionForce));
    let groups = owners.map(|owner| {
        let of = |quantity| Values::of(quantity, owner);
        let all = [Quantity::FrictionForce, Quantity::FrictionMoment, Quantity::FrictionPower].map(of);
        let columns = all.into_iter().filter(|values| schema.find(*values).is_some());
        let columns = columns.map(|values| source.column(values)).collect();
        let owner = match owner {
            Owner::PairOn(..) => catalogue::owner(schema, of(Quantity::FrictionMoment)),
            owner => source.name(owner),
        };
        Group { owner, columns }
    });
    page.table(source.table(text!("report-friction-table"), text!("head-pair"), groups));
}

/// Balancing load without friction, efficiency, and the certificate of each group, in the shown positions.
fn efficiency(source: &Source<'_>, page: &mut Document) {
    let of = |quantity| Values::of(quantity, Owner::Input);
    let mut columns = Vec::new();
    if !source.mechanism.input.is_list {
        columns.push(source.headed(text!("head-ideal-balancing"), of(Quantity::IdealBalancing)));
        columns.push(source.headed(text!("head-efficiency"), of(Quantity::Efficiency)));
    }
    for owner in source.owners(Quantity::FrictionCertificate, |_| true) {
        let values = Values::of(Quantity::FrictionCertificate, owner);
        let group = catalogue::owner(source.positions.schema(), values);
        columns.push(source.headed(text!("head-certificate", group), values));
    }
    page.table(Table::over(text!("report-efficiency"), source.keys(), columns));
}

/// The loss of each pair over the cycle.
fn losses(source: &Source<'_>, cycle: &FrictionCycle, page: &mut Document) {
    let heads = [Column::of(text!("head-pair")), Column::short(text!("head-friction-work"), Unit::JOULE)];
    let mut table = Table::list(text!("report-friction-work"), heads);
    let pairs = source.mechanism.frictions.iter().zip(cycle.friction_work.values());
    for (friction, work) in pairs {
        let Some(work) = work else { return };
        table.row(row![joined("", [Text::from(source.mechanism.pair_name(friction.pair))]), *work]);
    }
    page.table(table);
}

#[cfg(test)]
mod tests {
    use assur_book::Value;

    use super::*;

    #[test]
    fn narrow_intervals_are_one_fact_with_their_places_and_nothing_is_lost() {
        let unit = Unit::ANGLE;
        let self_braking = vec![[0.1, 0.101], [1.0, 1.3], [2.0, 2.002], [3.0, 3.003]];
        let cycle = FrictionCycle { self_braking, step: 0.01, ..FrictionCycle::default() };
        let found = facts(&cycle, unit);
        assert_eq!(
            found.iter().map(|fact| fact.id).collect::<Vec<_>>(),
            ["fact-self-braking", "fact-self-braking-narrow"]
        );
        assert_eq!(found[0].at, [1.0, 1.3]);
        let Value::Number(length) = found[1].value else { panic!("{:?}", found[1].value) };
        assert!((length - 0.006).abs() < 1e-12, "{length}");
        assert_eq!(found[1].at.len(), 3);
        assert!(found[1].what().to_string().contains("3 places"), "{}", found[1].what());
        // One alone is told as any other.
        let cycle =
            FrictionCycle { self_braking: vec![[0.1, 0.101]], step: 0.01, ..FrictionCycle::default() };
        assert_eq!(facts(&cycle, unit)[0].id, "fact-self-braking");
    }
}
