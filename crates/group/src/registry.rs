//! The registry of the kinds of groups.

use assur_number::{Dd, F64x4};
use assur_plugin::{Registered, RegistryError};

use crate::{AssurGroup, GroupFrame, Number};

/// Lengths that make no group of a kind.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what}")]
pub struct BuildError {
    /// What is wrong, with the numbers.
    pub what: String,
}

impl BuildError {
    /// A fault in words.
    pub fn new(what: impl Into<String>) -> Self {
        Self { what: what.into() }
    }
}

type Build<T> = fn(&GroupFrame) -> Result<Box<dyn AssurGroup<T>>, BuildError>;

/// One builder for each number type; made by [`Builders::of`].
#[derive(Debug, Clone, Copy)]
pub struct Builders {
    pub(crate) double: Build<f64>,
    pub(crate) single: Build<f32>,
    pub(crate) extended: Build<Dd>,
    pub(crate) lanes: Build<F64x4>,
}

/// A kind of group, whose formulas are written once for all numbers.
pub trait GroupKind {
    /// The kernel in one number type.
    type Kernel<T: Number>: AssurGroup<T> + 'static;

    /// Compiles the group at one place of a mechanism.
    ///
    /// # Errors
    ///
    /// [`BuildError`] where the lengths make no group of this kind.
    fn build<T: Number>(frame: &GroupFrame) -> Result<Self::Kernel<T>, BuildError>;
}

fn boxed<K: GroupKind, T: Number>(frame: &GroupFrame) -> Result<Box<dyn AssurGroup<T>>, BuildError> {
    Ok(Box::new(K::build::<T>(frame)?))
}

impl Builders {
    /// The builders of a kind.
    pub const fn of<K: GroupKind>() -> Self {
        Self {
            double: boxed::<K, f64>,
            single: boxed::<K, f32>,
            extended: boxed::<K, Dd>,
            lanes: boxed::<K, F64x4>,
        }
    }
}

/// Entry of a kind of group in the registry: `inventory::submit! { GroupPlugin { ... } }`.
#[derive(Debug, Clone, Copy)]
pub struct GroupPlugin {
    /// Stable identifier, lower case: `rrr`.
    pub name: &'static str,
    /// As results print it: `RRR`.
    pub kind: &'static str,
    /// Class (2 for a dyad).
    pub class: u8,
    /// Type within the class; 0 where the class has no numbered types.
    pub number: u8,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// One line.
    pub summary: &'static str,
    /// The assemblies in their order, in words.
    pub ways: &'static str,
    /// Where it is singular, in words.
    pub singular: &'static str,
    /// Where the formulas are from.
    pub source: &'static str,
    /// Whether a group of these links and pairs is of this kind.
    pub matches: fn(&GroupFrame) -> bool,
    /// Builders of the kernel.
    pub builders: Builders,
}

inventory::collect!(GroupPlugin);

impl Registered for GroupPlugin {
    const WHAT: &'static str = "group";

    fn name(&self) -> &'static str {
        self.name
    }

    fn crate_name(&self) -> &'static str {
        self.crate_name
    }
}

/// All registered kinds, sorted by name.
///
/// # Errors
///
/// [`RegistryError`] where two have one name or none is registered.
pub fn groups() -> Result<Vec<&'static GroupPlugin>, RegistryError> {
    assur_plugin::all()
}

/// The registered kind of a group; of two that match, the lower class, then the first name.
///
/// # Errors
///
/// [`RegistryError`] where the registry is faulty.
pub fn plugin_for(frame: &GroupFrame) -> Result<Option<&'static GroupPlugin>, RegistryError> {
    let all = groups()?;
    Ok(all
        .into_iter()
        .filter(|plugin| (plugin.matches)(frame))
        .min_by_key(|plugin| (plugin.class, plugin.name)))
}

/// The kernel of a group in one number type.
///
/// # Errors
///
/// [`BuildError`] where the lengths make no group of this kind.
pub fn kernel_of<T: Number>(
    plugin: &GroupPlugin,
    frame: &GroupFrame,
) -> Result<Box<dyn AssurGroup<T>>, BuildError> {
    T::build(&plugin.builders, frame)
}
