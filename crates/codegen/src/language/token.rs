//! Words of the WGSL subset, with the comments that other readers throw away.

use super::SubsetError;

/// One word of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Token {
    /// A whole line `// …`, without the slashes and the blank after them.
    Comment(String),
    /// An empty line.
    Blank,
    /// A name or a keyword.
    Word(String),
    /// A number as it stands there, with its `u`.
    Number(String),
    /// An operator or a bracket.
    Sign(&'static str),
}

/// Longest first, so that `<=` is not read as `<`.
const SIGNS: [&str; 29] = [
    "->", "<=", ">=", "==", "!=", "&&", "||", "+=", "-=", "*=", "/=", "(", ")", "{", "}", ",", ";", ":", ".",
    "<", ">", "=", "+", "-", "*", "/", "%", "!", "&",
];

/// The words of `text`, each with its line, counted from 1.
pub(super) fn tokens(text: &str) -> Result<Vec<(usize, Token)>, SubsetError> {
    let mut found = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let trimmed = line.trim();
        if trimmed.is_empty() {
            found.push((i + 1, Token::Blank));
        } else if let Some(comment) = trimmed.strip_prefix("//") {
            let comment = comment.strip_prefix(' ').unwrap_or(comment);
            if let Some(fault) = comment_fault(comment) {
                return Err(SubsetError::new(i + 1, format!("a comment {fault}")));
            }
            found.push((i + 1, Token::Comment(comment.to_owned())));
        } else {
            words(trimmed, i + 1, &mut found)?;
        }
    }
    Ok(found)
}

/// What in a comment some target would read as more than a comment.
fn comment_fault(comment: &str) -> Option<&'static str> {
    if comment.ends_with('\\') || comment.contains("??/") {
        Some("that ends in a backslash goes on in C")
    } else if !comment.chars().all(|c| c == ' ' || c.is_ascii_graphic()) {
        Some("holds what is not ASCII")
    } else {
        None
    }
}

fn words(mut rest: &str, line: usize, found: &mut Vec<(usize, Token)>) -> Result<(), SubsetError> {
    while let Some(first) = rest.chars().next() {
        let length = if first.is_ascii_alphabetic() || first == '_' {
            let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
            found.push((line, Token::Word(rest[..end].to_owned())));
            end
        } else if first.is_ascii_digit() {
            let end = number_length(rest);
            found.push((line, Token::Number(rest[..end].to_owned())));
            end
        } else {
            let sign = SIGNS.iter().find(|sign| rest.starts_with(**sign));
            let sign =
                sign.ok_or_else(|| SubsetError::new(line, format!("`{first}` is outside the subset")))?;
            found.push((line, Token::Sign(sign)));
            sign.len()
        };
        rest = rest[length..].trim_start();
    }
    Ok(())
}

/// Digits, point, exponent with its sign, `u`.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let belongs = |i: usize| match bytes[i] {
        b'0'..=b'9' | b'.' | b'e' | b'u' => true,
        b'-' | b'+' => bytes[i - 1] == b'e',
        _ => false,
    };
    (0..bytes.len()).find(|&i| !belongs(i)).unwrap_or(bytes.len())
}
