//! The four forms of a small verdict, in full: what CI systems and people parse must not change unseen.

use super::*;
use crate::check::{Part, Place};
use stratiform_artifact::{Provenance, RowIncidence};
use stratiform_quantities::{Medium, Order};

fn comparison(quantity: &str, theta: f64, value: f64) -> Comparison {
    let place = Place {
        tau: Some(0.5),
        medium: Some(Medium::Full),
        order: Some(Order::Exactly(1)),
        ..Place::of(RowIncidence::Degrees(theta))
    };
    Comparison { quantity: quantity.to_owned(), place, value, truth: 0.25, bound: 0.125 }
}

/// A quantity with a name that XML must escape; one comparison of it fails, by twice the bound.
fn verdict() -> Verdict {
    let list =
        vec![comparison("a<b", 0.0, 0.25), comparison("a<b", 60.0, 0.5), comparison("c", 80.0, 0.3125)];
    Verdict { parts: [(Part::Values, list)].into() }
}

#[test]
fn text_is_a_table_and_the_offenders() {
    let expected = "\
values
  quantity     compared  failed  off/bound   value  truth  off by  bound  worst at
  a<b order 1         2       1       2.00     0.5   0.25    0.25  0.125  theta_l 60, tau 0.5, medium full
  c order 1           1       0       0.50  0.3125   0.25  0.0625  0.125  theta_l 80, tau 0.5, medium full

worst offenders (1 of 1)
  values: a<b order 1 at theta_l 60, tau 0.5, medium full: 0.5, truth 0.25, off by 0.25, bound 0.125

1 of 3 comparisons are out of bounds
";
    assert_eq!(to_text(&verdict(), 10), expected);
    assert!(to_text(&verdict(), 0).contains("worst offenders (0 of 1)\n\n1 of 3"));
}

#[test]
fn markdown_is_a_heading_and_the_same_table() {
    let page = to_markdown(&verdict(), "a cloud", 10);
    let expected = "\
## stratiform check FAILED

a cloud: 1 of 3 comparisons are out of bounds

### values

| quantity | compared | failed | off/bound | value | truth | off by | bound | worst at |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |
| a<b order 1 | 2 | 1 | 2.00 | 0.5 | 0.25 | 0.25 | 0.125 | theta_l 60, tau 0.5, medium full |
";
    assert!(page.starts_with(expected), "{page}");
    assert!(page.ends_with("\n- values: a<b order 1 at theta_l 60, tau 0.5, medium full: 0.5, truth 0.25, off by 0.25, bound 0.125\n"));
}

#[test]
fn junit_has_one_case_per_quantity_and_is_xml() {
    let xml = to_junit(&verdict(), 10).unwrap();
    let tree = roxmltree::Document::parse(&xml).unwrap();
    let root = tree.root_element();
    let numbers = ["name", "tests", "failures", "errors"].map(|name| root.attribute(name).unwrap());
    assert_eq!(numbers, ["stratiform check", "2", "1", "0"]);
    let cases: Vec<_> = root.descendants().filter(|node| node.has_tag_name("testcase")).collect();
    let names: Vec<_> = cases.iter().map(|case| case.attribute("name").unwrap()).collect();
    assert_eq!(names, ["a<b order 1", "c order 1"]);
    assert_eq!(cases[0].attribute("classname"), Some("stratiform.check.values"));
    let failure = cases[0].first_element_child().unwrap();
    assert_eq!(failure.attribute("message"), Some("1 of 2 out of bounds"));
    assert!(failure.text().unwrap().contains("theta_l 60, tau 0.5"));
    assert!(cases[1].first_element_child().is_none());
}

#[test]
fn json_names_the_offenders_and_has_no_nan() {
    let provenance = Provenance::new("0".to_owned(), None, "test");
    let mut verdict = verdict();
    if let Some(list) = verdict.parts.get_mut(&Part::Values) {
        list.push(comparison("c", 10.0, f64::NAN));
    }
    let document: serde_json::Value =
        serde_json::from_str(&to_json(&verdict, &provenance, 10).unwrap()).unwrap();
    assert_eq!((&document["schema"], &document["failed"]), (&SCHEMA.into(), &2.into()));
    assert_eq!(document["offenders"][0]["value"], serde_json::Value::Null);
    let second = &document["offenders"][1];
    assert_eq!(
        (&second["quantity"], &second["order"], &second["tau"]),
        (&"a<b".into(), &1.into(), &0.5.into())
    );
    assert_eq!(second["difference"], 0.25);
    assert_eq!(document["parts"][0]["quantities"][1]["compared"], 2);
}

#[test]
fn nothing_compared_is_said_in_every_form() {
    let empty = Verdict { parts: [(Part::Tracer, Vec::new())].into() };
    assert_eq!(headline(&empty), "tracer: nothing was compared");
    assert!(to_text(&empty, 10).ends_with("tracer: nothing was compared\n"));
    assert!(to_markdown(&empty, "a cloud", 10).starts_with("## stratiform check FAILED\n"));
    assert!(to_junit(&empty, 10).unwrap().contains("<failure"));
    assert_eq!(headline(&Verdict::default()), "nothing was compared");
}

#[test]
fn numbers_are_short_and_keep_six_digits() {
    for (value, text) in [
        (0.0, "0"),
        (45.0, "45"),
        (0.046_181_412, "0.0461814"),
        (-0.5, "-0.5"),
        (1_234.567_89, "1234.57"),
        (123_456.7, "123457"),
        (1.5e-7, "1.50e-7"),
        (f64::NAN, "NaN"),
    ] {
        assert_eq!(short(value), text);
    }
}
