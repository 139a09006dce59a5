//! Numbers in text: the shortest decimals that are the same number in f32, some to a line.

/// `numbers` with `separator` between them and eight to a line, every line but the first after `indent`.
pub(super) fn list(numbers: &[f64], separator: &str, indent: &str) -> String {
    let line = |chunk: &[f64]| {
        let words: Vec<String> = chunk.iter().map(|x| (*x as f32).to_string()).collect();
        words.join(&format!("{separator} "))
    };
    let lines: Vec<String> = numbers.chunks(8).map(line).collect();
    lines.join(&format!("{separator}\n{indent}"))
}
