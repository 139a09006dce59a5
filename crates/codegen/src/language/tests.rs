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
    let (head, code) = ("// Head.\n".to_owned(), text.to_owned());
    let library = Library { head, name: "stratiform_x", code, owner: None, glue: None, needs: Vec::new() };
    Ok(translate(&library, &[target])?.into_iter().map(|(_, text)| text).collect())
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

/// An expression of x: f32 and i: u32 in every language's own words; each is compiled and run by the tests of languages.
#[test]
fn operators_bind_as_they_are_written() {
    let rust = |value: &str| {
        let text = format!("fn stratiform_f(x: f32, i: u32) -> f32 {{\n    return {value};\n}}\n");
        let text = printed(&text, Target::Rust).unwrap();
        text.lines().rev().nth(1).unwrap().trim().to_owned()
    };
    assert_eq!(rust("-f32(i)"), "-(i as f32)");
    assert_eq!(rust("min(f32(i), x)"), "(i as f32).min(x)");
    assert_eq!(rust("max(0.5, select(x, 1.0, i < 2u))"), "0.5_f32.max(if i < 2 { 1.0 } else { x })");
    assert_eq!(
        rust("max(select(x, 1.0, i < 2u), select(x, 1.0, i < 3u))"),
        "(if i < 2 { 1.0 } else { x }).max(if i < 3 { 1.0 } else { x })"
    );
    assert_eq!(rust("(x - (x - x))"), "x - (x - x)");
    assert_eq!(rust("exp((x + x))"), "(x + x).exp()");
    let c = |value: &str| {
        let text = format!("fn stratiform_f(x: f32, i: u32) -> f32 {{\n    return {value};\n}}\n");
        let text = printed(&text, Target::C).unwrap();
        text.lines().find(|line| line.contains("return")).unwrap().trim().to_owned()
    };
    assert_eq!(c("-f32(i + 1u) * x"), "return -(float)(i + 1u) * x;");
    assert_eq!(c("x - (x - x)"), "return x - (x - x);");
    assert_eq!(c("x - (select(x, 1.0, i < 2u)) / x"), "return x - (i < 2u ? 1.0f : x) / x;");
    assert_eq!(c("-(-x)"), "return -(-x);");
}

#[test]
fn what_targets_read_differently_is_refused() {
    let value = |value: &str| format!("fn stratiform_f(x: f32, i: u32) -> f32 {{\n    return {value};\n}}\n");
    for (text, message) in [
        ("x % 2.0", "`%` is for u32"),
        ("select(x, 1.0, x < 1.0 == (i < 2u))", "not chained"),
        ("select(x, 1.0, x < 1.0 && i < 2u || i < 3u)", "need brackets"),
        ("--x", "two signs"),
        ("x + i", "different types"),
        ("x + 1", "no number"),
        ("1.", "no number"),
        ("1e39", "no number"),
        ("1e-60", "no number"),
        ("f32(010u)", "no number"),
        ("f32(4294967296u)", "no number"),
        ("inf", "before it is declared"),
        ("NaN", "before it is declared"),
        ("exp(1.0 - 2.0)", "numbers alone"),
        ("f32(min(i, 2u))", "takes f32"),
        ("f32(x < 1.0)", "takes one number"),
        ("-i", "is for f32"),
    ] {
        let error = printed(&value(text), Target::C).unwrap_err();
        assert!(error.message.contains(message), "{text}: {error}");
    }
    let structure = "struct StratiformS {\n    a: f32,\n}\nfn stratiform_s(s: StratiformS) -> f32 {\n    return s.a;\n}\n";
    for text in ["stratiform_s(StratiformS(x))", "StratiformS(x).a"] {
        let error = printed(&(structure.to_owned() + &value(text)), Target::Hlsl).unwrap_err();
        assert!(
            error.message.contains("whole `return`") || error.message.contains("a name"),
            "{text}: {error}"
        );
    }
}

#[test]
fn names_that_mean_something_else_are_refused() {
    let local =
        |name: &str| format!("fn stratiform_f(x: f32) -> f32 {{\n    let {name} = x;\n    return x;\n}}\n");
    let words = [
        "half", "sample", "near", "min", "loop", "register", "yield", "point", "patch", "kernel", "typename",
    ];
    for name in
        words.iter().chain(&["result", "_x", "a__b", "gl_x", "restrict", "linear", "I", "y1", "exp", "x"])
    {
        let error = printed(&local(name), Target::C).unwrap_err();
        assert!(error.message.contains(&format!("`{name}`")), "{name}: {error}");
    }
    for text in [
        "const stratiform_f: f32 = 1.0;\nfn stratiform_f(x: f32) -> f32 {\n    return x;\n}\n",
        "fn unprefixed(x: f32) -> f32 {\n    return x;\n}\n",
        "fn stratiform_f(half: f32) -> f32 {\n    return half;\n}\n",
        "struct StratiformS {\n    near: f32,\n}\n",
        "fn stratiform_f(x: f32) -> f32 {\n    let y = x;\n    y = 2.0;\n    return y;\n}\n",
        "// Ends in \\\nfn stratiform_f(x: f32) -> f32 {\n    return x;\n}\n",
        "// κ\nfn stratiform_f(x: f32) -> f32 {\n    return x;\n}\n",
    ] {
        assert!(printed(text, Target::C).is_err(), "{text}");
    }
}
