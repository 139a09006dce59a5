//! From words to the tree.

use super::SubsetError;
use super::scope::{BUILT_IN, Scope, is_nameless};
use super::syntax::{Expr, Function, Item, Named, Statement, Type};
use super::token::{Token, tokens};

/// Operators from loosest to tightest.
const LEVELS: [&[&str]; 5] =
    [&["||"], &["&&"], &["<", ">", "<=", ">=", "==", "!="], &["+", "-"], &["*", "/", "%"]];

/// The items of `text`; `externals` are functions that it may call and that stand elsewhere.
pub(super) fn parse(text: &str, externals: &[(&str, Type)]) -> Result<Vec<Item>, SubsetError> {
    let mut parser = Parser { tokens: tokens(text)?, at: 0, scope: Scope::default(), value_at: None };
    for (name, result) in externals {
        parser.scope.enter(name, &[], result).map_err(|message| parser.error(message))?;
    }
    let mut items = Vec::new();
    while let Some(token) = parser.peek().cloned() {
        items.push(parser.item(token)?);
    }
    Ok(items)
}

struct Parser {
    tokens: Vec<(usize, Token)>,
    at: usize,
    scope: Scope,
    /// Where a structure's constructor may stand.
    value_at: Option<usize>,
}

impl Parser {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at).map(|(_, token)| token)
    }

    fn error(&self, message: impl Into<String>) -> SubsetError {
        let line = self.tokens.get(self.at).or(self.tokens.last()).map_or(0, |(line, _)| *line);
        SubsetError::new(line, message.into())
    }

    fn is(&self, sign: &str) -> bool {
        matches!(self.peek(), Some(Token::Sign(found)) if *found == sign)
    }

    fn is_word(&self, word: &str) -> bool {
        matches!(self.peek(), Some(Token::Word(found)) if found == word)
    }

    fn take(&mut self, sign: &str) -> bool {
        let found = self.is(sign);
        self.at += usize::from(found);
        found
    }

    fn expect(&mut self, sign: &str) -> Result<(), SubsetError> {
        if self.take(sign) { Ok(()) } else { Err(self.error(format!("`{sign}` is missing"))) }
    }

    fn word(&mut self) -> Result<String, SubsetError> {
        match self.peek() {
            Some(Token::Word(word)) => {
                let word = word.clone();
                self.at += 1;
                Ok(word)
            }
            _ => Err(self.error("a name is missing")),
        }
    }

    fn kind(&mut self) -> Result<Type, SubsetError> {
        let name = self.word()?;
        self.scope.kind(&name).ok_or_else(|| self.error(format!("`{name}` is no type of the subset")))
    }

    /// `name: type`
    fn named(&mut self) -> Result<Named, SubsetError> {
        let name = self.word()?;
        self.expect(":")?;
        Ok(Named { name, kind: self.kind()? })
    }

    /// `name: type, …` up to `end`.
    fn named_list(&mut self, end: &str) -> Result<Vec<Named>, SubsetError> {
        let mut list = Vec::new();
        while !self.take(end) {
            list.push(self.named()?);
            if !self.take(",") {
                self.expect(end)?;
                break;
            }
        }
        Ok(list)
    }

    fn item(&mut self, token: Token) -> Result<Item, SubsetError> {
        match token {
            Token::Blank => {
                self.at += 1;
                Ok(Item::Blank)
            }
            Token::Comment(first) => Ok(self.commented(first)?),
            _ => self.documented(Vec::new()),
        }
    }

    /// Comments directly above an item are its documentation.
    fn commented(&mut self, first: String) -> Result<Item, SubsetError> {
        let start = self.at;
        let mut docs = Vec::new();
        while let Some(Token::Comment(line)) = self.peek() {
            docs.push(line.clone());
            self.at += 1;
        }
        if matches!(self.peek(), Some(Token::Word(_))) {
            return self.documented(docs);
        }
        self.at = start + 1;
        Ok(Item::Comment(first))
    }

    fn documented(&mut self, docs: Vec<String>) -> Result<Item, SubsetError> {
        match self.word()?.as_str() {
            "const" => {
                let variable = self.named()?;
                self.expect("=")?;
                let value = self.whole()?;
                self.expect(";")?;
                self.scope.add_global(&variable).map_err(|message| self.error(message))?;
                Ok(Item::Const(docs, variable, value))
            }
            "struct" => {
                let name = self.word()?;
                self.expect("{")?;
                let fields = self.named_list("}")?;
                self.scope.add_struct(&name, &fields).map_err(|message| self.error(message))?;
                Ok(Item::Struct(docs, name, fields))
            }
            "fn" => self.function(docs).map(Item::Function),
            word => Err(self.error(format!("`{word}` is outside the subset"))),
        }
    }

    fn function(&mut self, docs: Vec<String>) -> Result<Function, SubsetError> {
        let name = self.word()?;
        self.expect("(")?;
        let parameters = self.named_list(")")?;
        self.expect("->")?;
        let result = self.kind()?;
        self.scope.enter(&name, &parameters, &result).map_err(|message| self.error(message))?;
        let body = self.block()?;
        let early = body.split_last().map_or(&[][..], |(_, before)| before);
        if early.iter().any(|statement| matches!(statement, Statement::Switch { .. })) {
            return Err(self.error("a switch is a function's last statement"));
        }
        Ok(Function { docs, name, parameters, result, body })
    }

    fn block(&mut self) -> Result<Vec<Statement>, SubsetError> {
        self.expect("{")?;
        let mut statements = Vec::new();
        while !self.take("}") {
            match self.peek() {
                Some(Token::Blank) => self.at += 1,
                Some(Token::Comment(line)) => {
                    statements.push(Statement::Comment(line.clone()));
                    self.at += 1;
                }
                _ => statements.push(self.statement()?),
            }
        }
        Ok(statements)
    }

    fn statement(&mut self) -> Result<Statement, SubsetError> {
        let word = self.word()?;
        let statement = match word.as_str() {
            "let" | "var" => self.declaration(word == "var")?,
            "return" => Statement::Return(self.value()?),
            "if" => return self.condition(),
            "for" => return self.repetition(),
            "switch" => return self.choice(),
            _ => {
                let (sign, value) = self.assignment()?;
                if !self.scope.is_variable(&word) {
                    return Err(self.error(format!("`{word}` is no variable")));
                }
                Statement::Assign { name: word, sign, value }
            }
        };
        self.expect(";")?;
        Ok(statement)
    }

    /// `name = value` or `name: type = value`, after `let` or `var`.
    fn declaration(&mut self, mutable: bool) -> Result<Statement, SubsetError> {
        let name = self.word()?;
        let stated = if self.take(":") { Some(self.kind()?) } else { None };
        self.expect("=")?;
        let value = self.value()?;
        let kind = stated.or_else(|| self.scope.type_of(&value));
        let kind = kind.ok_or_else(|| self.error(format!("the type of `{name}` is not known")))?;
        let variable = Named { name, kind };
        self.scope.add_local(&variable, mutable).map_err(|message| self.error(message))?;
        Ok(Statement::Declare { variable, value, mutable })
    }

    fn assignment(&mut self) -> Result<(&'static str, Expr), SubsetError> {
        let sign = ["=", "+=", "-=", "*=", "/="].into_iter().find(|sign| self.is(sign));
        let sign = sign.ok_or_else(|| self.error("an assignment is missing"))?;
        self.at += 1;
        Ok((sign, self.whole()?))
    }

    fn condition(&mut self) -> Result<Statement, SubsetError> {
        let condition = self.in_brackets()?;
        let then = self.block()?;
        let mut otherwise = Vec::new();
        if self.is_word("else") {
            self.at += 1;
            if self.is_word("if") {
                self.at += 1;
                otherwise.push(self.condition()?);
            } else {
                otherwise = self.block()?;
            }
        }
        Ok(Statement::If { condition, then, otherwise })
    }

    fn in_brackets(&mut self) -> Result<Expr, SubsetError> {
        self.expect("(")?;
        let expr = self.whole()?;
        self.expect(")")?;
        Ok(expr)
    }

    /// `(var counter = from; condition; counter += step) { … }`
    fn repetition(&mut self) -> Result<Statement, SubsetError> {
        self.expect("(")?;
        if self.word()? != "var" {
            return Err(self.error("a loop declares its counter"));
        }
        let Statement::Declare { variable: counter, value: from, .. } = self.declaration(true)? else {
            return Err(self.error("a loop declares its counter"));
        };
        self.expect(";")?;
        let condition = self.whole()?;
        self.expect(";")?;
        if self.word()? != counter.name {
            return Err(self.error("a loop changes its counter only"));
        }
        let (sign, step) = self.assignment()?;
        self.expect(")")?;
        Ok(Statement::For { counter, from, condition, sign, step, body: self.block()? })
    }

    /// `selector { case 0u: { return …; } … default: { return …; } }`
    fn choice(&mut self) -> Result<Statement, SubsetError> {
        let selector = self.whole()?;
        self.expect("{")?;
        let mut cases = Vec::new();
        while !self.take("}") {
            let label = match self.word()?.as_str() {
                "default" => None,
                _ => match self.primary()? {
                    Expr::Number(digits, Type::U32) => Some(digits),
                    _ => return Err(self.error("a case is a number with u")),
                },
            };
            self.expect(":")?;
            match self.block()?.as_slice() {
                [Statement::Return(value)] => cases.push((label, value.clone())),
                _ => return Err(self.error("a case returns and does nothing else")),
            }
        }
        match cases.last() {
            Some((None, _)) => Ok(Statement::Switch { selector, cases }),
            _ => Err(self.error("the last case is the default")),
        }
    }

    /// What is returned or declared: it alone may be a structure's constructor.
    fn value(&mut self) -> Result<Expr, SubsetError> {
        self.value_at = Some(self.at);
        self.whole()
    }

    /// An expression; brackets around all of it are dropped.
    fn whole(&mut self) -> Result<Expr, SubsetError> {
        let mut expr = self.expression(0)?;
        while let Expr::Group(inner) = expr {
            expr = *inner;
        }
        Ok(expr)
    }

    fn expression(&mut self, level: usize) -> Result<Expr, SubsetError> {
        let Some(signs) = LEVELS.get(level) else { return self.unary() };
        let mut left = self.expression(level + 1)?;
        while let Some(sign) = signs.iter().find(|sign| self.is(sign)) {
            self.at += 1;
            let right = self.expression(level + 1)?;
            self.operands(sign, &left, &right)?;
            left = Expr::Binary(sign, Box::new(left), Box::new(right));
        }
        Ok(left)
    }

    /// That every target reads `left sign right` as it stands there.
    fn operands(&self, sign: &str, left: &Expr, right: &Expr) -> Result<(), SubsetError> {
        let kinds = [left, right].map(|operand| self.scope.type_of(operand));
        let logical = |expr: &Expr| matches!(expr, Expr::Binary("&&" | "||", ..));
        let comparison = |expr: &Expr| matches!(expr, Expr::Binary(s, ..) if LEVELS[2].contains(s));
        let message = match (sign, &kinds) {
            (_, [a, b]) if a != b => "operands have different types",
            (_, [Some(Type::Struct(_)), _]) => "a structure is no operand",
            ("%", [Some(Type::F32), _]) => "`%` is for u32: targets differ on f32",
            ("||", _) if [left, right].iter().any(|e| matches!(e, Expr::Binary("&&", ..))) => {
                "`&&` and `||` need brackets between them"
            }
            ("&&" | "||", [Some(Type::Bool), _]) => return Ok(()),
            ("&&" | "||", _) => "`&&` and `||` are for bool",
            _ if comparison(left) || logical(left) => "comparisons are not chained",
            _ => return Ok(()),
        };
        Err(self.error(message))
    }

    fn unary(&mut self) -> Result<Expr, SubsetError> {
        for sign in ["-", "!"] {
            if self.take(sign) {
                let inner = self.unary()?;
                return match (sign, self.scope.type_of(&inner)) {
                    _ if matches!(inner, Expr::Unary(..)) => {
                        Err(self.error("two signs need brackets between them"))
                    }
                    ("-", Some(Type::F32)) | ("!", Some(Type::Bool)) => {
                        Ok(Expr::Unary(sign, Box::new(inner)))
                    }
                    _ => {
                        Err(self
                            .error(format!("`{sign}` is for {}", if sign == "-" { "f32" } else { "bool" })))
                    }
                };
            }
        }
        let mut expr = self.primary()?;
        while self.take(".") {
            if matches!(&expr, Expr::Call(name, _) if self.scope.is_struct(name)) {
                return Err(self.error("a structure has a name before its fields have"));
            }
            expr = Expr::Field(Box::new(expr), self.word()?);
        }
        Ok(expr)
    }

    fn primary(&mut self) -> Result<Expr, SubsetError> {
        if self.is("(") {
            let inner = self.in_brackets()?;
            let has_brackets = matches!(&inner, Expr::Call(name, _) if name == "select");
            return Ok(if has_brackets { inner } else { Expr::Group(Box::new(inner)) });
        }
        if let Some(Token::Number(text)) = self.peek() {
            let number =
                number(text).ok_or_else(|| self.error(format!("`{text}` is no number of the subset")))?;
            self.at += 1;
            return Ok(number);
        }
        let name = self.word()?;
        if self.take("(") {
            return self.call(name);
        }
        let expr = Expr::Name(name);
        match self.scope.type_of(&expr) {
            Some(_) => Ok(expr),
            None => Err(self.error("a name is used before it is declared")),
        }
    }

    fn call(&mut self, name: String) -> Result<Expr, SubsetError> {
        if self.scope.is_struct(&name) && self.value_at.take() != Some(self.at - 2) {
            return Err(self.error(format!("`{name}(…)` is a whole `return` or `let` only")));
        }
        let mut arguments = Vec::new();
        while !self.take(")") {
            arguments.push(self.whole()?);
            if !self.take(",") {
                self.expect(")")?;
                break;
            }
        }
        let known = BUILT_IN.contains(&name.as_str());
        self.arguments(&name, &arguments)?;
        let expr = Expr::Call(name, arguments);
        match self.scope.type_of(&expr) {
            Some(_) => Ok(expr),
            None if known => Err(self.error("a built-in function has no arguments")),
            None => Err(self.error("a function is called before it is written")),
        }
    }

    /// That the arguments of a built-in function or a cast are such as every target takes.
    fn arguments(&self, name: &str, arguments: &[Expr]) -> Result<(), SubsetError> {
        let kinds: Vec<_> = arguments.iter().map(|argument| self.scope.type_of(argument)).collect();
        let first = arguments.first().filter(|first| !matches!(first, Expr::Number(..)));
        let message = match name {
            "f32" | "u32" if !matches!(kinds[..], [Some(Type::F32 | Type::U32)]) => "takes one number",
            "select" if !matches!(&kinds[..], [no, yes, Some(Type::Bool)] if no == yes) => {
                "takes two alike and a bool"
            }
            "f32" | "u32" | "select" => return Ok(()),
            _ if !BUILT_IN.contains(&name) => return Ok(()),
            _ if kinds.iter().any(|kind| *kind != Some(Type::F32)) => "takes f32",
            _ if first.is_some_and(is_nameless) => "of numbers alone: write its value",
            _ => return Ok(()),
        };
        Err(self.error(format!("`{name}` {message}")))
    }
}

/// A number that every target reads alike: `12u`; or `1.5`, `1e-7`, finite in single precision and not lost to 0.
fn number(text: &str) -> Option<Expr> {
    if let Some(digits) = text.strip_suffix('u') {
        let octal = digits.len() > 1 && digits.starts_with('0');
        let plain = digits.parse::<u32>().is_ok() && !octal;
        return plain.then(|| Expr::Number(digits.to_owned(), Type::U32));
    }
    let value = text.parse::<f32>().ok().filter(|value| value.is_finite())?;
    let mantissa = text.split('e').next()?;
    let lost = value == 0.0 && mantissa.contains(|c: char| ('1'..='9').contains(&c));
    let float = text.contains(['.', 'e']) && !mantissa.ends_with('.');
    (float && !lost).then(|| Expr::Number(text.to_owned(), Type::F32))
}
