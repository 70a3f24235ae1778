//! A kind of group of class III, order 4, in a program of one's own: two links with three joints each, held by four links.
//!
//! The page of the documentation that leads here stands below, so that its code is compiled with the tests.
#![doc = include_str!("../../../docs/plugins.md")]

mod plates;

// The words of its plugin: lang/en.ftl, lang/uk.ftl, lang/ru.ftl.
assur_words::resources!();
