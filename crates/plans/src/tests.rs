//! Known values, closing, independent sums.
