mod completeness;
mod conformance;
