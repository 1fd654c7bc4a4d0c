//! A valid project resolves to what it says.

mod support;

#[test]
fn the_valid_project_has_no_findings() {
    let mut project = support::project(support::base()).unwrap_or_else(|error| panic!("{error:#?}"));
    let findings = project.check_all();
    let text = terrane_codegen::diagnostic::render(&findings, &project.sources, false);
    assert!(findings.is_empty(), "{text}");
}
