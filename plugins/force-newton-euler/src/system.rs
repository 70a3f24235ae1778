//! The equations of equilibrium.

use std::collections::VecDeque;

use assur_group::{Body, LEAST_HEALTH, Wrench};
use assur_kinematics::ScalarMotion;
use assur_mechanism::{Balance, Driver, GROUND, InputPair, LinkId, Mechanism, PairId, PointId, SlideId};
use assur_number::{elementary, elimination::SparseLu};

use crate::least_norm::{LeastNorm, SparseRow, of_least_norm};

/// An unknown; each has two columns, the balancing loads the last ones.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Unknown {
    /// Force of a pin on its link of this index (not the first one, which takes the opposite of the sum of all others).
    Member(PointId, usize),
    /// Force across the guide and moment of a slide on the sliding link.
    Slide(SlideId),
}

/// Room for the entries of an equation before it is solved: a link of three pins has six, the input one more.
const ENTRIES: usize = 7;

/// An arm from the origin of a link, a force there, and a moment.
type Load = ([f64; 2], [f64; 2], f64);

/// The numbering of equations and unknowns.
#[derive(Debug)]
pub(crate) struct System<'a> {
    mechanism: &'a Mechanism,
    unknowns: Vec<Unknown>,
    /// Index of the first unknown of each pin.
    of_pins: Vec<usize>,
    /// Index of the unknown of each slide.
    of_slides: Vec<usize>,
    /// Moments are divided by this length, so that all equations are forces, m.
    scale: f64,
}

/// The solution for pins and slides.
#[derive(Debug, Clone)]
pub(crate) struct Solution {
    columns: Vec<f64>,
    pub(crate) slides: Vec<Wrench<f64>>,
    pub(crate) balancing: f64,
    /// 1 for each reaction that the equations leave open, see [`Reactions::open`](assur_force::Reactions::open); empty where they
    /// determine all.
    pub(crate) open: Vec<f64>,
    /// Ratio of least to greatest pivot.
    pub(crate) health: f64,
}

impl<'a> System<'a> {
    pub(crate) fn of(mechanism: &'a Mechanism, scale: f64) -> Self {
        let mut unknowns = Vec::new();
        let (mut of_pins, mut of_slides) = (vec![0; mechanism.points.len()], vec![0; mechanism.slides.len()]);
        for pair in from_the_ends(mechanism) {
            match pair {
                PairId::Pin(id) => {
                    of_pins[id] = unknowns.len();
                    let members = 1..mechanism.points[id].places.len();
                    unknowns.extend(members.map(|member| Unknown::Member(id, member)));
                }
                PairId::Slide(id) => {
                    of_slides[id] = unknowns.len();
                    unknowns.push(Unknown::Slide(id));
                }
            }
        }
        Self { mechanism, unknowns, of_pins, of_slides, scale }
    }

    /// Number of balancing loads: of `[balance]`, or of each drive.
    fn balances(&self) -> usize {
        if self.mechanism.balance.is_some() { 1 } else { self.mechanism.input.drivers.len() }
    }

    /// Number of equations and of unknowns.
    pub(crate) fn size(&self) -> (usize, usize) {
        (3 * (self.mechanism.links.len() - 1), 2 * self.unknowns.len() + self.balances())
    }

    /// Solves for all reactions and the balancing load; `shifts`: for each slide, the moment on the sliding link that its friction
    /// adds by unit of normal force (none where the list is empty).
    ///
    /// # Errors
    ///
    /// The ratio of least to greatest pivot of a system that can't be solved.
    pub(crate) fn solve(
        &self,
        bodies: &[Body<f64>],
        loads: &[Wrench<f64>],
        shifts: &[f64],
    ) -> Result<Solution, f64> {
        let (rows, columns) = self.size();
        let links = &loads[1..self.mechanism.links.len()];
        let rights: Vec<f64> =
            links.iter().flat_map(|load| [-load.fx, -load.fy, -load.m / self.scale]).collect();
        if rows < columns {
            let found = of_least_norm(&self.equations(bodies, shifts), &rights, columns);
            if found.health.is_nan() || found.health < LEAST_HEALTH {
                return Err(found.health);
            }
            let open = self.open(&found);
            return Ok(Solution { open, health: found.health, ..self.read(found.solution, bodies) });
        }
        if rows != columns {
            return Err(0.0);
        }
        let lu = SparseLu::new(self.equations(bodies, shifts));
        let health = lu.factored.health;
        if health.is_nan() || health < LEAST_HEALTH {
            return Err(health);
        }
        Ok(Solution { health, ..self.read(lu.solve(&rights), bodies) })
    }

    /// Which reactions the equations leave open, in the order of the joints: of each pin by link, of each slide by link and then of
    /// its moment.
    fn open(&self, found: &LeastNorm) -> Vec<f64> {
        let mark = |columns: &[Vec<usize>]| {
            let open = columns.iter().any(|columns| found.is_open(columns));
            if open { 1.0 } else { 0.0 }
        };
        let mut all = Vec::new();
        for (id, point) in self.mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin()) {
            let first = self.of_pins[id];
            let others = first..first + point.places.len() - 1;
            // The first link takes the opposite of the sum of all others.
            all.push(mark(&[0, 1].map(|axis| others.clone().map(|unknown| 2 * unknown + axis).collect())));
            all.extend(others.map(|unknown| mark(&[vec![2 * unknown], vec![2 * unknown + 1]])));
        }
        for unknown in &self.of_slides {
            let force = mark(&[vec![2 * unknown]]);
            all.extend([force, force, mark(&[vec![2 * unknown + 1]])]);
        }
        all
    }

    /// The left sides of the equations of all moving links, three of each.
    fn equations(&self, bodies: &[Body<f64>], shifts: &[f64]) -> Vec<SparseRow> {
        let (rows, _) = self.size();
        let mut equations: Vec<SparseRow> = (0..rows).map(|_| SparseRow::with_capacity(ENTRIES)).collect();
        for (k, unknown) in self.unknowns.iter().enumerate() {
            self.fill(&mut equations, [2 * k, 2 * k + 1], *unknown, bodies, shifts);
        }
        for (index, driver) in self.mechanism.input.drivers.iter().take(self.balances()).enumerate() {
            self.fill_balance(&mut equations, 2 * self.unknowns.len() + index, driver, bodies);
        }
        equations
    }

    /// The effect of an unknown on every moving link.
    fn fill(
        &self,
        rows: &mut [SparseRow],
        columns: [usize; 2],
        unknown: Unknown,
        bodies: &[Body<f64>],
        shifts: &[f64],
    ) {
        let units = [[1.0, 0.0], [0.0, 1.0]];
        match unknown {
            Unknown::Member(pin, member) => {
                let places = &self.mechanism.points[pin].places;
                for (sign, place) in [(1.0, places[member]), (-1.0, places[0])] {
                    let arm = bodies[place.link].arm(place.at);
                    for (column, unit) in columns.into_iter().zip(units) {
                        self.add(rows, column, place.link, (arm, unit.map(|u| sign * u), 0.0));
                    }
                }
            }
            Unknown::Slide(id) => {
                let slide = &self.mechanism.slides[id];
                let (link, on) = (&bodies[slide.link], &bodies[slide.on]);
                let normal = self.normal(id, bodies);
                let arm = link.arm(slide.point);
                let arm_on = [link.x + arm[0] - on.x, link.y + arm[1] - on.y];
                let shift = shifts.get(id).copied().unwrap_or(0.0);
                self.add(rows, columns[0], slide.link, (arm, normal, shift));
                self.add(rows, columns[0], slide.on, (arm_on, normal.map(|n| -n), -shift));
                // The unknown moment is M / scale, in N.
                self.add(rows, columns[1], slide.link, (arm, [0.0, 0.0], self.scale));
                self.add(rows, columns[1], slide.on, (arm_on, [0.0, 0.0], -self.scale));
            }
        }
    }

    /// Adds what an unknown of size 1 exerts on a link to its equations: an arm, a force there, and a moment.
    fn add(&self, rows: &mut [SparseRow], column: usize, link: LinkId, (arm, force, moment): Load) {
        if link == GROUND {
            return;
        }
        let about = (arm[0] * force[1] - arm[1] * force[0] + moment) / self.scale;
        for (row, value) in rows[3 * (link - 1)..].iter_mut().zip([force[0], force[1], about]) {
            match row.last_mut().filter(|(known, _)| *known == column) {
                Some((_, sum)) => *sum += value,
                None if value == 0.0 => {}
                None => row.push((column, value)),
            }
        }
    }

    /// The balancing load: a moment in units of 1/scale, a force as it is.
    fn fill_balance(&self, rows: &mut [SparseRow], column: usize, driver: &Driver, bodies: &[Body<f64>]) {
        match (self.mechanism.balance, driver.pair) {
            (Some(Balance::Force { at, angle }), _) => {
                let arm = bodies[at.link].arm(at.at);
                self.add(rows, column, at.link, (arm, [elementary::cos(angle), elementary::sin(angle)], 0.0));
            }
            (Some(Balance::Moment(link)), _) => {
                self.add(rows, column, link, ([0.0; 2], [0.0; 2], self.scale));
            }
            (None, InputPair::Pin(_)) => {
                self.add(rows, column, driver.link, ([0.0; 2], [0.0; 2], self.scale));
                self.add(rows, column, driver.on, ([0.0; 2], [0.0; 2], -self.scale));
            }
            (None, InputPair::Slide(id)) => {
                let normal = self.normal(id, bodies);
                let slide = &self.mechanism.slides[id];
                let along = [normal[1], -normal[0]];
                // The coordinate is the displacement of the sliding link, of which the other one takes the opposite force.
                let (link, own) = (&bodies[slide.link], bodies[slide.link].arm(slide.point));
                for (sign, body) in [(1.0, slide.link), (-1.0, slide.on)] {
                    let arm = [link.x + own[0] - bodies[body].x, link.y + own[1] - bodies[body].y];
                    self.add(rows, column, body, (arm, along.map(|a| sign * a), 0.0));
                }
            }
        }
    }

    /// Unit vector to the left of the guide of a slide.
    fn normal(&self, slide: SlideId, bodies: &[Body<f64>]) -> [f64; 2] {
        let slide = &self.mechanism.slides[slide];
        bodies[slide.on].arm([-elementary::sin(slide.angle), elementary::cos(slide.angle)])
    }

    /// The speed at which the coordinate of a drive changes.
    fn rate(&self, driver: &Driver, bodies: &[Body<f64>]) -> f64 {
        match driver.pair {
            InputPair::Pin(_) => bodies[driver.link].w1 - bodies[driver.on].w1,
            InputPair::Slide(id) => {
                let slide = &self.mechanism.slides[id];
                ScalarMotion::of_slide(slide, bodies).pf1
            }
        }
    }

    fn read(&self, columns: Vec<f64>, bodies: &[Body<f64>]) -> Solution {
        let slides = self.of_slides.iter().enumerate().map(|(id, unknown)| {
            let at = 2 * unknown;
            let (force, moment) = (columns[at], columns[at + 1] * self.scale);
            let [nx, ny] = self.normal(id, bodies);
            Wrench { fx: force * nx, fy: force * ny, m: moment }
        });
        let slides = slides.collect();
        let drivers = &self.mechanism.input.drivers;
        let loads = &columns[2 * self.unknowns.len()..];
        let balancing = if self.mechanism.input.sole().is_some() || self.mechanism.balance.is_some() {
            let last = loads.first().copied().unwrap_or(f64::NAN);
            if self.mechanism.balances_by_moment() { last * self.scale } else { last }
        } else {
            let unit = |driver: &Driver| if driver.is_angle() { self.scale } else { 1.0 };
            let power = |(driver, load): (&Driver, &f64)| load * unit(driver) * self.rate(driver, bodies);
            drivers.iter().zip(loads).map(power).sum()
        };
        Solution { columns, slides, balancing, open: Vec::new(), health: 1.0 }
    }

    /// Force of a pin on one of its links, N.
    pub(crate) fn force_on(&self, solution: &Solution, pin: PointId, link: LinkId) -> [f64; 2] {
        let places = &self.mechanism.points[pin].places;
        let mut sum = [0.0; 2];
        for (place, unknown) in places.iter().skip(1).zip(self.of_pins[pin]..) {
            let force = [solution.columns[2 * unknown], solution.columns[2 * unknown + 1]];
            if place.link == link {
                return force;
            }
            sum = [sum[0] - force[0], sum[1] - force[1]];
        }
        sum
    }
}

impl Solution {
    /// This solution and a multiple of another.
    pub(crate) fn plus(mut self, factor: f64, other: &Self) -> Self {
        self.columns.iter_mut().zip(&other.columns).for_each(|(own, other)| *own += factor * other);
        for (own, other) in self.slides.iter_mut().zip(&other.slides) {
            own.fx += factor * other.fx;
            own.fy += factor * other.fy;
            own.m += factor * other.m;
        }
        self.balancing += factor * other.balancing;
        self
    }
}

/// All pins and slides, those farthest from the input link first. What is eliminated in this order fills in little: a
/// pair only meets pairs of the links that it joins, as when a mechanism is solved group by group from its ends.
fn from_the_ends(mechanism: &Mechanism) -> Vec<PairId> {
    let pins = mechanism.points.iter().enumerate().map(|(id, pin)| {
        let links: Vec<LinkId> = pin.places.iter().map(|place| place.link).collect();
        (PairId::Pin(id), links)
    });
    let slides = mechanism
        .slides
        .iter()
        .enumerate()
        .map(|(id, slide)| (PairId::Slide(id), vec![slide.link, slide.on]));
    let pairs: Vec<(PairId, Vec<LinkId>)> = pins.chain(slides).collect();
    let mut of_link = vec![Vec::new(); mechanism.links.len()];
    for (k, (_, links)) in pairs.iter().enumerate() {
        for &link in links {
            of_link[link].push(k);
        }
    }
    // Breadth first from the input link, not through the ground. Pairs that are not reached come first.
    let mut is_met = vec![false; mechanism.links.len()];
    is_met[GROUND] = true;
    let inputs: VecDeque<LinkId> = mechanism.input.drivers.iter().map(|driver| driver.link).collect();
    for input in &inputs {
        is_met[*input] = true;
    }
    let mut is_taken = vec![false; pairs.len()];
    let (mut found, mut queue) = (Vec::with_capacity(pairs.len()), inputs);
    while let Some(link) = queue.pop_front() {
        for &k in &of_link[link] {
            if std::mem::replace(&mut is_taken[k], true) {
                continue;
            }
            found.push(pairs[k].0);
            queue.extend(pairs[k].1.iter().filter(|&&other| !std::mem::replace(&mut is_met[other], true)));
        }
    }
    found.extend(pairs.iter().zip(is_taken).filter(|(_, taken)| !taken).map(|((pair, _), _)| *pair));
    found.reverse();
    found
}
