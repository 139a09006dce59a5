//! For CI systems: JUnit XML, one suite per part and one case per quantity. No time stamps: the same check gives the same
//! bytes.

use super::{headline, offence};
use crate::CliError;
use crate::check::{Part, Verdict};
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

/// The document; a failed case lists its `worst` worst offenders.
///
/// # Errors
/// [`CliError::Input`] if it cannot be written as XML.
pub fn to_junit(verdict: &Verdict, worst: usize) -> Result<String, CliError> {
    let mut report = Report::new("stratiform check");
    for (part, list) in &verdict.parts {
        let mut suite = TestSuite::new(part.to_string());
        if list.is_empty() {
            suite.add_test_case(case(*part, "anything", Some((headline(verdict), String::new()))));
        }
        for summary in verdict.summaries(*part) {
            let failures = verdict.failures();
            let own = failures.iter().filter(|(p, one)| p == part && one.label() == summary.label);
            let list: Vec<_> = own.take(worst).map(|(_, one)| offence(one)).collect();
            let message = format!("{} of {} out of bounds", summary.failed, summary.compared);
            let failed = (summary.failed > 0).then(|| (message, list.join("\n")));
            suite.add_test_case(case(*part, &summary.label, failed));
        }
        report.add_test_suite(suite);
    }
    report.to_string().map_err(|error| CliError::Input(format!("JUnit: {error}")))
}

fn case(part: Part, quantity: &str, failed: Option<(String, String)>) -> TestCase {
    let status = match failed {
        None => TestCaseStatus::success(),
        Some((message, list)) => {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
            status.set_message(message).set_type("out of bounds").set_description(list);
            status
        }
    };
    let mut case = TestCase::new(quantity, status);
    case.set_classname(format!("stratiform.check.{part}"));
    case
}
