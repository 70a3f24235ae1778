//! Every kind passes the suite.

macro_rules! conform {
    ($($test:ident: $name:literal),* $(,)?) => {$(
        #[test]
        fn $test() {
            assur_testkit::conformance($name);
        }
    )*};
}
conform! {
    rr_rr_rr: "rr-rr-rr",
    rr_rr_pr: "rr-rr-pr",
    rr_rr_rp: "rr-rr-rp",
    rr_rr_pp: "rr-rr-pp",
    rr_pr_pr: "rr-pr-pr",
    rr_pr_rp: "rr-pr-rp",
    rr_pr_pp: "rr-pr-pp",
    rr_rp_rp: "rr-rp-rp",
    rr_rp_pp: "rr-rp-pp",
    pr_pr_pr: "pr-pr-pr",
    pr_pr_rp: "pr-pr-rp",
    pr_pr_pp: "pr-pr-pp",
    pr_rp_rp: "pr-rp-rp",
    pr_rp_pp: "pr-rp-pp",
    rp_rp_rp: "rp-rp-rp",
    rp_rp_pp: "rp-rp-pp",
    rr_rr_rr_iv_rr: "rr-rr-rr/iv:rr",
    rr_rr_pr_iv_rr: "rr-rr-pr/iv:rr",
    rr_rr_pp_iv_rr: "rr-rr-pp/iv:rr",
    rr_pr_pr_iv_rr: "rr-pr-pr/iv:rr",
    rr_pr_rp_iv_rr: "rr-pr-rp/iv:rr",
    rr_pr_pp_iv_rr: "rr-pr-pp/iv:rr",
    rr_rr_pr_iv_pr: "rr-rr-pr/iv:pr",
    rr_pr_pr_iv_pr: "rr-pr-pr/iv:pr",
    rr_pr_rp_iv_pr: "rr-pr-rp/iv:pr",
    rr_pr_pp_iv_pr: "rr-pr-pp/iv:pr",
    pr_pr_pr_iv_pr: "pr-pr-pr/iv:pr",
    pr_pr_rp_iv_pr: "pr-pr-rp/iv:pr",
    pr_pr_pp_iv_pr: "pr-pr-pp/iv:pr",
    pr_pr_rp_iv_rp: "pr-pr-rp/iv:rp",
    pr_rp_pp_iv_pr: "pr-rp-pp/iv:pr",
    rr_rr_pp_iv_pp: "rr-rr-pp/iv:pp",
    rr_pr_pp_iv_pp: "rr-pr-pp/iv:pp",
    pr_pr_pp_iv_pp: "pr-pr-pp/iv:pp",
    pr_rp_pp_iv_pp: "pr-rp-pp/iv:pp",
}
