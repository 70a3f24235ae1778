//! Structure: mobility, pairs and groups.

use assur_analysis::{GroupModes, PossibleInput, StructureStudy, results::StructureReport};
use assur_book::{Block, Column, Document, Table, Term, Unit, link_name, row};
use assur_kinematics::{CourseEnd, Misfit, ModeMeeting, Unlisted};
use assur_mechanism::{CoordinateKind, Named};
use assur_structure::roman;
use assur_words::{Text, joined, list, name, number, ordinal, text};
use assur_worksheet::Symbol;

use super::Source;

/// Links, mobility, formula of structure and class.
pub fn mobility(source: &Source<'_>, page: &mut Document) {
    let (structure, mechanism) = (&source.analysis.structure, source.mechanism);
    let links = list(mechanism.links.iter().skip(1).map(|link| Text::from(&link.name)));
    let input = assur_book::driven_link(mechanism);
    page.paragraph(text!("report-links", count = mechanism.links.len() - 1, links, input));
    counted(structure, source.analysis.input.kind, page);
}

/// Mobility as counted and as it is, formula and class.
fn counted(structure: &StructureReport, kind: CoordinateKind, page: &mut Document) {
    page.paragraph(text!("report-chebyshev"));
    page.blocks.push(Block::Equation(chebyshev(structure)));
    if let Some(found) = structure.mobility_by_rank {
        page.paragraph(text!("report-mobility-by-rank", mobility = number(found)));
    }
    if let Some(note) = &structure.note {
        page.paragraph(text!("report-note", note));
    }
    structure.passive.iter().for_each(|passive| page.paragraph(passive_part(passive, kind)));
    let class = name(roman(structure.class));
    page.paragraph(text!("report-formula", formula = &structure.formula));
    page.paragraph(text!("report-class", class));
}

/// A passive part in words, with its misfit where it has one.
pub fn passive_part(passive: &Misfit, kind: CoordinateKind) -> Text {
    if passive.fits() {
        return text!("report-passive", what = &passive.what);
    }
    let closes = passive.closes.as_ref().map_or_else(Text::default, |closing| {
        let unit = Unit::place(closing.is_angle);
        text!("report-closes", key = &closing.key, value = unit.show(closing.value))
    });
    let [misfit, limit] = [passive.misfit, passive.limit].map(|size| match passive.angle {
        Some(angle) => Unit::ANGLE.show(size * angle / passive.misfit),
        None => Unit::LENGTH.show(size),
    });
    let place = Unit::coordinate(kind).show(passive.at);
    text!("report-misfit", what = &passive.what, misfit, limit, place, closes = closes)
}

/// W = 3 n - 2 p5.
fn chebyshev(structure: &StructureReport) -> Vec<Term> {
    let (count, sign) = (|count: usize| Term::Number(count.to_string()), Term::Sign);
    let [w, n, p] = ["W", "n", "p"].map(Symbol::from);
    let symbols = [Term::Symbol(w), sign(" = "), count(3), Term::Symbol(n), sign(" - "), count(2)];
    let counts = [
        Term::Symbol(p.of("5")),
        sign(" = "),
        count(3),
        sign("*"),
        count(structure.moving_links),
        sign(" - "),
        count(2),
        sign("*"),
        count(structure.pairs),
    ];
    let result = [sign(" = "), Term::Number(structure.mobility.to_string())];
    symbols.into_iter().chain(counts).chain(result).collect()
}

/// The kinematic pairs.
pub fn pairs(source: &Source<'_>, page: &mut Document) {
    let mechanism = source.mechanism;
    let heads = [text!("head-pair"), text!("head-sort"), text!("head-links"), text!("head-count")];
    let mut table = Table::list(text!("report-pairs"), heads.map(Column::of));
    for pin in mechanism.points.iter().filter(|point| point.is_pin()) {
        let links = list(pin.places.iter().map(|place| link_name(mechanism, place.link)));
        let sort =
            if pin.places.len() > 2 { text!("report-multiple-joint") } else { text!("report-turning") };
        table.row(row![Text::from(&pin.name), sort, links, pin.places.len() - 1]);
    }
    for slide in &mechanism.slides {
        let links = list([slide.link, slide.on].map(|link| link_name(mechanism, link)));
        table.row(row![&slide.name, text!("report-sliding"), links, 1_usize]);
    }
    page.table(table);
}

/// Names with commas between them.
pub(super) fn named<I>(all: &[Named<I>]) -> Text {
    list(all.iter().map(Text::from))
}

/// The groups in solving order.
pub fn groups(source: &Source<'_>, page: &mut Document) {
    groups_of(&source.analysis.structure, page);
}

fn groups_of(structure: &StructureReport, page: &mut Document) {
    let table = Table::each(text!("report-groups"), structure.groups.iter().enumerate())
        .column(text!("head-group"), |(index, _)| index + 1)
        .column(text!("head-kind"), |(_, group)| &group.kind)
        .column(text!("head-class"), |(_, group)| name(roman(group.class)))
        .column(text!("head-type"), |(_, group)| (group.number > 0).then(|| number(group.number)))
        .column(text!("head-order"), |(_, group)| number(group.order))
        .column(text!("head-links"), |(_, group)| named(&group.links))
        .column(text!("head-inner"), |(_, group)| named(&group.inner))
        .column(text!("head-outer"), |(_, group)| named(&group.outer));
    let has_driven = structure.groups.iter().any(|group| !group.driven.is_empty());
    let table = if has_driven {
        table.column(text!("head-driven"), |(_, group)| named(&group.driven))
    } else {
        table
    };
    let table = if structure.groups.iter().any(|group| !group.inputs.is_empty()) {
        table.column(text!("head-inputs"), |(_, group)| list(group.inputs.iter().map(Text::from)))
    } else {
        table
    };
    let table = table
        .column(text!("head-mode"), |(_, group)| group.mode.map(ordinal))
        .column(text!("head-modes"), |(_, group)| group.mode_count.map(number));
    page.table(table.table());
}

/// The answer of `assur structure`.
pub fn study(found: &StructureStudy, page: &mut Document) {
    page.scene(&found.title);
    if let Some(structure) = &found.structure {
        counted(structure, found.kind, page);
        groups_of(structure, page);
    }
    if !found.inputs.is_empty() {
        possible_inputs(found, page);
    }
    let unit = Unit::coordinate(found.kind);
    found.modes.iter().for_each(|group| modes(group, unit, page));
}

/// The modes of a group over the cycle.
fn modes(group: &GroupModes, unit: Unit, page: &mut Document) {
    let named = text!(
        "report-modes-of",
        group = number(group.group),
        kind = name(group.kind.clone()),
        links = named(&group.links)
    );
    let (Some(circuits), Some(branches)) = (group.courses.circuits, group.courses.branches) else {
        let unlisted = match group.unlisted {
            Some(Unlisted::At(place)) => {
                text!("report-modes-together", group = named, coordinate = unit.show(place))
            }
            _ => text!("report-modes-unlisted", group = named),
        };
        return page.paragraph(unlisted);
    };
    let table = Table::each(named, &group.courses.modes)
        .column(text!("head-mode"), |mode| ordinal(mode.way))
        .measured(text!("head-from"), unit, |mode| mode.from)
        .measured(text!("head-to"), unit, |mode| mode.to)
        .column(text!("head-begins"), |mode| mode_end(mode.begins))
        .column(text!("head-ends"), |mode| mode_end(mode.ends))
        .column(text!("head-circuit"), |mode| ordinal(mode.circuit))
        .column(text!("head-branch"), |mode| ordinal(mode.branch));
    page.table(table.table());
    let counts = group.courses.counts.iter().map(|count| {
        text!("report-modes-from", count = number(count.modes), coordinate = unit.show(count.from))
    });
    page.paragraph(text!("report-modes-count", counts = joined("; ", counts)));
    page.paragraph(text!("report-modes-circuits", circuits, branches));
    if let Some(way) = group.way {
        page.paragraph(text!("report-modes-present", mode = ordinal(way)));
    }
    let meeting = |meeting: &ModeMeeting| {
        let [one, other] = meeting.ways.map(ordinal);
        text!("report-modes-meeting", one, other, coordinate = unit.show(meeting.at))
    };
    if !group.courses.meetings.is_empty() {
        let meetings = joined("; ", group.courses.meetings.iter().map(meeting));
        page.paragraph(text!("report-modes-meet", meetings));
    }
}

/// How a mode begins or ends.
pub(super) fn mode_end(end: CourseEnd) -> Text {
    match end {
        CourseEnd::Cycle => text!("mode-end-cycle"),
        CourseEnd::With(other) => text!("mode-end-with", mode = ordinal(other)),
        CourseEnd::Infinity => text!("mode-end-infinity"),
        CourseEnd::Barrier => text!("mode-end-barrier"),
    }
}

/// What the structure would be with each possible input.
fn possible_inputs(found: &StructureStudy, page: &mut Document) {
    let structure = |input: &PossibleInput| {
        let structure = input.formula.as_ref().map(|formula| {
            let parts = list(input.passive.iter().cloned());
            if input.passive.is_empty() {
                Text::from(formula)
            } else {
                text!("report-formula-without", formula, parts)
            }
        });
        structure.or_else(|| input.why.clone())
    };
    let table = Table::each(text!("report-inputs"), &found.inputs)
        .column(text!("head-input"), |input| Text::from(&input.link))
        .column(text!("head-pair"), |input| Text::from(&input.pair))
        .column(text!("head-class"), |input| input.class.map(|class| name(roman(class))))
        .column(text!("head-structure"), |input| structure(input));
    page.table(table.table());
    let simpler: Vec<Text> = found.simpler().map(|input| Text::from(&input.link)).collect();
    if !simpler.is_empty() {
        page.paragraph(text!("report-simpler-inputs", count = simpler.len(), links = list(simpler)));
    }
}
