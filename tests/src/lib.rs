//! Whole-program tests stand in `tests/`.
