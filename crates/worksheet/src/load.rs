//! Loads and reactions of a working.

use crate::{Expr, Point, Sheet, Symbol};

/// A force at a point, or a moment, on a link.
#[derive(Debug, Clone, PartialEq)]
pub struct WorkedLoad {
    /// The force, N, and its point of application.
    pub force: Option<([Expr; 2], Point)>,
    /// A moment, N m, counter-clockwise.
    pub moment: Expr,
    /// Whether it is an applied or an inertia load; otherwise it is a reaction of another group.
    pub applied: bool,
}

/// The reaction that a pair exerts on a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Reaction {
    /// Index of the pair in the chain.
    pub pair: usize,
    /// The link on which it acts.
    pub on: usize,
    /// The force, N.
    pub force: [Expr; 2],
    /// The moment about `at`, N m.
    pub moment: Expr,
    /// Point of application of the force.
    pub at: Point,
}

impl Sheet {
    /// Adds a load to a link.
    pub fn load(&mut self, body: usize, load: WorkedLoad) {
        self.loads[body].push(load);
    }

    /// The reactions that are already found.
    pub fn reactions(&self) -> &[Reaction] {
        &self.reactions
    }

    /// The loads on a link that are already known.
    pub fn loads_on(&self, body: usize) -> &[WorkedLoad] {
        &self.loads[body]
    }

    /// Writes the sum of the forces on a link: its own loads, and the reactions of groups solved before.
    pub fn resultant(&mut self, body: usize) -> [Expr; 2] {
        let mut sum = [Expr::zero(), Expr::zero()];
        for (force, _) in self.loads[body].iter().filter_map(|load| load.force.as_ref()) {
            sum = [&sum[0] + &force[0], &sum[1] + &force[1]];
        }
        let tag = self.body_name(body);
        let [x, y] = sum;
        [("X", x), ("Y", y)]
            .map(|(letter, sum)| self.work_unless_zero(Symbol::from(letter).of(&tag), &sum, "N"))
    }

    /// Writes the moment of the loads on a link about a point.
    pub fn moment_about(&mut self, body: usize, point: &Point) -> Expr {
        let mut sum = Expr::zero();
        for load in &self.loads[body] {
            if let Some((force, at)) = &load.force {
                sum = sum + at.moment_about(point, force);
            }
            sum = sum + &load.moment;
        }
        let symbol = Symbol::from("M").of(self.body_name(body)).of(&point.name);
        self.work_unless_zero(symbol, &sum, "N·m")
    }

    /// Writes the force that a pin exerts on a link of the group.
    pub fn pin_reaction(&mut self, pair: usize, on: usize, at: &Point, force: &[Expr; 2]) -> [Expr; 2] {
        let force = self.force(&self.acting(pair, on), force);
        self.record(pair, on, &force, &Expr::zero(), at);
        force
    }

    /// Writes force and moment that a slide exerts on a link of the group. The force acts at `at`, along the normal
    /// of the guide; the moment is about `at`.
    pub fn slide_reaction(
        &mut self,
        pair: usize,
        on: usize,
        at: &Point,
        force: &[Expr; 2],
        moment: &Expr,
    ) -> ([Expr; 2], Expr) {
        let of = self.acting(pair, on);
        let force = self.force(&of, force);
        let moment = self.work(Symbol::from("M").of("R").of(of), moment, "N·m");
        self.record(pair, on, &force, &moment, at);
        (force, moment)
    }

    /// Stores a reaction that is already written.
    pub fn record(&mut self, pair: usize, on: usize, force: &[Expr; 2], moment: &Expr, at: &Point) {
        let (force, moment, at) = (force.clone(), moment.clone(), at.clone());
        self.reactions.push(Reaction { pair, on, force, moment, at });
    }

    /// The subscripts of what a pair exerts on a link.
    pub fn acting(&self, pair: usize, on: usize) -> Symbol {
        Symbol::from(self.pair_name(pair)).of(self.body_name(on))
    }

    fn force(&mut self, of: &Symbol, force: &[Expr; 2]) -> [Expr; 2] {
        let symbols = ["x", "y"].map(|axis| Symbol::from("R").of(axis).of(of));
        let [x, y] = symbols;
        [self.work(x, &force[0], "N"), self.work(y, &force[1], "N")]
    }

    /// Adds the opposite of a reaction to the loads of the outer body.
    pub fn hand_on(&mut self, body: usize, at: &Point, force: &[Expr; 2], moment: &Expr) {
        if body != 0 {
            let force = Some(([-&force[0], -&force[1]], at.clone()));
            self.load(body, WorkedLoad { force, moment: -moment, applied: false });
        }
    }

    /// Writes the power of the applied loads on a link for dq = 1.
    pub fn power_of(&mut self, body: usize) -> Expr {
        let mut sum = Expr::zero();
        let rate = &self.angle(body)[1];
        for load in self.loads[body].iter().filter(|load| load.applied) {
            if let Some(([fx, fy], at)) = &load.force {
                sum = sum + fx * &at.pf[1][0] + fy * &at.pf[1][1];
            }
            sum = sum + &load.moment * rate;
        }
        let symbol = Symbol::from("P").of(self.body_name(body));
        self.work_unless_zero(symbol, &sum, self.units.moment)
    }
}

impl Point {
    /// Moment of a force that acts here, about another point.
    pub fn moment_about(&self, about: &Self, force: &[Expr; 2]) -> Expr {
        if self.name == about.name {
            return Expr::zero();
        }
        let [x, y] = self.from(about, 0);
        x * &force[1] - y * &force[0]
    }
}
