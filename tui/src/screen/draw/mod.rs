//! Drawing with dots into cells: rasters, scales, and the figure of a mechanism.

pub(crate) mod chart;
pub(crate) mod diagram;
pub(crate) mod figure;
pub(crate) mod hodograph;
pub(crate) mod label;
pub(crate) mod lines;
pub(crate) mod plot;
pub(crate) mod raster;
pub(crate) mod scale;
