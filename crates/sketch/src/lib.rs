//! The geometry of building a mechanism.
