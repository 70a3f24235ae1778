//! A link that is driven against one that is placed before it: the initial mechanism of class I, whose ground moves.
//!
//! The coordinate of its drive holds it in that link, so that both are one; nothing is left to be placed.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use assur_group::{
    Assemblies, AssurGroup, Body, BuildError, Builders, ForceAngle, GroupError, GroupFrame, GroupKind,
    GroupPlugin, Number, Pattern, inventory,
};
use assur_number::Real;
use assur_words::text;

#[cfg(test)]
mod tests;

assur_words::resources!();

inventory::submit! {
    GroupPlugin {
        name: "driven-link",
        kind: "driven-link",
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("group-driven"),
        pattern: Some(Pattern { links: 0, inner: &[], outer: &[] }),
        rank: 10,
        ways: Assemblies { most: 1, varies: false, words: text!("group-driven.ways") },
        iterates: false,
        singular: text!("group-driven.singular"),
        force_angle: ForceAngle::DEFAULT,
        source: text!("group-driven.source"),
        builders: Builders::of::<Held>(),
    }
}

/// The group without the links that its drives hold: nothing.
#[derive(Debug, Clone)]
struct Held(GroupFrame);

impl<T: Real> AssurGroup<T> for Held {
    fn frame(&self) -> &GroupFrame {
        &self.0
    }

    fn place(&self, _: &mut [Body<T>], _: usize) -> Result<T, GroupError> {
        Ok(T::ONE)
    }

    fn health(&self, _: &[Body<T>]) -> f64 {
        1.0
    }

    fn resolution(&self, _: &[Body<T>]) -> f64 {
        T::EPSILON
    }
}

impl GroupKind for Held {
    type Kernel<T: Number> = Self;

    fn build<T: Number>(frame: &GroupFrame) -> Result<Self, BuildError> {
        Ok(Self(frame.clone()))
    }
}
