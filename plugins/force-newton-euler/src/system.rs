//! The equations of equilibrium.

use assur_group::{Body, Wrench};
use assur_mechanism::{Balance, GROUND, InputPair, LinkId, Mechanism, PointId, SlideId};
use nalgebra::{DMatrix, DVector};

/// A matrix whose pivots differ more than this is singular: rounding alone gives some 1e-16.
const LEAST_HEALTH: f64 = 1e-15;

/// What is unknown; each takes two columns, the balancing load the last one.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Unknown {
    /// Force of a pin on its member of this index (not the first member, which takes the opposite of all others).
    Member(PointId, usize),
    /// Force across the guide and moment of a slide on the sliding link.
    Slide(SlideId),
}

/// Which equations there are, for which unknowns.
#[derive(Debug)]
pub(crate) struct System<'a> {
    mechanism: &'a Mechanism,
    unknowns: Vec<Unknown>,
    /// Moments are divided by this length, so that all equations are forces, m.
    scale: f64,
}

/// The answer in terms of pins and slides.
#[derive(Debug)]
pub(crate) struct Solution {
    columns: Vec<f64>,
    pub(crate) slides: Vec<Wrench<f64>>,
    pub(crate) balancing: f64,
}

impl<'a> System<'a> {
    pub(crate) fn of(mechanism: &'a Mechanism, scale: f64) -> Self {
        let pins = mechanism.points.iter().enumerate();
        let members =
            pins.flat_map(|(id, pin)| (1..pin.places.len()).map(move |member| Unknown::Member(id, member)));
        let slides = (0..mechanism.slides.len()).map(Unknown::Slide);
        Self { mechanism, unknowns: members.chain(slides).collect(), scale }
    }

    /// Number of equations and of unknowns.
    pub(crate) fn size(&self) -> (usize, usize) {
        (3 * (self.mechanism.links.len() - 1), 2 * self.unknowns.len() + 1)
    }

    /// Solves for all reactions and the balancing load.
    ///
    /// # Errors
    ///
    /// The health (least over greatest pivot) of a system that can't be solved.
    pub(crate) fn solve(&self, bodies: &[Body<f64>], loads: &[Wrench<f64>]) -> Result<Solution, f64> {
        let (rows, columns) = self.size();
        if rows != columns {
            return Err(0.0);
        }
        let mut matrix = DMatrix::zeros(rows, columns);
        for (index, unknown) in self.unknowns.iter().enumerate() {
            self.fill(&mut matrix, 2 * index, *unknown, bodies);
        }
        self.fill_balance(&mut matrix, columns - 1, bodies);
        let mut right = DVector::zeros(rows);
        for (link, load) in loads.iter().enumerate().skip(1) {
            let row = 3 * (link - 1);
            (right[row], right[row + 1], right[row + 2]) = (-load.fx, -load.fy, -load.m / self.scale);
        }
        let lu = matrix.lu();
        let pivots: Vec<f64> = lu.u().diagonal().iter().map(|pivot| pivot.abs()).collect();
        let (least, greatest) =
            pivots.iter().fold((f64::INFINITY, 0.0_f64), |(l, g), p| (l.min(*p), g.max(*p)));
        let health = if greatest > 0.0 { least / greatest } else { 0.0 };
        if health.is_nan() || health < LEAST_HEALTH {
            return Err(health);
        }
        let solved = lu.solve(&right).ok_or(health)?;
        Ok(self.read(solved.as_slice(), bodies))
    }

    /// The effect of an unknown on every moving link.
    fn fill(&self, matrix: &mut DMatrix<f64>, column: usize, unknown: Unknown, bodies: &[Body<f64>]) {
        let units = [[1.0, 0.0], [0.0, 1.0]];
        match unknown {
            Unknown::Member(pin, member) => {
                let places = &self.mechanism.points[pin].places;
                for (sign, place) in [(1.0, places[member]), (-1.0, places[0])] {
                    let arm = turn(&bodies[place.link], place.at);
                    for (k, unit) in units.into_iter().enumerate() {
                        self.add(matrix, column + k, place.link, arm, unit.map(|u| sign * u), 0.0);
                    }
                }
            }
            Unknown::Slide(id) => {
                let slide = &self.mechanism.slides[id];
                let (link, on) = (&bodies[slide.link], &bodies[slide.on]);
                let normal = self.normal(id, bodies);
                let arm = turn(link, slide.point);
                let arm_on = [link.x + arm[0] - on.x, link.y + arm[1] - on.y];
                self.add(matrix, column, slide.link, arm, normal, 0.0);
                self.add(matrix, column, slide.on, arm_on, normal.map(|n| -n), 0.0);
                // The unknown moment is M / scale, in N.
                self.add(matrix, column + 1, slide.link, arm, [0.0, 0.0], self.scale);
                self.add(matrix, column + 1, slide.on, arm_on, [0.0, 0.0], -self.scale);
            }
        }
    }

    /// Adds a force at an arm and a moment to the equations of a link.
    fn add(
        &self,
        matrix: &mut DMatrix<f64>,
        column: usize,
        link: LinkId,
        arm: [f64; 2],
        force: [f64; 2],
        moment: f64,
    ) {
        if link == GROUND {
            return;
        }
        let row = 3 * (link - 1);
        matrix[(row, column)] += force[0];
        matrix[(row + 1, column)] += force[1];
        matrix[(row + 2, column)] += (arm[0] * force[1] - arm[1] * force[0] + moment) / self.scale;
    }

    /// The balancing load: a moment in units of 1/scale, a force as it is.
    fn fill_balance(&self, matrix: &mut DMatrix<f64>, column: usize, bodies: &[Body<f64>]) {
        let input = &self.mechanism.input;
        match (self.mechanism.balance, input.pair) {
            (Some(Balance::Force { at, angle }), _) => {
                let arm = turn(&bodies[at.link], at.at);
                self.add(matrix, column, at.link, arm, [angle.cos(), angle.sin()], 0.0);
            }
            (Some(Balance::Moment(link)), _) => {
                self.add(matrix, column, link, [0.0; 2], [0.0; 2], self.scale);
            }
            (None, InputPair::Pin(_)) => self.add(matrix, column, input.link, [0.0; 2], [0.0; 2], self.scale),
            (None, InputPair::Slide(id)) => {
                let normal = self.normal(id, bodies);
                let slide = &self.mechanism.slides[id];
                let along = [normal[1], -normal[0]];
                // The coordinate is the displacement of the sliding link; if that is the ground, the input moves in the opposite direction.
                let (sign, body) =
                    if slide.link == input.link { (1.0, input.link) } else { (-1.0, slide.on) };
                let (link, own) = (&bodies[slide.link], turn(&bodies[slide.link], slide.point));
                let arm = [link.x + own[0] - bodies[body].x, link.y + own[1] - bodies[body].y];
                self.add(matrix, column, body, arm, along.map(|a| sign * a), 0.0);
            }
        }
    }

    /// Unit vector to the left of the guide of a slide.
    fn normal(&self, slide: SlideId, bodies: &[Body<f64>]) -> [f64; 2] {
        let slide = &self.mechanism.slides[slide];
        turn(&bodies[slide.on], [-slide.angle.sin(), slide.angle.cos()])
    }

    fn read(&self, columns: &[f64], bodies: &[Body<f64>]) -> Solution {
        let slides = (0..self.mechanism.slides.len()).map(|id| {
            let Some(index) = self.unknowns.iter().position(|unknown| *unknown == Unknown::Slide(id)) else {
                return Wrench::ZERO;
            };
            let (force, moment) = (columns[2 * index], columns[2 * index + 1] * self.scale);
            let [nx, ny] = self.normal(id, bodies);
            Wrench { fx: force * nx, fy: force * ny, m: moment }
        });
        let last = columns.last().copied().unwrap_or(f64::NAN);
        let balancing = if self.mechanism.balances_by_moment() { last * self.scale } else { last };
        Solution { slides: slides.collect(), balancing, columns: columns.to_vec() }
    }

    /// Force of a pin on one of its links, N.
    pub(crate) fn force_on(&self, solution: &Solution, pin: PointId, link: LinkId) -> [f64; 2] {
        let places = &self.mechanism.points[pin].places;
        let mut sum = [0.0; 2];
        for (index, unknown) in self.unknowns.iter().enumerate() {
            let Unknown::Member(point, member) = *unknown else { continue };
            if point != pin {
                continue;
            }
            let force = [solution.columns[2 * index], solution.columns[2 * index + 1]];
            if places[member].link == link {
                return force;
            }
            sum = [sum[0] - force[0], sum[1] - force[1]];
        }
        sum
    }
}

/// A vector of a link turned into the frame of the ground.
fn turn(body: &Body<f64>, v: [f64; 2]) -> [f64; 2] {
    [body.c * v[0] - body.s * v[1], body.s * v[0] + body.c * v[1]]
}
