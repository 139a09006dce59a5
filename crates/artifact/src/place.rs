//! Where in a TOML text something stands.

/// The line, counted from 1, of a byte offset.
pub fn line_of(text: &str, offset: usize) -> usize {
    text.as_bytes().iter().take(offset).filter(|byte| **byte == b'\n').count() + 1
}

/// The line that assigns a dotted key, e.g. `fit.thickness_m.min`: in the table that its front part names, or, for inline
/// tables, on the line of that part; a key without front part on the first line that assigns it.
pub fn key_line(text: &str, key: &str) -> Option<usize> {
    let parts: Vec<_> = key.split('.').collect();
    let last = parts.len() - 1;
    (0..=last).rev().find_map(|cut| {
        let header = (cut > 0).then(|| parts[..cut].join("."));
        assignment(text, header.as_deref(), parts[cut])
    })
}

/// The first line `name = …`, below the line `[header]` and before the next header if one is asked for.
fn assignment(text: &str, header: Option<&str>, name: &str) -> Option<usize> {
    let mut inside = header.is_none();
    for (index, line) in text.lines().enumerate() {
        let line = line.trim_start();
        match (line.strip_prefix('[').and_then(|rest| rest.split(']').next()), header) {
            (Some(table), Some(header)) => {
                inside =
                    table.strip_suffix(header).is_some_and(|front| front.is_empty() || front.ends_with('.'));
            }
            _ if inside && line.strip_prefix(name).is_some_and(|rest| rest.trim_start().starts_with('=')) => {
                return Some(index + 1);
            }
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_from_one_within_their_table() {
        let text = "a = 1\n[b]\n  photons = 0\n[c]\nphotons = 2\nd = { min = 0 }\n";
        assert_eq!(key_line(text, "photons"), Some(3));
        assert_eq!(key_line(text, "c.photons"), Some(5));
        assert_eq!(key_line(text, "c.d.min"), Some(6));
        assert_eq!(key_line(text, "photon"), None);
        assert_eq!(line_of(text, 7), 2);
    }
}
