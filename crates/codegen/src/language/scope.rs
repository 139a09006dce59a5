//! What names stand for, and the types of expressions.

use super::syntax::{Expr, Named, Type};
use std::collections::BTreeMap;

/// Names known so far.
#[derive(Default)]
pub(super) struct Scope {
    structs: BTreeMap<String, Vec<Named>>,
    functions: BTreeMap<String, Type>,
    globals: BTreeMap<String, Type>,
    locals: BTreeMap<String, Type>,
}

impl Scope {
    pub fn add_struct(&mut self, name: &str, fields: &[Named]) {
        self.structs.insert(name.to_owned(), fields.to_vec());
    }

    pub fn add_global(&mut self, variable: &Named) {
        self.globals.insert(variable.name.clone(), variable.kind.clone());
    }

    /// Makes a function known, and forgets the locals of the one before.
    pub fn enter(&mut self, name: &str, parameters: &[Named], result: &Type) {
        self.functions.insert(name.to_owned(), result.clone());
        self.locals = parameters.iter().map(|p| (p.name.clone(), p.kind.clone())).collect();
    }

    pub fn add_local(&mut self, variable: &Named) {
        self.locals.insert(variable.name.clone(), variable.kind.clone());
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
                    self.structs[&name].iter().find(|f| f.name == *field).map(|f| f.kind.clone())
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
