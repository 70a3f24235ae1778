//! Drawing into cells: text, and figures in the styles of the theme.

mod figure;
mod text;

pub(crate) use assur_figure::cells::cut;
pub(crate) use figure::{cells, paint, paint_zoomed};
pub(crate) use text::{first_shown, folded, put, put_lines, short, table, wrapped};
