//! Tests of the chart.

mod auto;
mod forms;
mod judged;
mod orders;
mod page;
mod race;
mod scenes;
