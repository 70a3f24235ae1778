//! Figures: what is drawn, and the renderers that draw it.
//!
//! A [`Figure`] holds panels, a panel holds items (lines, arrows, pins, springs, names) in real units. It is drawn as
//! character cells ([`cells`]), as SVG ([`svg`]), which another crate paints, and as DXF ([`dxf`]); all show the same items. [`mechanism`] makes
//! the items of a linkage in one position.
//!
//! A plane (a mechanism, a plan, a hodograph) has one scale for both axes; on paper it is a round one, so that a length
//! on paper times the scale is the true length. Sizes of signs (pins, arrowheads, hatching) are parts of the text size,
//! whatever the scale.

mod axis;
mod bounds;
pub mod cells;
pub mod dxf;
pub mod letters;
pub mod mechanism;
mod model;
pub mod number;
mod page;
mod scale;
mod sign;
pub mod svg;
mod trace;

pub use axis::{Axis, AxisKind, extent};
pub use bounds::{Bounds, Zoom};
pub use model::{Cursor, Figure, Frame, Ink, Item, Key, Panel, Point, Sample, Sign, Stroke};
pub use page::{
    Anchor, Element, Form, Page, Style, color, elements, heading_width, plane_scale, size, text_width,
};
pub use scale::{Scale, one_scale};

assur_words::resources!();
