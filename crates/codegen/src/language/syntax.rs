//! The subset as a tree, with comments where they stood.

/// What a value is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Type {
    F32,
    U32,
    Bool,
    Struct(String),
}

/// A named, typed thing: a field or a parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Named {
    pub name: String,
    pub kind: Type,
}

/// What stands at the top level.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Item {
    Blank,
    /// A comment that belongs to no item.
    Comment(String),
    Const(Vec<String>, Named, Expr),
    Struct(Vec<String>, String, Vec<Named>),
    Function(Function),
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Function {
    pub docs: Vec<String>,
    pub name: String,
    pub parameters: Vec<Named>,
    pub result: Type,
    pub body: Vec<Statement>,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    Comment(String),
    /// `let` or `var`.
    Declare {
        variable: Named,
        value: Expr,
        mutable: bool,
    },
    /// `name = value`, `name += value`, …
    Assign {
        name: String,
        sign: &'static str,
        value: Expr,
    },
    If {
        condition: Expr,
        then: Vec<Statement>,
        otherwise: Vec<Statement>,
    },
    /// `for (var counter = from; condition; counter sign step)`
    For {
        counter: Named,
        from: Expr,
        condition: Expr,
        sign: &'static str,
        step: Expr,
        body: Vec<Statement>,
    },
    /// Every case returns; the last one is the default.
    Switch {
        selector: Expr,
        cases: Vec<(Option<String>, Expr)>,
    },
    Return(Expr),
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Expr {
    /// Digits without suffix.
    Number(String, Type),
    Name(String),
    Field(Box<Expr>, String),
    /// A function, built-in, cast or structure with its arguments.
    Call(String, Vec<Expr>),
    Unary(&'static str, Box<Expr>),
    Binary(&'static str, Box<Expr>, Box<Expr>),
    /// In brackets.
    Group(Box<Expr>),
}

impl Expr {
    /// The summands of a sum, from left to right; of anything else, itself.
    pub fn terms(&self) -> Vec<&Self> {
        match self {
            Self::Binary("+", left, right) => {
                let mut terms = left.terms();
                terms.push(right);
                terms
            }
            other => vec![other],
        }
    }
}
