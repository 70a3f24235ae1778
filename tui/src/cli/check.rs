//! `assur check`.

use super::args::SceneArgs;
use super::fault::{Fault, Status};
use super::scene;
use super::style::Style;

pub(crate) fn run(args: &SceneArgs, style: Style) -> Result<Status, Fault> {
    let _study = scene::study(args, style)?;
    Err(Fault::other("the checks are not available yet"))
}
