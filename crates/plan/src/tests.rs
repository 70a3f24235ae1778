//! Which groups and stages a scene needs.
