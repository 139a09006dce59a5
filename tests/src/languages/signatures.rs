//! Exported functions and structures of an emitted text in any of its languages, with types by one name each.
//!
//! Two grammars suffice: `type name(type parameter, …) {` and `fn name(parameter: type, …) -> type {`.

use std::collections::BTreeMap;

/// What every emitted function's name starts with.
const PREFIX: &str = "stratiform_";
/// What every emitted structure's name starts with.
const STRUCT_PREFIX: &str = "Stratiform";

/// Name of a type in any language -> its name here.
const TYPES: [(&str, &str); 7] = [
    ("float", "f32"),
    ("int", "i32"),
    ("int32_t", "i32"),
    ("uint", "u32"),
    ("uint32_t", "u32"),
    ("unsigned", "u32"),
    ("vec2<f32>", "vec2"),
];

/// Functions by name, as `name: type, … -> type`; structures by name, as `name: type, …`.
pub fn signatures(text: &str) -> BTreeMap<String, String> {
    let text = without_comments(text);
    let mut found = BTreeMap::new();
    let (mut depth, mut head) = (0_usize, 0);
    for (at, character) in text.char_indices() {
        match character {
            '{' => {
                if depth == 0 {
                    let body = &text[at + 1..];
                    found.extend(function(&text[head..at]).or_else(|| structure(&text[head..at], body)));
                }
                depth += 1;
            }
            '}' => {
                depth = depth.saturating_sub(1);
                head = at + 1;
            }
            ';' | '#' if depth == 0 => head = at + 1,
            _ => {}
        }
    }
    found
}

fn without_comments(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some(at) = rest.find("//").into_iter().chain(rest.find("/*")).min() {
        kept.push_str(&rest[..at]);
        let end = if rest[at..].starts_with("//") { "\n" } else { "*/" };
        let length = rest[at..].find(end).map_or(rest.len() - at, |length| length + end.len());
        kept.push('\n');
        rest = &rest[at + length..];
    }
    let kept = kept + rest;
    kept.lines().filter(|line| !line.trim_start().starts_with('#')).collect::<Vec<_>>().join("\n")
}

/// `static inline float stratiform_x(float y)` or `pub fn stratiform_x(y: f32) -> f32`.
fn function(head: &str) -> Option<(String, String)> {
    let start = head.find(PREFIX)?;
    let (name, rest) = head[start..].split_once('(')?;
    let (parameters, after) = rest.rsplit_once(')')?;
    let result = match after.split_once("->") {
        Some((_, result)) => named(result),
        None => named(head[..start].split_whitespace().next_back()?),
    };
    let parameters: Vec<_> = parameters.split(',').filter_map(declared).collect();
    Some((name.trim().to_owned(), format!("{} -> {result}", parameters.join(", "))))
}

/// `struct StratiformX { … }`, the semicolon or comma after the last field optional.
fn structure(head: &str, body: &str) -> Option<(String, String)> {
    let words = || head.split_whitespace();
    words().find(|word| *word == "struct")?;
    let name = words().find(|word| word.starts_with(STRUCT_PREFIX))?;
    let (fields, _) = body.split_once('}')?;
    let fields: Vec<_> = fields.split([',', ';']).filter_map(declared).collect();
    Some((name.to_owned(), fields.join(", ")))
}

/// One parameter or field as `name: type`.
fn declared(text: &str) -> Option<String> {
    let text = text.trim();
    let (name, of) = match text.split_once(':') {
        Some((name, of)) => (name.split_whitespace().next_back()?, of),
        None => {
            let (of, name) = text.rsplit_once(char::is_whitespace)?;
            (name, of.split_whitespace().next_back()?)
        }
    };
    Some(format!("{name}: {}", named(of)))
}

fn named(of: &str) -> String {
    let of = of.trim();
    TYPES.iter().find(|(name, _)| *name == of).map_or(of, |(_, name)| name).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const WGSL: &str = "
        // fn stratiform_gone(x: f32) -> f32 {}
        struct StratiformPair { a: f32, b: u32, }
        const STRATIFORM_X: f32 = 1.0;
        fn stratiform_rise(
            y: f32, // depth
            count: u32,
        ) -> f32 { if (y < 1.0) { return y; } return exp(-y); }
        fn stratiform_self_test() -> u32 { return 0u; }";
    const RUST: &str = "
        #![allow(dead_code)]
        /// A pair; of two.
        #[derive(Clone, Copy)]
        pub struct StratiformPair { pub a: f32, pub b: u32 }
        pub const STRATIFORM_X: f32 = 1.0;
        pub fn stratiform_rise(y: f32, count: u32) -> f32 { let z = [0.0]; if y < 1.0 { y } else { z[0] } }
        pub fn stratiform_self_test() -> u32 { 0 }";
    const C: &str = "
        #ifndef X
        #define X
        #include <math.h>
        typedef struct StratiformPair { float a; uint32_t b; } StratiformPair;
        /* stratiform_gone(x); */
        static inline float stratiform_later(float y);
        static const float STRATIFORM_X = 1.0f;
        static inline float stratiform_rise(const float y, uint32_t count) { return y; }
        static inline uint32_t stratiform_self_test(void) { return 0u; }
        #endif";

    #[test]
    fn the_same_text_has_the_same_signatures_in_every_language() {
        let expected = BTreeMap::from([
            ("StratiformPair", "a: f32, b: u32"),
            ("stratiform_rise", "y: f32, count: u32 -> f32"),
            ("stratiform_self_test", " -> u32"),
        ]);
        for text in [WGSL, RUST, C] {
            let found = signatures(text);
            let found: BTreeMap<_, _> = found.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
            assert_eq!(found, expected);
        }
    }

    #[test]
    fn a_changed_name_type_or_order_is_seen() {
        let original = signatures(C);
        for (from, to) in [
            ("_rise", "_rise_1"),
            ("const float y", "const double y"),
            ("float a", "float a_"),
            ("uint32_t count", "int count"),
            ("inline uint32_t", "inline float"),
        ] {
            assert_ne!(signatures(&C.replacen(from, to, 1)), original, "{from}");
        }
    }
}
