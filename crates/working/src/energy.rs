//! The energy form of the equation of motion as an algorithm (E eqs. 1-3, 7, 10, and the two examples of E): works, kinetic
//! energy, speed; and over a cycle the flywheel.

use std::f64::consts::PI;

use assur_dynamics::Figures;
use assur_mechanism::{LinkId, LoadId, Mechanism, Torque};
use assur_words::{self as words, Text, joined, text, unit};
use assur_worksheet::{Expr, Names, Section, Sheet, Symbol, Units};

use crate::area::{Area, area_under};

/// One end of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ending {
    /// Coordinate of the input, rad (m).
    pub coordinate: f64,
    /// Its speed, rad/s (m/s).
    pub speed: f64,
    /// Kinetic energy, of flywheel and rotor as well, J.
    pub energy: f64,
}

/// The work of one cause over a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Done {
    /// What it is called.
    pub name: Text,
    /// Which of [`Mechanism::loads`] it is, if it is one.
    pub load: Option<LoadId>,
    /// The work, J.
    pub work: f64,
}

/// A motion whose energy form is worked.
#[derive(Debug, Clone, PartialEq)]
pub struct EnergyForm<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// Start and end.
    pub ends: [Ending; 2],
    /// The works between them; of a drive that balances the others none.
    pub works: Vec<Done>,
    /// Kinetic energies of the links at the end, J.
    pub links: Vec<(LinkId, f64)>,
    /// Inertia reduced to the input, kg m² (kg), where it is the same all the time.
    pub inertia: Option<f64>,
    /// The figures of a regime, of which this is a cycle; else it is a motion from an initial state.
    pub cycle: Option<&'a Figures>,
}

/// The working under construction.
struct Work<'a> {
    form: &'a EnergyForm<'a>,
    sheet: Sheet,
    /// Moments that are given already: of which load, its number, and the moment.
    moments: Vec<(Text, usize, f64)>,
}

/// A work below this part of the greatest one is rounding.
const ROUNDING: f64 = 1e-9;

/// A coordinate with six digits.
fn shortest(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    (rounded + 0.0).to_string()
}

impl EnergyForm<'_> {
    /// Writes it.
    pub fn sections(&self) -> Vec<Section> {
        let units = if self.mechanism.input.is_angle() { Units::ANGULAR } else { Units::LINEAR };
        let sheet = Sheet::new(Names::default(), units);
        let mut work = Work { form: self, sheet, moments: Vec::new() };
        let way = work.way();
        let [driving, resisting] = work.works();
        match self.cycle {
            None => {
                work.speed(&(driving - resisting));
                work.uniform();
            }
            Some(cycle) => work.flywheel(cycle, &way, &(driving - resisting)),
        }
        work.sheet.sections
    }

    /// The constant moment (force) of the drive that makes the work of the cycle zero, where the scene asks for it, N m (N).
    pub fn balance(&self) -> Option<f64> {
        let drive = self.mechanism.drive.as_ref()?;
        self.cycle?.torque.filter(|_| drive.torque == Torque::Balance)
    }
}

impl Work<'_> {
    /// A coordinate; an angle that is a simple part of pi as such.
    fn coordinate(&self, value: f64) -> Expr {
        /// Parts of pi that are written as such.
        const PARTS: [f64; 6] = [1.0, 2.0, 3.0, 4.0, 6.0, 12.0];
        let is_whole = |part: &&f64| {
            let count = value / PI * **part;
            (count - count.round()).abs() < 1e-12 * count.abs().max(1.0)
        };
        let part = PARTS.iter().find(is_whole).filter(|_| self.form.mechanism.input.is_angle());
        if let Some(part) = part {
            let pi = Expr::number((value / PI * part).abs().round()) * Expr::pi() / Expr::number(*part);
            return if value < 0.0 { -pi } else { pi };
        }
        // What an integration left of a whole number is its rounding.
        let whole = value.round();
        let value = if (value - whole).abs() <= 1e-12 * value.abs() { whole } else { value };
        if value < 0.0 { -Expr::number(-value) } else { Expr::number(value) }
    }

    /// The way of the input from start to end.
    fn way(&mut self) -> Expr {
        let [start, end] = self.form.ends.map(|end| self.coordinate(end.coordinate));
        self.sheet.section(text!("working-energy-way"));
        let way = self.sheet.work("φ", &(end - start), self.sheet.units.input[0]);
        if self.form.mechanism.input.is_angle() {
            self.sheet.note(text!("working-energy-turns"));
            self.sheet.work("n", &(&way / (Expr::number(2.0) * Expr::pi())), "");
        }
        way
    }

    /// Works of what drives and of what resists, both positive.
    fn works(&mut self) -> [Expr; 2] {
        self.sheet.section(text!("working-energy-works"));
        self.sheet.note(text!("working-energy-work-is"));
        let ends = self.form.ends.map(|end| end.coordinate);
        let mut sums = [Expr::zero(), Expr::zero()];
        let greatest = self.form.works.iter().map(|done| done.work.abs()).fold(0.0, f64::max);
        // A work that is only rounding, as that of the weights over a cycle, is none.
        let done = self.form.works.iter().filter(|done| done.work.abs() > ROUNDING * greatest);
        for done in done {
            let symbol = Symbol::from("A").of(&done.name);
            self.sheet.note(text!("working-energy-work-of", load = &done.name));
            let area = done.load.and_then(|id| area_under(self.form.mechanism, id, ends));
            let work = match area {
                Some(area) => {
                    let area = self.area(&area, &done.name);
                    self.sheet.work(symbol, &area, "J")
                }
                None => self.sheet.given(symbol, done.work, "J", text!("working-energy-by-quadrature")),
            };
            if done.work > 0.0 {
                sums[0] = &sums[0] + work;
            } else {
                sums[1] = &sums[1] - work;
            }
        }
        self.sheet.note(text!("working-energy-sums"));
        let balances = self.form.balance().is_some();
        let [driving, resisting] = sums;
        [("working-of-drive", driving), ("working-of-resistance", resisting)].map(|(below, sum)| {
            // The drive that balances the loads does a work, too, which is still to be found.
            let open = balances && sum.is_zero();
            let symbol = Symbol::from("A").of(text!(below));
            if open { sum } else { self.sheet.work(symbol, &sum, "J") }
        })
    }

    /// Speed and way of a motion under constant moments, by time (D eqs. 3.12, 3.13); nothing for another motion.
    fn uniform(&mut self) {
        let EnergyForm { ends: [start, end], inertia, works, mechanism, .. } = self.form;
        let places = [start.coordinate, end.coordinate];
        let constant = |done: &Done| {
            let area = area_under(mechanism, done.load?, places)?;
            let first = area.first()?[0][1];
            area.iter().flatten().all(|node| node[1].to_bits() == first.to_bits()).then_some(first)
        };
        let moments: Option<Vec<f64>> = works.iter().map(constant).collect();
        let (Some(inertia), Some(moments)) = (*inertia, moments) else { return };
        let Units { input: [coordinate, speed, rate], moment, inertia: [inertia_unit, _], .. } =
            self.sheet.units;
        if moments.iter().sum::<f64>() == 0.0 {
            return;
        }
        self.sheet.section(text!("working-energy-uniform"));
        let known = works
            .iter()
            .zip(moments)
            .map(|(done, moment)| Expr::symbol(Symbol::from("M").of(&done.name).of(1), moment));
        let sum = known.fold(Expr::zero(), |sum, moment| sum + moment);
        let sum = self.sheet.work("M", &sum, moment);
        let inertia = self.sheet.given("J", inertia, inertia_unit, text!("working-energy-inertia"));
        let acceleration = self.sheet.work("ε", &(sum / inertia), rate);
        let what = text!("working-energy-speed-at-start");
        let first = self.sheet.given(Symbol::from("ω").of(0), start.speed, speed, what);
        let what = text!("working-energy-speed-at-end");
        let last = self.sheet.given(Symbol::from("ω").of(1), end.speed, speed, what);
        self.sheet.note(text!("working-energy-by-time", speed = &Symbol::from("ω").of(0)));
        let time = self.sheet.work("t", &((last - &first) / &acceleration), "s");
        self.sheet.note(text!("working-energy-way-by-time"));
        let way = acceleration * time.squared() / Expr::number(2.0) + first * time;
        self.sheet.work("φ", &way, coordinate);
    }

    /// The area under straight lines: the sum of trapezoids between their nodes.
    fn area(&mut self, area: &Area, name: &Text) -> Expr {
        let mut sum = Expr::zero();
        let mut last: Option<([f64; 2], Expr)> = None;
        for [from, to] in area {
            let node = |work: &mut Self, [at, moment]: [f64; 2]| {
                let same =
                    |(of, _, known): &&(Text, usize, f64)| of == name && known.to_bits() == moment.to_bits();
                let symbol = |number| Symbol::from("M").of(name).of(number);
                if let Some((_, number, _)) = work.moments.iter().find(same) {
                    return Expr::symbol(symbol(*number), moment);
                }
                let number = 1 + work.moments.iter().filter(|(of, ..)| of == name).count();
                work.moments.push((name.clone(), number, moment));
                let place = joined(" ", [words::number(shortest(at)), unit(work.sheet.units.input[0])]);
                let what = text!("working-energy-moment-at", at = place);
                work.sheet.given(symbol(number), moment, work.sheet.units.moment, what)
            };
            let one = match last.take().filter(|(at, _)| at.map(f64::to_bits) == from.map(f64::to_bits)) {
                Some((_, known)) => known,
                None => node(self, *from),
            };
            let other = if from[1].to_bits() == to[1].to_bits() { one.clone() } else { node(self, *to) };
            let way = self.coordinate(to[0]) - self.coordinate(from[0]);
            let height =
                if from[1].to_bits() == to[1].to_bits() { one } else { (one + &other) / Expr::number(2.0) };
            sum = sum + height * way;
            last = Some((*to, other));
        }
        sum
    }

    /// The speed at the end from the works (E eq. 1, example 1).
    fn speed(&mut self, excess: &Expr) {
        let EnergyForm { ends: [start, end], links, mechanism, .. } = self.form;
        self.sheet.section(text!("working-energy-excess"));
        self.sheet.note(text!("working-energy-change"));
        let excess = self.sheet.work("A", excess, "J");
        let first =
            self.sheet.given(Symbol::from("T").of(0), start.energy, "J", text!("working-energy-at-start"));
        let energy = self.sheet.work("T", &(first + excess), "J");
        if links.len() > 1 {
            self.sheet.note(text!("working-energy-of-links"));
            for (link, part) in links {
                let symbol = Symbol::from("T").of(Text::from(&mechanism.links[*link].name));
                self.sheet.given(symbol, *part, "J", text!("working-energy-of-link"));
            }
        }
        // At rest there is nothing to find; the rounding of the sums would stand under the root.
        if end.speed == 0.0 {
            return self.sheet.note(text!("working-energy-rest"));
        }
        self.sheet.section(text!("working-energy-speed"));
        let inertia = 2.0 * end.energy / (end.speed * end.speed);
        let what = text!("working-energy-inertia");
        let inertia = self.sheet.given("J", inertia, self.sheet.units.inertia[0], what);
        let speed = (Expr::number(2.0) * energy / inertia).sqrt();
        let speed = if end.speed < 0.0 { -speed } else { speed };
        self.sheet.work("ω", &speed, self.sheet.units.input[1]);
    }

    /// The flywheel of a cycle (E eqs. 7, 10, example 2).
    fn flywheel(&mut self, cycle: &Figures, way: &Expr, excess: &Expr) {
        let mut balance = Expr::zero();
        if let Some(moment) = self.form.balance() {
            balance = self.balance(moment, way, excess);
        }
        self.sheet.section(text!("working-energy-extremes"));
        // Where J varies, its change takes a moment, too.
        let is_constant = self.form.inertia.is_some();
        let told = if is_constant { "working-energy-where" } else { "working-energy-where-it-varies" };
        self.sheet.note(text!(told));
        let [least, greatest] = ["working-of-least", "working-of-greatest"].map(|below| text!(below));
        let extremes = [cycle.coordinate_at_min, cycle.coordinate_at_max];
        let places = [(&least, extremes[0]), (&greatest, extremes[1])].map(|(below, value)| {
            let value = self.coordinate(value);
            self.sheet.work(Symbol::from("φ").of(below), &value, self.sheet.units.input[0])
        });
        let between = self.sheet.work("Δφ", &(&places[1] - &places[0]), self.sheet.units.input[0]);
        let speeds = [(&least, cycle.speed_min), (&greatest, cycle.speed_max)].map(|(below, value)| {
            self.sheet.given(Symbol::from("ω").of(below), value, self.sheet.units.input[1], Text::default())
        });
        let mean = Symbol::from("ω").of(text!("working-of-mean"));
        let two = Expr::number(2.0);
        let mean = self.sheet.work(mean, &((&speeds[0] + &speeds[1]) / &two), self.sheet.units.input[1]);
        let uneven = self.sheet.work("δ", &((&speeds[1] - &speeds[0]) / &mean), "");
        self.sheet.section(text!("working-energy-excess"));
        let symbol = Symbol::from("A").of(text!("working-of-excess"));
        let work = match self.excess_between(extremes, &balance, &between) {
            Some(work) => self.sheet.work(symbol, &work, "J"),
            None => self.sheet.given(symbol, cycle.excess_work, "J", text!("working-energy-by-quadrature")),
        };
        self.sheet.section(text!("working-energy-flywheel"));
        let inertia = &work / (mean.squared() * &uneven);
        self.sheet.work(
            Symbol::from("J").of(text!("working-of-flywheel")),
            &inertia,
            self.sheet.units.inertia[0],
        );
        self.sheet.note(text!("working-energy-neglects"));
        self.sheet.section(text!("working-energy-artobolevsky"));
        self.sheet.work("χ", &(two * uneven / between), "");
    }

    /// The constant moment of the drive that makes the work of the cycle zero, along the motion. One that resists has the symbol and
    /// the sign of a resistance (E example 2).
    fn balance(&mut self, moment: f64, way: &Expr, excess: &Expr) -> Expr {
        let resists = moment * way.value() < 0.0;
        let letter = if self.form.mechanism.input.is_angle() { "M" } else { "F" };
        let (title, below) = if resists {
            ("working-energy-balance-resists", "working-of-resistance")
        } else {
            ("working-energy-balance", "working-of-drive")
        };
        self.sheet.section(text!(title));
        self.sheet.note(text!("working-energy-equal-works"));
        let sum = excess / way;
        let size = if resists { sum } else { -sum };
        let size = self.sheet.work(Symbol::from(letter).of(text!(below)), &size, self.sheet.units.moment);
        self.sheet.work(Symbol::from("A").of(text!(below)), &(&size * way), "J");
        let balance = if resists { -size } else { size };
        debug_assert!((balance.value() - moment).abs() <= 1e-6 * (1.0 + moment.abs()));
        balance
    }

    /// The work of everything between the places of least and greatest speed, if all of it can be followed by hand.
    fn excess_between(&mut self, extremes: [f64; 2], balance: &Expr, between: &Expr) -> Option<Expr> {
        let mechanism = self.form.mechanism;
        let areas: Option<Vec<_>> = self
            .form
            .works
            .iter()
            .map(|done| Some((area_under(mechanism, done.load?, extremes)?, done.name.clone())))
            .collect();
        let areas = areas.filter(|_| self.form.balance().is_some())?;
        self.sheet.note(text!("working-energy-between"));
        let sum = areas.iter().fold(Expr::zero(), |sum, (area, name)| sum + self.area(area, name));
        Some(sum + balance * between)
    }
}
