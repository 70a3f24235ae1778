//! Outside of the crate, whose own tests would register it a second time beside all plugins.

use assur_all as _;

#[test]
fn it_conforms() {
    assur_testkit::analyzer_conformance("newton-euler");
}
