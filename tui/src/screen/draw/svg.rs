//! The mechanism in one position as SVG, in millimeters of the mechanism.

use std::fmt::Write;

use super::figure::{Shape, figure};
use crate::screen::state::Scene;

/// Free space around the drawing, as part of its size.
const MARGIN: f64 = 0.08;

/// The drawing of one position.
pub(crate) fn drawing(scene: &Scene, position: usize) -> String {
    let [width, height] = scene.bounds.size();
    let size = width.max(height).max(1e-9);
    let margin = MARGIN * size;
    // y points down in SVG.
    let corner = [scene.bounds.low[0] - margin, -scene.bounds.high[1] - margin];
    let [x, y, w, h] = [corner[0], corner[1], width + 2.0 * margin, height + 2.0 * margin].map(|v| 1e3 * v);
    let mut svg = Svg { text: String::new(), size };
    svg.add(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{x} {y} {w} {h}\" font-size=\"{}\" \
         font-family=\"sans-serif\" stroke-linecap=\"round\">",
        1e3 * (0.03 * size)
    ));
    svg.add(format_args!("<title>{}</title>", escape(&scene.linkage.mechanism.title)));
    scene.paths.iter().filter(|path| !path.is_empty()).for_each(|path| svg.path(path));
    if let Some(Some(pose)) = scene.poses.get(position) {
        for part in figure(&scene.linkage, &pose.bodies, &scene.strokes) {
            svg.shape(part.shape);
        }
        for (id, point) in scene.linkage.mechanism.points.iter().enumerate() {
            svg.name(scene.linkage.point_motion(id, pose).pf0, &point.name);
        }
    }
    svg.add(format_args!("</svg>"));
    svg.text
}

/// A drawing in progress; lengths are in meters, widths of lines in parts of the size.
struct Svg {
    text: String,
    /// The greater of width and height of the mechanism, m.
    size: f64,
}

impl Svg {
    fn add(&mut self, element: std::fmt::Arguments<'_>) {
        let _ = writeln!(self.text, "{element}");
    }

    fn path(&mut self, path: &[[f64; 2]]) {
        let points = path.iter().filter(|at| at[0].is_finite());
        let points: Vec<_> = points.map(|at| format!("{:.4},{:.4}", 1e3 * at[0], -1e3 * at[1])).collect();
        self.add(format_args!(
            "<polyline points=\"{}\" fill=\"none\" stroke=\"#888\" stroke-width=\"{:.4}\" stroke-dasharray=\"{:.4}\"/>",
            points.join(" "),
            1.5 * self.size,
            6.0 * self.size
        ));
    }

    fn name(&mut self, at: [f64; 2], name: &str) {
        let [x, y] = at.map(|v| 1e3 * (v + 0.015 * self.size));
        self.add(format_args!("<text x=\"{x:.4}\" y=\"{:.4}\">{}</text>", -y, escape(name)));
    }

    fn shape(&mut self, shape: Shape) {
        match shape {
            Shape::Bar(a, b) => self.line(a, b, 0.006),
            Shape::GroundGuide(a, b) => {
                self.line(a, b, 0.003);
                self.hatch(a, b);
            }
            Shape::Block(center, along) => self.block(center, along),
            Shape::Pin(at) => self.circle(at),
            Shape::GroundPin(at) => {
                let (low, half) = (at[1] - 0.04 * self.size, 0.03 * self.size);
                let (left, right) = ([at[0] - half, low], [at[0] + half, low]);
                for (a, b) in [(at, left), (at, right), (left, right)] {
                    self.line(a, b, 0.003);
                }
                self.hatch(left, right);
                self.circle(at);
            }
        }
    }

    fn line(&mut self, a: [f64; 2], b: [f64; 2], width: f64) {
        self.add(format_args!(
            "<line x1=\"{:.4}\" y1=\"{:.4}\" x2=\"{:.4}\" y2=\"{:.4}\" stroke=\"#000\" stroke-width=\"{:.4}\"/>",
            1e3 * a[0],
            -1e3 * a[1],
            1e3 * b[0],
            -1e3 * b[1],
            1e3 * width * self.size
        ));
    }

    fn circle(&mut self, at: [f64; 2]) {
        let (x, y, size) = (1e3 * at[0], -1e3 * at[1], self.size);
        self.add(format_args!(
            "<circle cx=\"{x:.4}\" cy=\"{y:.4}\" r=\"{:.4}\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"{:.4}\"/>",
            10.0 * size,
            3.0 * size
        ));
    }

    fn block(&mut self, center: [f64; 2], along: [f64; 2]) {
        let angle = -along[1].atan2(along[0]).to_degrees();
        let (w, h, size) = (60.0 * self.size, 34.0 * self.size, self.size);
        self.add(format_args!(
            "<rect x=\"{:.4}\" y=\"{:.4}\" width=\"{w:.4}\" height=\"{h:.4}\" fill=\"#fff\" stroke=\"#000\" \
             stroke-width=\"{:.4}\" transform=\"translate({:.4} {:.4}) rotate({angle:.4})\"/>",
            -0.5 * w,
            -0.5 * h,
            4.0 * size,
            1e3 * center[0],
            -1e3 * center[1]
        ));
    }

    /// Short strokes on the right side of a line.
    fn hatch(&mut self, a: [f64; 2], b: [f64; 2]) {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let (length, step) = (dx.hypot(dy), 0.02 * self.size);
        if !(length.is_finite() && length > 0.0) {
            return;
        }
        let (ux, uy) = (dx / length, dy / length);
        let mut d = 0.0;
        while d <= length {
            let from = [a[0] + d * ux, a[1] + d * uy];
            self.line(from, [from[0] + step * (uy - ux), from[1] - step * (ux + uy)], 0.002);
            d += step;
        }
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
