//! Drawing into cells: text, rasters of dots, scales, charts, and the figure of a mechanism.

mod axis;
mod chart;
mod diagram;
mod figure;
mod label;
mod lines;
mod plot;
mod raster;
mod scale;
pub(crate) mod svg;
mod text;

pub(crate) use axis::LABELS;
pub(crate) use chart::{Chart, Mark, column_of, position_of};
pub(crate) use diagram::{Arrow, Diagram, Hodograph};
pub(crate) use label::Labels;
pub(crate) use lines::Lines;
pub(crate) use plot::{Pen, arrow, draw_figure, draw_ground, point_names};
pub(crate) use raster::{Raster, Stroke, short, whole};
pub(crate) use scale::{Scale, round_length};
pub(crate) use text::{cut, first_shown, folded, put, put_lines, wrapped};
