//! Dry friction by known cases and by the whole mechanism.

#[cfg(test)]
mod cases;
#[cfg(test)]
mod followed;
#[cfg(test)]
mod guides;
#[cfg(test)]
mod published;
#[cfg(test)]
mod random;
