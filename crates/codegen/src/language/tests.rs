//! What the printer keeps, and what it refuses.

use super::target::{Library, translate};
use super::{SubsetError, Target};

const TEXT: &str = "// Twice x.
fn stratiform_twice(x: f32) -> f32 {
    // As it says.
    return 2.0 * x;
}

struct StratiformPair {
    first: f32,
    second: u32,
}

// A pair, by cases.
fn stratiform_pair(i: u32, x: f32) -> StratiformPair {
    var sum = 0.0;
    for (var k = 3.0; k > 0.5; k -= 1.0) {
        sum += exp(-x) / k;
    }
    if (x < 1.0 && i != 2u) {
        sum = -sum;
    } else if (x > 2.0) {
        return StratiformPair(stratiform_twice(x), i % 2u);
    }
    let y = select(x, sum, sum < max(x, 0.5));
    return StratiformPair(y, u32(y) + i);
}
";

fn printed(text: &str, target: Target) -> Result<String, SubsetError> {
    let library =
        Library { head: "// Head.\n".to_owned(), name: "stratiform_x", code: text.to_owned(), glue: None };
    translate(&library, target).map(Option::unwrap_or_default)
}

fn texts() -> impl Iterator<Item = (Target, String)> {
    let targets = Target::ALL.into_iter().filter(|target| target.extension().is_some());
    targets.map(|target| (target, printed(TEXT, target).unwrap()))
}

#[test]
fn comments_survive_in_every_language() {
    for (target, text) in texts() {
        for comment in ["// Head.", "Twice x.", "// As it says.", "A pair, by cases."] {
            assert!(text.contains(comment), "{target:?} lacks {comment}:\n{text}");
        }
    }
}

#[test]
fn every_language_has_its_own_way_of_saying_it() {
    let text = |target| printed(TEXT, target).unwrap();
    assert!(text(Target::C).contains("static inline StratiformPair stratiform_pair(uint32_t i, float x) {"));
    assert!(text(Target::C).contains("float y = (sum < fmaxf(x, 0.5f) ? sum : x);"));
    assert!(text(Target::C).contains("StratiformPair result = {y, (uint32_t)y + i};"));
    assert!(text(Target::Glsl330).contains("return StratiformPair(y, uint(y) + i);"));
    assert!(text(Target::Hlsl).contains("for (float k = 3.0f; k > 0.5f; k -= 1.0f) {"));
    assert!(text(Target::Msl).contains("inline float stratiform_twice(float x) {"));
    assert!(text(Target::Rust).contains("pub fn stratiform_pair(i: u32, x: f32) -> StratiformPair {"));
    assert!(text(Target::Rust).contains("let y: f32 = if sum < x.max(0.5) { sum } else { x };"));
    assert!(text(Target::Rust).contains("} else if x > 2.0 {"));
    assert!(text(Target::Rust).contains("sum += (-x).exp() / k;"));
    assert!(text(Target::Rust).contains("StratiformPair { first: y, second: (y as u32) + i }"));
}

#[test]
fn what_is_outside_the_subset_is_refused_with_its_line() {
    let body = |line: &str| format!("fn stratiform_f(x: f32) -> f32 {{\n    {line}\n}}\n");
    for (text, message) in [
        (body("return y;"), "before it is declared"),
        (body("return stratiform_g(x);"), "before it is written"),
        (body("return tanh(x);"), "before it is written"),
        (body("let v = vec3<f32>(x);"), "before it is declared"),
        (body("while (x > 0.0) { return x; }"), "an assignment is missing"),
        (body("switch 1u { case 0u: { return x; } }"), "the default"),
        (body("switch 1u { default: { return x; } } return x;"), "last statement"),
        (body("return x[0];"), "`[` is outside the subset"),
        (body("return 1.0"), "`;` is missing"),
        ("\nvar<private> x: f32;\n".to_owned(), "outside the subset"),
    ] {
        let error = printed(&text, Target::C).unwrap_err();
        assert!(error.message.contains(message), "{error} should contain {message}:\n{text}");
        assert!((2..=3).contains(&error.line), "{error}");
    }
}
