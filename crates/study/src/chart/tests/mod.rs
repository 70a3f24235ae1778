//! Tests of the chart.

mod scenes;
