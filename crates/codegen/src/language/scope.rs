//! What names stand for, and the types of expressions.

use super::reserved;
use super::syntax::{Expr, Named, Type};
use std::collections::{BTreeMap, BTreeSet};

/// What every name outside functions starts with, in any case: pasted text must not collide with its surroundings.
const PREFIX: &str = "stratiform";

/// Names known so far.
#[derive(Default)]
pub(super) struct Scope {
    structs: BTreeMap<String, Vec<Named>>,
    functions: BTreeMap<String, Type>,
    globals: BTreeMap<String, Type>,
    locals: BTreeMap<String, Type>,
    /// Locals that may be assigned.
    variables: BTreeSet<String>,
}

impl Scope {
    /// That `name` may be declared: no target reserves it, and nothing else has it.
    fn free(&self, name: &str) -> Result<(), String> {
        if let Some(reason) = reserved::reason(name) {
            return Err(format!("`{name}` {reason}"));
        }
        let taken = [&self.functions, &self.globals, &self.locals].iter().any(|map| map.contains_key(name));
        if taken || self.structs.contains_key(name) || BUILT_IN.contains(&name) {
            return Err(format!("`{name}` is declared twice"));
        }
        Ok(())
    }

    /// As [`free`](Self::free), outside functions.
    fn free_outside(&mut self, name: &str) -> Result<(), String> {
        self.locals.clear();
        self.variables.clear();
        self.free(name)?;
        if name.to_ascii_lowercase().starts_with(PREFIX) {
            Ok(())
        } else {
            Err(format!("`{name}` does not start with {PREFIX}"))
        }
    }

    pub fn add_struct(&mut self, name: &str, fields: &[Named]) -> Result<(), String> {
        self.free_outside(name)?;
        if let Some((field, reason)) = fields.iter().find_map(|f| Some((f, reserved::reason(&f.name)?))) {
            return Err(format!("`{}` {reason}", field.name));
        }
        self.structs.insert(name.to_owned(), fields.to_vec());
        Ok(())
    }

    pub fn add_global(&mut self, variable: &Named) -> Result<(), String> {
        self.free_outside(&variable.name)?;
        self.globals.insert(variable.name.clone(), variable.kind.clone());
        Ok(())
    }

    /// Makes a function known, and forgets the locals of the one before.
    pub fn enter(&mut self, name: &str, parameters: &[Named], result: &Type) -> Result<(), String> {
        self.free_outside(name)?;
        self.functions.insert(name.to_owned(), result.clone());
        parameters.iter().try_for_each(|parameter| self.add_local(parameter, false))
    }

    /// A name of a function's, once in the whole function: a second one would shadow it.
    pub fn add_local(&mut self, variable: &Named, mutable: bool) -> Result<(), String> {
        self.free(&variable.name)?;
        self.locals.insert(variable.name.clone(), variable.kind.clone());
        if mutable {
            self.variables.insert(variable.name.clone());
        }
        Ok(())
    }

    /// Whether `name` may be assigned.
    pub fn is_variable(&self, name: &str) -> bool {
        self.variables.contains(name)
    }

    pub fn is_struct(&self, name: &str) -> bool {
        self.structs.contains_key(name)
    }

    /// A type by its WGSL name.
    pub fn kind(&self, name: &str) -> Option<Type> {
        match name {
            "f32" => Some(Type::F32),
            "u32" => Some(Type::U32),
            "bool" => Some(Type::Bool),
            _ => self.structs.contains_key(name).then(|| Type::Struct(name.to_owned())),
        }
    }

    /// The type of an expression; none if it holds an unknown name.
    pub fn type_of(&self, expr: &Expr) -> Option<Type> {
        match expr {
            Expr::Number(_, kind) => Some(kind.clone()),
            Expr::Name(name) => self.locals.get(name).or_else(|| self.globals.get(name)).cloned(),
            Expr::Field(inner, field) => match self.type_of(inner)? {
                Type::Struct(name) => {
                    self.structs.get(&name)?.iter().find(|f| f.name == *field).map(|f| f.kind.clone())
                }
                _ => None,
            },
            Expr::Call(name, arguments) => self.type_of_call(name, arguments),
            Expr::Unary("!", _) | Expr::Binary("<" | ">" | "<=" | ">=" | "==" | "!=" | "&&" | "||", ..) => {
                Some(Type::Bool)
            }
            Expr::Unary(_, inner) | Expr::Binary(_, inner, _) | Expr::Group(inner) => self.type_of(inner),
        }
    }

    fn type_of_call(&self, name: &str, arguments: &[Expr]) -> Option<Type> {
        match self.kind(name).or_else(|| self.functions.get(name).cloned()) {
            Some(kind) => Some(kind),
            None if BUILT_IN.contains(&name) => self.type_of(arguments.first()?),
            None => None,
        }
    }
}

/// Functions of WGSL that every target has; the type is that of the first argument.
pub(super) const BUILT_IN: [&str; 11] =
    ["abs", "exp", "log", "sqrt", "min", "max", "floor", "sin", "cos", "pow", "select"];

/// Whether nothing in `expr` has a name: a number whose type a method of Rust's could not tell.
pub(super) fn is_nameless(expr: &Expr) -> bool {
    match expr {
        Expr::Number(..) => true,
        Expr::Name(_) | Expr::Field(..) => false,
        Expr::Unary(_, inner) | Expr::Group(inner) => is_nameless(inner),
        Expr::Binary(_, left, right) => is_nameless(left) && is_nameless(right),
        Expr::Call(_, arguments) => !arguments.is_empty() && arguments.iter().all(is_nameless),
    }
}
