//! What the embedded self-test sees: every number of the emitted C, one at a time, a thousandth off. It misses thresholds
//! at which both sides agree, and where series start.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

use std::fmt::Write as _;
use stratiform_tests::languages::Emitted;
use stratiform_tests::languages::tools::{Scratch, available};

/// Where the functions end that are perturbed.
const SELF_TEST: &str = "// ---- self-test";

/// Where a float begins in a line of C, and its text: `12.5f`, `1e-7f`.
fn floats(line: &str) -> Vec<(usize, &str)> {
    let bytes = line.as_bytes();
    let inside = |i: usize| bytes[i].is_ascii_alphanumeric() || b"._".contains(&bytes[i]);
    let digit = |i: usize| bytes[i].is_ascii_digit() && (i == 0 || !inside(i - 1));
    let end = |start: usize| (start..bytes.len()).find(|&i| bytes[i] == b'f').map(|i| i + 1);
    let starts = (0..bytes.len()).filter(|&i| digit(i));
    let all = starts.filter_map(|start| Some((start, &line[start..end(start)?])));
    all.filter(|(_, text)| text[..text.len() - 1].parse::<f32>().is_ok()).collect()
}

/// The header with float k as `NUMBER(k, float)`, constants as macros; and the line of each float.
fn numbered(header: &str) -> (String, Vec<String>) {
    // Tables too must be able to change.
    let header = header.replace("    static const ", "    const ");
    let (code, rest) = header.split_once(SELF_TEST).unwrap();
    let (mut text, mut lines, mut place) = (String::new(), Vec::new(), String::new());
    for line in code.lines() {
        if line.starts_with("static inline") {
            place = line.to_owned();
        }
        let (line, macros) = match line.strip_prefix("static const float ") {
            Some(constant) => (format!("#define {}", constant.replace(" =", "").replace(';', "")), true),
            None => (line.to_owned(), false),
        };
        let mut at = 0;
        let found = if line.starts_with("//") { Vec::new() } else { floats(&line) };
        for (start, number) in found {
            let _ = write!(text, "{}NUMBER({}, {number})", &line[at..start], lines.len());
            at = start + number.len();
            lines.push(if macros { line.clone() } else { format!("{place} {}", line.trim()) });
        }
        text.push_str(&line[at..]);
        text.push('\n');
    }
    (format!("{text}{SELF_TEST}{rest}"), lines)
}

const MAIN: &str = "
#include <stdio.h>
int main(void) {
    for (stratiform_slipped = -1; stratiform_slipped < COUNT; stratiform_slipped += 1) {
        printf(\"%u\\n\", stratiform_self_test());
    }
    return 0;
}
";

/// A thousandth of a number, or a thousandth where it is 0.
const HEAD: &str = "static int stratiform_slipped;
#define NUMBER(k, x) (stratiform_slipped == (k) ? (x) * 1.001f + ((x) == 0.0f ? 0.001f : 0.0f) : (x))
";

#[test]
fn a_thousandth_of_any_number_of_the_table_is_seen() {
    let (text, lines) = numbered(&Emitted::committed().text("stratiform.h"));
    let run = || {
        let scratch = Scratch::new()?;
        scratch.write("slips.c", format!("{HEAD}{text}\n#define COUNT {}\n{MAIN}", lines.len()))?;
        scratch.run("gcc", &["-std=c99", "-O1", "slips.c", "-o", "slips", "-lm"])?;
        scratch.run_program("slips", b"")
    };
    let Some(output) = available(run(), &[]) else { return };
    let wrong: Vec<u32> = String::from_utf8(output).unwrap().lines().map(|l| l.parse().unwrap()).collect();
    assert_eq!((wrong[0], wrong.len()), (0, lines.len() + 1));
    let unseen: Vec<_> = lines.iter().zip(&wrong[1..]).filter(|(_, wrong)| **wrong == 0).collect();
    println!("{} numbers, of which {} are not seen:", lines.len(), unseen.len());
    unseen.iter().for_each(|(line, _)| println!("  {line}"));
    // Ten rows of five and their cosines, the diffuse row, three constants.
    let of_table = |line: &str| {
        ["stratiform_node", "stratiform_diffuse_parameters", "#define"].iter().any(|name| line.contains(name))
    };
    assert!(lines.iter().filter(|line| of_table(line)).count() >= 10 * 6 + 5 + 3);
    let lost: Vec<_> = unseen.iter().filter(|(line, _)| of_table(line)).collect();
    assert!(lost.is_empty(), "{lost:#?}");
}
