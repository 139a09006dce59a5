//! Printing for Rust.

use super::layout::{Broken, Lines};
use super::syntax::{Expr, Function, Item, Named, Statement, Type};
use std::collections::BTreeMap;

/// The items from `own` on as text.
pub(super) fn print(items: &[Item], own: usize) -> String {
    let structs = items.iter().filter_map(|item| match item {
        Item::Struct(_, name, fields) => Some((name.as_str(), fields.as_slice())),
        _ => None,
    });
    let mut printer = Printer { structs: structs.collect(), lines: Lines::default() };
    items[own..].iter().for_each(|item| printer.item(item));
    printer.lines.into_text()
}

struct Printer<'a> {
    structs: BTreeMap<&'a str, &'a [Named]>,
    lines: Lines,
}

fn kind(kind: &Type) -> &str {
    match kind {
        Type::F32 => "f32",
        Type::U32 => "u32",
        Type::Bool => "bool",
        Type::Struct(name) => name,
    }
}

fn named(named: &Named) -> String {
    format!("{}: {}", named.name, kind(&named.kind))
}

fn single(text: String) -> Broken {
    Broken { open: String::new(), parts: vec![text], joint: "", close: String::new() }
}

impl Printer<'_> {
    fn item(&mut self, item: &Item) {
        match item {
            Item::Blank => self.lines.push(""),
            Item::Comment(line) => self.lines.push(format!("// {line}").trim_end()),
            Item::Const(docs, variable, value) => {
                self.docs(docs);
                let line = format!("pub const {} = {};", named(variable), self.expr(value));
                self.lines.push(&line);
            }
            Item::Struct(docs, name, fields) => {
                self.docs(docs);
                self.lines.push("#[derive(Clone, Copy, Debug, PartialEq)]");
                self.lines.push(&format!("pub struct {name} {{"));
                self.lines.indent();
                fields.iter().for_each(|field| self.lines.push(&format!("pub {},", named(field))));
                self.lines.outdent();
                self.lines.push("}");
            }
            Item::Function(function) => self.function(function),
        }
    }

    fn docs(&mut self, docs: &[String]) {
        docs.iter().for_each(|line| self.lines.push(format!("/// {line}").trim_end()));
    }

    fn function(&mut self, function: &Function) {
        self.docs(&function.docs);
        let parts = function.parameters.iter().map(named).collect();
        let close = format!(") -> {} {{", kind(&function.result));
        let head = Broken { open: format!("pub fn {}(", function.name), parts, joint: ", ", close };
        self.lines.push_broken("", &head, "");
        self.lines.indent();
        if let [body @ .., tail] = function.body.as_slice() {
            body.iter().for_each(|statement| self.statement(statement));
            self.tail(tail);
        }
        self.lines.outdent();
        self.lines.push("}");
    }

    /// The last statement: its value without `return`.
    fn tail(&mut self, statement: &Statement) {
        match statement {
            Statement::Return(value) => self.broken("", value, ""),
            Statement::Switch { selector, cases } => self.choice(selector, cases),
            other => self.statement(other),
        }
    }

    fn choice(&mut self, selector: &Expr, cases: &[(Option<String>, Expr)]) {
        self.lines.push(&format!("match {} {{", self.expr(selector)));
        self.lines.indent();
        for (label, value) in cases {
            self.broken(&format!("{} => ", label.as_deref().unwrap_or("_")), value, ",");
        }
        self.lines.outdent();
        self.lines.push("}");
    }

    fn block(&mut self, statements: &[Statement]) {
        self.lines.indent();
        statements.iter().for_each(|statement| self.statement(statement));
        self.lines.outdent();
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Comment(line) => self.lines.push(format!("// {line}").trim_end()),
            Statement::Declare { variable, value, mutable } => {
                let keyword = if *mutable { "let mut" } else { "let" };
                self.broken(&format!("{keyword} {} = ", named(variable)), value, ";");
            }
            Statement::Assign { name, sign, value } => self.broken(&format!("{name} {sign} "), value, ";"),
            Statement::Return(value) => self.broken("return ", value, ";"),
            Statement::If { .. } => self.condition("", statement),
            Statement::For { counter, from, condition, sign, step, body } => {
                self.lines.push(&format!("let mut {} = {};", named(counter), self.expr(from)));
                self.lines.push(&format!("while {} {{", self.expr(condition)));
                self.block(body);
                self.lines.indent();
                self.lines.push(&format!("{} {sign} {};", counter.name, self.expr(step)));
                self.lines.outdent();
                self.lines.push("}");
            }
            Statement::Switch { selector, cases } => self.choice(selector, cases),
        }
    }

    fn condition(&mut self, before: &str, statement: &Statement) {
        let Statement::If { condition, then, otherwise } = statement else { return };
        self.lines.push(&format!("{before}if {} {{", self.expr(condition)));
        self.block(then);
        match otherwise.as_slice() {
            [] => self.lines.push("}"),
            [nested @ Statement::If { .. }] => self.condition("} else ", nested),
            others => {
                self.lines.push("} else {");
                self.block(others);
                self.lines.push("}");
            }
        }
    }

    fn broken(&mut self, before: &str, value: &Expr, after: &str) {
        let broken = match value {
            Expr::Call(name, arguments) if self.structs.contains_key(name.as_str()) => Broken {
                open: format!("{name} {{ "),
                parts: self.fields(name, arguments),
                joint: ", ",
                close: " }".to_owned(),
            },
            Expr::Call(name, arguments) if name.starts_with("stratiform_") => Broken {
                open: format!("{name}("),
                parts: arguments.iter().map(|argument| self.bare(argument)).collect(),
                joint: ", ",
                close: ")".to_owned(),
            },
            Expr::Binary("+", ..) => {
                let parts = value.terms().into_iter().map(|term| self.part(term)).collect();
                Broken { open: String::new(), parts, joint: " + ", close: String::new() }
            }
            other => single(self.bare(other)),
        };
        self.lines.push_broken(before, &broken, after);
    }

    /// `name: value`, or `name` where the value is a variable of that name.
    fn fields(&self, structure: &str, arguments: &[Expr]) -> Vec<String> {
        let pair = |(field, value): (&Named, &Expr)| match value {
            Expr::Name(name) if *name == field.name => name.clone(),
            other => format!("{}: {}", field.name, self.bare(other)),
        };
        self.structs[structure].iter().zip(arguments).map(pair).collect()
    }

    /// An expression that stands alone: a choice needs no brackets.
    fn bare(&self, expr: &Expr) -> String {
        let text = self.expr(expr);
        let choice = text.strip_prefix("(if ").and_then(|rest| rest.strip_suffix(')'));
        match (expr, choice) {
            (Expr::Call(name, _), Some(choice)) if name == "select" => format!("if {choice}"),
            _ => text,
        }
    }

    fn expr(&self, expr: &Expr) -> String {
        match expr {
            Expr::Number(digits, _) | Expr::Name(digits) => digits.clone(),
            Expr::Field(inner, field) => format!("{}.{field}", self.expr(inner)),
            Expr::Group(inner) => format!("({})", self.expr(inner)),
            Expr::Unary(sign, inner) => format!("{sign}{}", self.part(inner)),
            Expr::Binary(sign, left, right) => format!("{} {sign} {}", self.part(left), self.part(right)),
            Expr::Call(name, arguments) => self.call(name, arguments),
        }
    }

    /// Part of a sum or a comparison, or after a sign: `as` binds looser than a sign, and `x as f32 < y` would be read as
    /// a type's arguments.
    fn part(&self, expr: &Expr) -> String {
        match expr {
            Expr::Call(name, _) if name == "f32" || name == "u32" => format!("({})", self.expr(expr)),
            _ => self.expr(expr),
        }
    }

    fn call(&self, name: &str, arguments: &[Expr]) -> String {
        if self.structs.contains_key(name) {
            return format!("{name} {{ {} }}", self.fields(name, arguments).join(", "));
        }
        let list: Vec<_> = arguments.iter().map(|argument| self.bare(argument)).collect();
        match (name, arguments, list.as_slice()) {
            ("select", [Expr::Number(no, Type::U32), Expr::Number(yes, _), _], [.., condition])
                if (no.as_str(), yes.as_str()) == ("0", "1") =>
            {
                format!("u32::from({condition})")
            }
            ("select", _, [no, yes, condition]) => format!("(if {condition} {{ {yes} }} else {{ {no} }})"),
            ("f32" | "u32", [argument], _) => format!("{} as {name}", self.operand(argument)),
            ("log", [argument], _) => format!("{}.ln()", self.operand(argument)),
            ("pow", [base, _], [_, power]) => format!("{}.powf({power})", self.operand(base)),
            ("abs" | "exp" | "sqrt" | "floor" | "sin" | "cos", [argument], _) => {
                format!("{}.{name}()", self.operand(argument))
            }
            ("min" | "max", [first, _], [_, second]) => format!("{}.{name}({second})", self.operand(first)),
            _ => format!("{name}({})", list.join(", ")),
        }
    }

    /// What a method is called on: in brackets unless it is one word.
    fn operand(&self, expr: &Expr) -> String {
        match expr {
            Expr::Number(digits, number) => format!("{digits}_{}", kind(number)),
            Expr::Call(name, _) if name == "f32" || name == "u32" => self.part(expr),
            Expr::Name(_) | Expr::Field(..) | Expr::Group(_) | Expr::Call(..) => self.expr(expr),
            other => format!("({})", self.expr(other)),
        }
    }
}
