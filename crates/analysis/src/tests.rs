//! The plan is obeyed.
