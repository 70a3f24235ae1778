#[test]
fn passes_the_conformance_suite() {
    assur_testkit::conformance("rrp");
}
