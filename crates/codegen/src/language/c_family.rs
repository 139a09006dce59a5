//! Printing for the languages that look like C: GLSL, HLSL, MSL and C itself.

use super::layout::{Broken, Lines};
use super::syntax::{Expr, Function, Item, Named, Statement, Type};
use std::collections::{BTreeMap, BTreeSet};

/// What sets one language of the family apart.
pub(super) struct Dialect {
    /// Names of f32 and u32.
    pub float: &'static str,
    pub uint: &'static str,
    /// After a float's digits.
    pub float_suffix: &'static str,
    /// In front of a constant.
    pub constant: &'static str,
    /// In front of a function.
    pub function: &'static str,
    /// Whether a structure's values come as `Name(…)`; else a variable is declared with `{…}`.
    pub constructor: bool,
    /// Whether this is C: `typedef`, `(float)x`, `expf`.
    pub c: bool,
}

/// A structure that the functions become members of.
pub(super) struct Members<'a> {
    /// Its name.
    pub owner: &'a str,
    /// Its first lines.
    pub text: &'a str,
    /// Functions that are members of another structure, each with its name here.
    pub callees: &'a BTreeMap<String, String>,
}

/// The items from `own` on as text.
pub(super) fn print(items: &[Item], own: usize, dialect: &Dialect, members: Option<Members<'_>>) -> String {
    let structs = items.iter().filter_map(|item| match item {
        Item::Struct(_, name, _) => Some(name.as_str()),
        _ => None,
    });
    let lines = Lines::default();
    let mut printer = Printer { dialect, structs: structs.collect(), lines, members: members.as_ref() };
    let items = &items[own..];
    let first = items.iter().position(|item| matches!(item, Item::Function(_))).unwrap_or(items.len());
    items[..first].iter().for_each(|item| printer.item(item));
    if let Some(Members { owner, text, .. }) = &members {
        printer.lines.push(&format!("struct {owner} {{"));
        printer.lines.indent();
        text.lines().for_each(|line| printer.lines.push(line));
    }
    items[first..].iter().for_each(|item| printer.item(item));
    if members.is_some() {
        printer.lines.outdent();
        printer.lines.push("};");
    }
    printer.lines.into_text()
}

struct Printer<'a> {
    dialect: &'a Dialect,
    structs: BTreeSet<&'a str>,
    lines: Lines,
    members: Option<&'a Members<'a>>,
}

impl Printer<'_> {
    fn item(&mut self, item: &Item) {
        match item {
            Item::Blank => self.lines.push(""),
            Item::Comment(line) => self.comment(line),
            Item::Const(docs, variable, value) => {
                self.docs(docs);
                let line =
                    format!("{}{} = {};", self.dialect.constant, self.named(variable), self.expr(value));
                self.lines.push(&line);
            }
            Item::Struct(docs, name, fields) => self.structure(docs, name, fields),
            Item::Function(function) => self.function(function),
        }
    }

    fn comment(&mut self, line: &str) {
        self.lines.push(format!("// {line}").trim_end());
    }

    fn docs(&mut self, docs: &[String]) {
        docs.iter().for_each(|line| self.comment(line));
    }

    fn structure(&mut self, docs: &[String], name: &str, fields: &[Named]) {
        self.docs(docs);
        let (open, close) = if self.dialect.c {
            (format!("typedef struct {name} {{"), format!("}} {name};"))
        } else {
            (format!("struct {name} {{"), "};".to_owned())
        };
        self.lines.push(&open);
        self.lines.indent();
        for field in fields {
            let line = format!("{};", self.named(field));
            self.lines.push(&line);
        }
        self.lines.outdent();
        self.lines.push(&close);
    }

    fn function(&mut self, function: &Function) {
        self.docs(&function.docs);
        let mut parameters: Vec<_> = function.parameters.iter().map(|p| self.named(p)).collect();
        if parameters.is_empty() && self.dialect.c {
            parameters.push("void".to_owned());
        }
        let (before, after) =
            if self.members.is_some() { ("", ") const {") } else { (self.dialect.function, ") {") };
        let open = format!("{before}{} {}(", self.kind(&function.result), function.name);
        let head = Broken { open, parts: parameters, joint: ", ", close: after.to_owned() };
        self.lines.push_broken("", &head, "");
        self.block(&function.body);
        self.lines.push("}");
    }

    fn block(&mut self, statements: &[Statement]) {
        self.lines.indent();
        statements.iter().for_each(|statement| self.statement(statement));
        self.lines.outdent();
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Comment(line) => self.comment(line),
            Statement::Declare { variable, value, .. } => self.declaration(variable, value),
            Statement::Assign { name, sign, value } => self.broken(&format!("{name} {sign} "), value, ";"),
            Statement::Return(value) => self.result(value),
            Statement::If { .. } => self.condition("", statement),
            Statement::For { counter, from, condition, sign, step, body } => {
                let head = format!(
                    "for ({} = {}; {}; {} {sign} {}) {{",
                    self.named(counter),
                    self.expr(from),
                    self.expr(condition),
                    counter.name,
                    self.expr(step)
                );
                self.lines.push(&head);
                self.block(body);
                self.lines.push("}");
            }
            Statement::Switch { selector, cases } => self.switch(selector, cases),
        }
    }

    fn condition(&mut self, before: &str, statement: &Statement) {
        let Statement::If { condition, then, otherwise } = statement else { return };
        self.lines.push(&format!("{before}if ({}) {{", self.expr(condition)));
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

    fn switch(&mut self, selector: &Expr, cases: &[(Option<String>, Expr)]) {
        self.lines.push(&format!("switch ({}) {{", self.expr(selector)));
        self.lines.indent();
        for (label, value) in cases {
            let label = label.as_ref().map_or("default:".to_owned(), |digits| format!("case {digits}u:"));
            if self.fields(value).is_none() {
                self.broken(&format!("{label} return "), value, ";");
                continue;
            }
            self.lines.push(&format!("{label} {{"));
            self.lines.indent();
            self.result(value);
            self.lines.outdent();
            self.lines.push("}");
        }
        self.lines.outdent();
        self.lines.push("}");
    }

    fn declaration(&mut self, variable: &Named, value: &Expr) {
        let before = format!("{} = ", self.named(variable));
        match self.fields(value) {
            Some(list) => self.lines.push_broken(&before, &list, ";"),
            None => self.broken(&before, value, ";"),
        }
    }

    fn result(&mut self, value: &Expr) {
        match (self.fields(value), value) {
            (Some(list), Expr::Call(name, _)) => {
                self.lines.push_broken(&format!("{name} result = "), &list, ";");
                self.lines.push("return result;");
            }
            _ => self.broken("return ", value, ";"),
        }
    }

    /// `{a, b}` where a structure's values cannot be written as a call.
    fn fields(&self, value: &Expr) -> Option<Broken> {
        match value {
            Expr::Call(name, arguments)
                if !self.dialect.constructor && self.structs.contains(name.as_str()) =>
            {
                let parts = arguments.iter().map(|argument| self.expr(argument)).collect();
                Some(Broken { open: "{".to_owned(), parts, joint: ", ", close: "}".to_owned() })
            }
            _ => None,
        }
    }

    fn broken(&mut self, before: &str, value: &Expr, after: &str) {
        let broken = match value {
            Expr::Call(name, arguments) if name != "select" && !self.is_cast(name) => Broken {
                open: format!("{}(", self.function_name(name)),
                parts: arguments.iter().map(|argument| self.expr(argument)).collect(),
                joint: ", ",
                close: ")".to_owned(),
            },
            Expr::Binary("+", ..) => {
                let parts = value.terms().into_iter().map(|term| self.expr(term)).collect();
                Broken { open: String::new(), parts, joint: " + ", close: String::new() }
            }
            _ => {
                Broken { open: String::new(), parts: vec![self.expr(value)], joint: "", close: String::new() }
            }
        };
        self.lines.push_broken(before, &broken, after);
    }

    fn kind(&self, kind: &Type) -> String {
        match kind {
            Type::F32 => self.dialect.float.to_owned(),
            Type::U32 => self.dialect.uint.to_owned(),
            Type::Bool => "bool".to_owned(),
            Type::Struct(name) => name.clone(),
        }
    }

    fn named(&self, named: &Named) -> String {
        format!("{} {}", self.kind(&named.kind), named.name)
    }

    fn is_cast(&self, name: &str) -> bool {
        matches!(name, "f32" | "u32")
    }

    fn function_name(&self, name: &str) -> String {
        match name {
            "abs" | "min" | "max" if self.dialect.c => format!("f{name}f"),
            "exp" | "log" | "sqrt" | "floor" | "sin" | "cos" | "pow" if self.dialect.c => format!("{name}f"),
            _ => match self.members.and_then(|members| members.callees.get(name)) {
                Some(structure) => format!("{structure}.{name}"),
                None => name.to_owned(),
            },
        }
    }

    fn expr(&self, expr: &Expr) -> String {
        match expr {
            Expr::Number(digits, Type::U32) => format!("{digits}u"),
            Expr::Number(digits, _) => format!("{digits}{}", self.dialect.float_suffix),
            Expr::Name(name) => name.clone(),
            Expr::Field(inner, field) => format!("{}.{field}", self.expr(inner)),
            Expr::Group(inner) => format!("({})", self.expr(inner)),
            Expr::Unary(sign, inner) => format!("{sign}{}", self.expr(inner)),
            Expr::Binary(sign, left, right) => format!("{} {sign} {}", self.expr(left), self.expr(right)),
            Expr::Call(name, arguments) => self.call(name, arguments),
        }
    }

    fn call(&self, name: &str, arguments: &[Expr]) -> String {
        let list: Vec<_> = arguments.iter().map(|argument| self.expr(argument)).collect();
        match (name, list.as_slice()) {
            ("select", [no, yes, condition]) => format!("({condition} ? {yes} : {no})"),
            ("f32" | "u32", [value]) if self.dialect.c => {
                let kind = if name == "f32" { self.dialect.float } else { self.dialect.uint };
                match &arguments[0] {
                    Expr::Name(_) => format!("({kind}){value}"),
                    _ => format!("({kind})({value})"),
                }
            }
            ("f32", [value]) => format!("{}({value})", self.dialect.float),
            ("u32", [value]) => format!("{}({value})", self.dialect.uint),
            _ => format!("{}({})", self.function_name(name), list.join(", ")),
        }
    }
}
