//! Signs on paper: outlines of a fixed size, in text sizes.

use crate::model::{Point, Sign};
use crate::trace::{block, shifted};

/// A part of a sign.
pub(crate) struct Shape {
    pub(crate) form: Form,
    /// How much of its ink fills it: 0 paper, 1 all; of lines it has no meaning.
    pub(crate) filled: f64,
}

/// What a part of a sign is; y grows downwards.
pub(crate) enum Form {
    Circle {
        at: Point,
        radius: f64,
    },
    Polygon(Vec<Point>),
    Line([Point; 2]),
    /// A finer line.
    Fine([Point; 2]),
}

impl Shape {
    fn of(form: Form, filled: f64) -> Self {
        Self { form, filled }
    }

    fn circle(at: Point, radius: f64, filled: f64) -> Self {
        Self::of(Form::Circle { at, radius }, filled)
    }
}

/// The parts of a sign at a place, in its direction; `em` is the text size.
pub(crate) fn shapes(at: Point, along: Point, sign: Sign, em: f64) -> Vec<Shape> {
    let cross = |directions: [Point; 2]| {
        let ends = directions.map(|along| [shifted(at, along, -0.3 * em), shifted(at, along, 0.3 * em)]);
        ends.map(|ends| Shape::of(Form::Line(ends), 0.0)).into()
    };
    match sign {
        Sign::Pin => vec![Shape::circle(at, 0.3 * em, 0.0)],
        Sign::Dot | Sign::Node => vec![Shape::circle(at, 0.13 * em, 1.0)],
        Sign::Ring => vec![Shape::circle(at, 0.25 * em, 0.0)],
        Sign::Star => vec![Shape::circle(at, 0.15 * em, 0.0)],
        Sign::Cross => {
            let half = std::f64::consts::FRAC_1_SQRT_2;
            cross([[half, half], [half, -half]])
        }
        Sign::Plus => cross([[1.0, 0.0], [0.0, 1.0]]),
        Sign::Block => vec![Shape::of(Form::Polygon(block(at, along, em).into()), 0.0)],
        Sign::Hatch => {
            // A stroke at half a right angle to the line.
            let slanted = [along[0] + along[1], along[1] - along[0]];
            vec![Shape::of(Form::Fine([at, shifted(at, slanted, 0.4 * em)]), 0.0)]
        }
        Sign::Head => {
            let back = shifted(at, along, -0.8 * em);
            let across = [-along[1], along[0]];
            let corners = vec![at, shifted(back, across, 0.22 * em), shifted(back, across, -0.22 * em)];
            vec![Shape::of(Form::Polygon(corners), 1.0)]
        }
        Sign::Bearing => bearing(at, em),
    }
}

fn bearing(at: Point, em: f64) -> Vec<Shape> {
    let base = at[1] + 1.1 * em;
    let corner = |side: f64| [at[0] + side * em, base];
    let hatching = (0..5).map(|stroke| {
        let x = at[0] + (-1.0 + 0.5 * f64::from(stroke)) * em;
        Shape::of(Form::Fine([[x, base], [x - 0.4 * em, base + 0.4 * em]]), 0.0)
    });
    let mut shapes = vec![Shape::of(Form::Polygon(vec![at, corner(-0.7), corner(0.7)]), 0.0)];
    shapes.push(Shape::of(Form::Line([corner(-1.2), corner(1.2)]), 0.0));
    shapes.extend(hatching);
    shapes.push(Shape::circle(at, 0.3 * em, 0.0));
    shapes
}
