//! The working of a position as equations, and the numbers by which tables refer to them.

use std::cell::RefCell;

use assur_book::{Block, Document, Term};
use assur_mechanism::FlywheelPlace;
use assur_motor::Characteristic;
use assur_words::{Describe, Text, number, text};
use assur_working::{WorkingError, digits_told};
use assur_worksheet::{Entry, Expr, Names, Section, Sheet, Symbol, Units};

use crate::context::Context;
use crate::working;

/// What a section of the working finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Finds {
    /// Positions and transfer functions.
    Motion,
    /// Reactions and the balancing load.
    Forces,
}

/// Sections by the identities of their titles.
const SECTIONS: [(&str, Finds); 8] = [
    ("working-input", Finds::Motion),
    ("working-driven", Finds::Motion),
    ("working-group", Finds::Motion),
    ("working-inertia-loads", Finds::Forces),
    ("working-loads", Finds::Forces),
    ("working-reactions", Finds::Forces),
    ("working-input-forces", Finds::Forces),
    ("working-balancing-load", Finds::Forces),
];

/// Paragraphs that refer to formulas further on, which have their numbers only when all of the note is written.
#[derive(Debug, Default)]
pub(super) struct Formulas {
    /// The number of the block, and what its formulas find.
    wanted: RefCell<Vec<(usize, Finds)>>,
    /// The numbers of formulas, and what they find.
    found: RefCell<Vec<(usize, Finds)>>,
}

impl Formulas {
    /// Leaves room for a paragraph that names the formulas behind the tables before it; none without a table.
    pub(super) fn refer(&self, page: &mut Document, finds: Finds) {
        if !matches!(page.blocks.last(), Some(Block::Table(_) | Block::Facts { .. })) {
            return;
        }
        self.wanted.borrow_mut().push((page.blocks.len(), finds));
        page.paragraph(Text::default());
    }

    fn add(&self, number: usize, section: &Section) {
        let known = SECTIONS.iter().find(|(id, _)| section.title.identity() == Some(id));
        self.found.borrow_mut().extend(known.map(|(_, finds)| (number, *finds)));
    }

    /// Writes the paragraphs; one whose formulas are not in the note goes.
    pub(super) fn resolve(&self, page: &mut Document, position: usize, has_friction: bool) {
        for (at, finds) in self.wanted.take().into_iter().rev() {
            let found = self.found.borrow();
            let mut numbers = found.iter().filter(|(_, own)| *own == finds).map(|(number, _)| *number);
            let (first, last) = (numbers.next(), numbers.next_back());
            let (Some(first), Some(last)) = (first, last) else {
                page.blocks.remove(at);
                continue;
            };
            let id = match finds {
                Finds::Motion => "note-formulas-of-motion",
                Finds::Forces if has_friction => "note-formulas-of-forces-with-friction",
                Finds::Forces => "note-formulas-of-forces",
            };
            let [position, first, last] = [position, first, last].map(number);
            let values = vec![("position", position), ("first", first), ("last", last)];
            page.blocks[at] = Block::Paragraph(Text::message(id, values));
        }
    }
}

pub(super) fn working(context: &Context<'_>, page: &mut Document) -> Result<(), Text> {
    let position = context.positions[0];
    let working = working::of_position(context.found.plans.calculation(), position);
    let is_instant = context.results.samples().is_some();
    let heading = if is_instant { "note-working-of-instant" } else { "note-working" };
    page.heading(Text::message(heading, vec![("position", number(position))]));
    page.paragraph(text!("note-working-text", position = number(position)));
    let sections = match working {
        Ok(working) => working.sections,
        Err(error @ (WorkingError::Load { .. } | WorkingError::OverTime)) => {
            page.paragraph(error.describe());
            return Ok(());
        }
        Err(error) => return Err(error.describe()),
    };
    // The first section repeats title and structure.
    sections.iter().skip(1).for_each(|section| add(context, section, page));
    Ok(())
}

/// The energy form of the motion, step by step; nothing where the motion is prescribed.
pub(super) fn energy(context: &Context<'_>, page: &mut Document) {
    let sections = working::energy(&context.found.analysis, &context.results.linkage.mechanism);
    if !sections.is_empty() {
        page.heading(text!("note-energy-form"));
        for section in &sections {
            add(context, section, page);
        }
    }
}

/// The moment of the motor by Kloss's formula and the inertia of the drive, both reduced to the input, in the first of the chosen
/// positions; nothing without such a motor.
pub(super) fn drive(context: &Context<'_>, page: &mut Document) {
    let Some(sheet) = drive_sheet(context) else { return };
    for section in &sheet.sections {
        add(context, section, page);
    }
}

fn drive_sheet(context: &Context<'_>) -> Option<Sheet> {
    let (calculation, position) = (context.found.plans.calculation(), context.positions[0]);
    let mechanism = &calculation.linkage.mechanism;
    let found = context.found.analysis.dynamics.as_ref()?;
    let (motor, drive) = (found.motor.as_ref()?, mechanism.drive.as_ref()?);
    let state = calculation.state(mechanism.input.coordinate(position));
    let [moment, inertia] = calculation.drive_in(&state)?;
    let mut sheet = Sheet::new(Names::default(), Units::ANGULAR);
    sheet.section(text!("note-drive-formulas", position = number(position)));
    sheet.note(text!("note-drive-text"));
    let speed = sheet.given("ω", state.speed.abs(), "rad/s", text!("note-drive-speed"));
    let ratio = sheet.given("u", found.figures.ratio?, "", text!("fact-gear-ratio"));
    let own = kloss(&mut sheet, &motor.work.characteristic, &(&ratio * speed))?;
    let efficiency = sheet.given("η", drive.efficiency, "", text!("note-drive-efficiency"));
    let drives = own.value() >= 0.0;
    let reduced = if drives { own * &ratio * efficiency } else { own * &ratio / efficiency };
    let reduced = sheet.work(of_drive("M"), &reduced, "N·m");
    let flywheel = found.flywheel.filter(|flywheel| *flywheel > 0.0);
    let flywheel = match flywheel {
        Some(own) => sheet.given(Symbol::from("J").of("f"), own, "kg·m²", text!("note-drive-flywheel")),
        None => Expr::zero(),
    };
    let rotor = motor.motor.rotor_inertia.unwrap_or(0.0);
    let rotor = sheet.given(Symbol::from("J").of("r"), rotor, "kg·m²", text!("note-drive-rotor"));
    let on_motor = drive.flywheel_on == FlywheelPlace::Motor;
    let square = ratio.squared();
    let own = if on_motor { (flywheel + rotor) * square } else { flywheel + rotor * square };
    let own = sheet.work(of_drive("J"), &own, "kg·m²");
    // What the formulas give is shown only where it is what the regime has.
    (is_near(reduced.value(), moment.abs()) && is_near(own.value(), inertia)).then_some(sheet)
}

/// The torque of a motor at its speed by Kloss's formula; `None` where its characteristic is a straight line.
fn kloss(sheet: &mut Sheet, characteristic: &Characteristic, speed: &Expr) -> Option<Expr> {
    let of = |letter: &'static str, below: &'static str| Symbol::from(letter).of(below);
    let synchronous = characteristic.synchronous_speed;
    let synchronous = sheet.given(of("ω", "0"), synchronous, "rad/s", text!("note-drive-synchronous"));
    let slip = sheet.work("s", &((&synchronous - speed) / &synchronous), "");
    let most = characteristic.breakdown_torque?;
    let most = sheet.given(of("M", "k"), most, "N·m", text!("note-drive-breakdown"));
    let critical = characteristic.critical_slip?;
    let critical = sheet.given(of("s", "k"), critical, "", text!("note-drive-critical-slip"));
    let torque = Expr::number(2.0) * most / (&slip / &critical + &critical / &slip);
    Some(sheet.work("M", &torque, "N·m"))
}

fn of_drive(letter: &'static str) -> Symbol {
    Symbol::from(letter).of(text!("working-of-drive"))
}

/// Whether two numbers are one but for rounding in the solution of the regime.
fn is_near(one: f64, other: f64) -> bool {
    const ROUNDING: f64 = 1e-6;
    (one - other).abs() <= ROUNDING * other.abs()
}

fn add(context: &Context<'_>, section: &Section, page: &mut Document) {
    page.blocks.push(Block::Subheading(section.title.clone()));
    let digits = context.note.digits;
    let is_of_digits = |text: &Text| text.identity() == digits_told(digits).identity();
    for entry in section.entries.iter().map(|entry| entry.with_digits(digits)) {
        page.blocks.push(match &entry {
            Entry::Note(text) if is_of_digits(text) => Block::Paragraph(digits_told(digits)),
            Entry::Note(text) => Block::Paragraph(text.clone()),
            equation => {
                let before = page.blocks.iter().filter(|block| matches!(block, Block::Equation(_))).count();
                context.formulas.add(before + 1, section);
                Block::Equation(equation.sides().join(&Term::Sign(" = ")))
            }
        });
    }
}
