//! Lines with indentation, broken where they grow long.

/// Longest line.
const WIDTH: usize = 110;

/// Text under construction.
#[derive(Default)]
pub(super) struct Lines {
    text: String,
    depth: usize,
}

/// A piece of an expression that may be broken: `open` parts joined by `joint` `close`.
pub(super) struct Broken {
    pub open: String,
    pub parts: Vec<String>,
    pub joint: &'static str,
    pub close: String,
}

impl Lines {
    pub fn into_text(self) -> String {
        self.text
    }

    pub fn push(&mut self, line: &str) {
        if !line.is_empty() {
            self.text.push_str(&"    ".repeat(self.depth));
            self.text.push_str(line);
        }
        self.text.push('\n');
    }

    pub fn indent(&mut self) {
        self.depth += 1;
    }

    pub fn outdent(&mut self) {
        self.depth -= 1;
    }

    /// `before` + the expression + `after`; over several lines if one would be too long.
    pub fn push_broken(&mut self, before: &str, broken: &Broken, after: &str) {
        let Broken { open, parts, joint, close } = broken;
        let whole = format!("{before}{open}{}{close}{after}", parts.join(joint));
        if whole.len() + 4 * self.depth <= WIDTH || parts.len() < 2 {
            self.push(&whole);
        } else if open.is_empty() {
            self.push(&format!("{before}{}", parts[0]));
            self.indent();
            let last = parts.len() - 1;
            for (i, part) in parts.iter().enumerate().skip(1) {
                let end = if i == last { format!("{close}{after}") } else { String::new() };
                self.push(&format!("{}{part}{end}", joint.trim_start()));
            }
            self.outdent();
        } else {
            self.push(format!("{before}{open}").trim_end());
            self.indent();
            self.fill(parts);
            self.outdent();
            self.push(format!("{close}{after}").trim_start());
        }
    }

    /// As many parts a line as fit, each with its comma but the last.
    fn fill(&mut self, parts: &[String]) {
        let mut line = String::new();
        for (i, part) in parts.iter().enumerate() {
            let piece = if i + 1 < parts.len() { format!("{part},") } else { part.clone() };
            if !line.is_empty() && line.len() + 1 + piece.len() + 4 * self.depth > WIDTH {
                self.push(&line);
                line.clear();
            }
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(&piece);
        }
        self.push(&line);
    }
}
