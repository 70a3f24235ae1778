//! The mechanism in one position as SVG, in millimeters of the mechanism.

use std::fmt::Write;

use super::draw::figure::{Shape, figure};
use super::study::Study;

/// Free space around, in parts of the drawn size.
const MARGIN: f64 = 0.08;

/// The drawing of one position.
pub(crate) fn drawing(study: &Study, position: usize) -> String {
    let [width, height] = study.bounds.size();
    let size = width.max(height).max(1e-9);
    let margin = MARGIN * size;
    // y points down in SVG.
    let (x, y) = (study.bounds.low[0] - margin, -study.bounds.high[1] - margin);
    let (w, h) = (width + 2.0 * margin, height + 2.0 * margin);
    let mm = |v: f64| 1e3 * v;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\" font-size=\"{}\" \
         font-family=\"sans-serif\" stroke-linecap=\"round\">\n",
        mm(x),
        mm(y),
        mm(w),
        mm(h),
        mm(0.03 * size)
    );
    let _ = writeln!(svg, "<title>{}</title>", escape(&study.linkage.mechanism.title));
    paths(study, size, &mut svg);
    if let Some(Some(pose)) = study.poses.get(position) {
        for part in figure(&study.linkage, &pose.bodies, &study.strokes) {
            shape(part.shape, size, &mut svg);
        }
        names(study, position, size, &mut svg);
    }
    svg.push_str("</svg>\n");
    svg
}

fn paths(study: &Study, size: f64, svg: &mut String) {
    for path in study.paths.iter().filter(|path| !path.is_empty()) {
        let points: Vec<String> = path
            .iter()
            .filter(|at| at[0].is_finite())
            .map(|at| format!("{:.4},{:.4}", 1e3 * at[0], -1e3 * at[1]))
            .collect();
        let width = 1.5 * size;
        let _ = writeln!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"#888\" stroke-width=\"{width:.4}\" stroke-dasharray=\"{:.4}\"/>",
            points.join(" "),
            6.0 * size
        );
    }
}

fn shape(shape: Shape, size: f64, svg: &mut String) {
    let line = |svg: &mut String, a: [f64; 2], b: [f64; 2], width: f64| {
        let _ = writeln!(
            svg,
            "<line x1=\"{:.4}\" y1=\"{:.4}\" x2=\"{:.4}\" y2=\"{:.4}\" stroke=\"#000\" stroke-width=\"{:.4}\"/>",
            1e3 * a[0],
            -1e3 * a[1],
            1e3 * b[0],
            -1e3 * b[1],
            1e3 * width * size
        );
    };
    match shape {
        Shape::Bar(a, b) => line(svg, a, b, 0.006),
        Shape::GroundGuide(a, b) => {
            line(svg, a, b, 0.003);
            hatch(a, b, size, &mut |a, b| line(svg, a, b, 0.002));
        }
        Shape::Block(center, along) => block(center, along, size, svg),
        Shape::Pin(at) => circle(at, size, svg),
        Shape::GroundPin(at) => {
            let base = [at[1] - 0.04 * size, 0.03 * size];
            let (left, right) = ([at[0] - base[1], base[0]], [at[0] + base[1], base[0]]);
            line(svg, at, left, 0.003);
            line(svg, at, right, 0.003);
            line(svg, left, right, 0.003);
            hatch(left, right, size, &mut |a, b| line(svg, a, b, 0.002));
            circle(at, size, svg);
        }
    }
}

fn circle(at: [f64; 2], size: f64, svg: &mut String) {
    let _ = writeln!(
        svg,
        "<circle cx=\"{:.4}\" cy=\"{:.4}\" r=\"{:.4}\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"{:.4}\"/>",
        1e3 * at[0],
        -1e3 * at[1],
        10.0 * size,
        3.0 * size
    );
}

fn block(center: [f64; 2], along: [f64; 2], size: f64, svg: &mut String) {
    let angle = -along[1].atan2(along[0]).to_degrees();
    let (w, h) = (60.0 * size, 34.0 * size);
    let _ = writeln!(
        svg,
        "<rect x=\"{:.4}\" y=\"{:.4}\" width=\"{w:.4}\" height=\"{h:.4}\" fill=\"#fff\" stroke=\"#000\" \
         stroke-width=\"{:.4}\" transform=\"translate({:.4} {:.4}) rotate({angle:.4})\"/>",
        -0.5 * w,
        -0.5 * h,
        4.0 * size,
        1e3 * center[0],
        -1e3 * center[1]
    );
}

/// Short strokes on the right side of a line.
fn hatch(a: [f64; 2], b: [f64; 2], size: f64, line: &mut dyn FnMut([f64; 2], [f64; 2])) {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let length = dx.hypot(dy);
    let step = 0.02 * size;
    if !(length.is_finite() && length > 0.0) {
        return;
    }
    let (ux, uy) = (dx / length, dy / length);
    let mut d = 0.0;
    while d <= length {
        let from = [a[0] + d * ux, a[1] + d * uy];
        line(from, [from[0] + step * (uy - ux), from[1] - step * (ux + uy)]);
        d += step;
    }
}

fn names(study: &Study, position: usize, size: f64, svg: &mut String) {
    let Some(Some(pose)) = study.poses.get(position) else { return };
    for (id, point) in study.linkage.mechanism.points.iter().enumerate() {
        let at = study.linkage.point_motion(id, pose).pf0;
        let _ = writeln!(
            svg,
            "<text x=\"{:.4}\" y=\"{:.4}\">{}</text>",
            1e3 * (at[0] + 0.015 * size),
            -1e3 * (at[1] + 0.015 * size),
            escape(&point.name)
        );
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
