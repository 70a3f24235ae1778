//! Dry friction by known cases and by the whole mechanism.

#[cfg(test)]
mod cases;
