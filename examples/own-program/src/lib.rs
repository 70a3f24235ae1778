//! A kind of group of class III in a program of one's own: a link with three joints, held by three links.
//!
//! The page of the documentation that leads here stands below, so that its code is compiled with the tests.
#![doc = include_str!("../../../docs/plugins.md")]

mod triad;

// The words of its plugin: lang/en.ftl, lang/uk.ftl, lang/ru.ftl.
assur_words::resources!();
