//! The shipped scenes.

use super::study::Study;

/// File name and text of each, in the order of the menu.
pub(crate) const SCENES: &[(&str, &str)] = &[
    ("shaper.toml", include_str!("../../../fixtures/shaper.toml")),
    ("shaper-drive.toml", include_str!("../../../fixtures/shaper-drive.toml")),
    ("four-bar.toml", include_str!("../../../fixtures/four-bar.toml")),
    ("slider-crank.toml", include_str!("../../../fixtures/slider-crank.toml")),
    ("press.toml", include_str!("../../../fixtures/press.toml")),
    ("conveyor.toml", include_str!("../../../fixtures/conveyor.toml")),
    ("stephenson1.toml", include_str!("../../../fixtures/stephenson1.toml")),
    ("stephenson3.toml", include_str!("../../../fixtures/stephenson3.toml")),
    ("watt.toml", include_str!("../../../fixtures/watt.toml")),
    ("jansen.toml", include_str!("../../../fixtures/jansen.toml")),
    ("r-rtr-rrt.toml", include_str!("../../../fixtures/r-rtr-rrt.toml")),
    ("guide-shaper.toml", include_str!("../../../fixtures/guide-shaper.toml")),
    ("andrews.toml", include_str!("../../../fixtures/andrews.toml")),
    ("flywheel.toml", include_str!("../../../fixtures/flywheel.toml")),
    ("brake.toml", include_str!("../../../fixtures/brake.toml")),
    ("run-up.toml", include_str!("../../../fixtures/run-up.toml")),
    ("n-four-bar-2.toml", include_str!("../../../fixtures/n-four-bar-2.toml")),
    ("n-four-bar-40.toml", include_str!("../../../fixtures/n-four-bar-40.toml")),
];

/// The menu of shipped scenes.
#[derive(Debug, Default)]
pub(crate) struct Menu {
    pub(crate) chosen: usize,
    previews: Vec<Option<Result<Box<Study>, String>>>,
}

impl Menu {
    /// Whether a scene has no picture yet.
    pub(crate) fn wants(&self, index: usize) -> bool {
        self.previews.get(index).is_none_or(Option::is_none)
    }

    /// Keeps a picture.
    pub(crate) fn keep(&mut self, index: usize, preview: Result<Box<Study>, String>) {
        self.previews.resize_with(self.previews.len().max(index + 1), || None);
        self.previews[index] = Some(preview);
    }

    /// The picture of the chosen scene.
    pub(crate) fn preview(&self) -> Option<&Result<Box<Study>, String>> {
        self.previews.get(self.chosen)?.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::SCENES;

    #[test]
    fn every_scene_that_is_shipped_is_in_the_menu() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../fixtures");
        let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
        let files: BTreeSet<String> = names
            .map(|name| name.into_string().unwrap())
            .filter(|name| std::path::Path::new(name).extension().is_some_and(|end| end == "toml"))
            .collect();
        let shown: BTreeSet<String> = SCENES.iter().map(|(name, _)| (*name).to_owned()).collect();
        assert_eq!(shown, files);
        assert_eq!(SCENES.len(), files.len(), "one is there twice");
    }
}
