//! What is wrong under which key, before anybody knows the line.

use crate::{Interval, SceneError};
use stratiform_artifact::key_line;
use stratiform_quantities::{DomainError, Range};

pub(crate) enum Fault {
    Domain(DomainError),
    Inverted(String, Interval),
    Contents(String, String),
}

impl Fault {
    pub fn contents(key: &str, message: impl Into<String>) -> Self {
        Self::Contents(key.to_owned(), message.into())
    }

    pub fn at(self, text: &str, origin: &str) -> SceneError {
        let place = |key: &str| format!("{origin}:{}", line(text, key));
        match self {
            Self::Domain(source) => SceneError::Domain { place: place(&source.quantity), source },
            Self::Inverted(key, Interval { min, max }) => {
                SceneError::Inverted { place: place(&key), key, min, max }
            }
            Self::Contents(key, message) => SceneError::Contents { place: place(&key), message },
        }
    }
}

impl From<DomainError> for Fault {
    fn from(error: DomainError) -> Self {
        Self::Domain(error)
    }
}

/// The line of the key, or of its table.
fn line(text: &str, key: &str) -> usize {
    let table = || {
        let header = format!("[{}]", key.split('.').next().unwrap_or_default());
        text.lines().position(|line| line.trim_start().starts_with(&header)).map(|index| index + 1)
    };
    key_line(text, key).or_else(table).unwrap_or(1)
}

pub(crate) fn check_interval(key: &str, interval: &Interval, range: Range) -> Result<(), Fault> {
    if interval.min.to_bits() == interval.max.to_bits() {
        range.check(key, interval.min)?;
        return Ok(());
    }
    range.check(&format!("{key}.min"), interval.min)?;
    range.check(&format!("{key}.max"), interval.max)?;
    if interval.max < interval.min { Err(Fault::Inverted(key.to_owned(), *interval)) } else { Ok(()) }
}

pub(crate) fn check_optional(key: &str, value: Option<f64>, range: Range) -> Result<(), Fault> {
    value.map_or(Ok(()), |value| Ok(range.check(key, value).map(drop)?))
}

pub(crate) fn listed_once<T: PartialEq + std::fmt::Debug>(key: &str, list: &[T]) -> Result<(), Fault> {
    if list.is_empty() {
        return Err(Fault::contents(key, format!("{key} is empty: list at least one")));
    }
    match list.iter().enumerate().find(|(i, item)| list[..*i].contains(item)) {
        Some((_, item)) => Err(Fault::contents(key, format!("{key} lists {item:?} twice"))),
        None => Ok(()),
    }
}
