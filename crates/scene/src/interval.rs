//! A range of a quantity that a scene covers.

use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

/// From `min` to `max`, both included; they may be equal, and then one number may be written for both.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Interval {
    /// Lower end.
    pub min: f64,
    /// Upper end.
    pub max: f64,
}

impl Interval {
    /// One value.
    pub const fn at(value: f64) -> Self {
        Self { min: value, max: value }
    }

    /// The value, if there is but one.
    pub fn single(&self) -> Option<f64> {
        (self.min == self.max).then_some(self.min)
    }

    /// `count` values from end to end in equal steps; one value where both ends are the same, the middle for a count of one.
    pub fn linear(&self, count: usize) -> Vec<f64> {
        self.spaced(count, |share| self.min + share * (self.max - self.min))
    }

    /// The same in equal ratios, for a positive lower end: `ratio` is max/min raised to a share.
    pub fn geometric(&self, count: usize, power: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        self.spaced(count, |share| self.min * power(self.max / self.min, share))
    }

    /// Whether `value` lies between the ends.
    pub fn contains(&self, value: f64) -> bool {
        (self.min..=self.max).contains(&value)
    }

    fn spaced(&self, count: usize, at: impl Fn(f64) -> f64) -> Vec<f64> {
        if self.min == self.max {
            return vec![self.min];
        }
        if count < 2 {
            return vec![at(0.5)];
        }
        let last = count - 1;
        let inside = (1..last).map(|i| at(i as f64 / last as f64));
        std::iter::once(self.min).chain(inside).chain([self.max]).collect()
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Ends {
    min: f64,
    max: f64,
}

struct NumberOrEnds;

impl<'de> Visitor<'de> for NumberOrEnds {
    type Value = Interval;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a number or { min = .., max = .. }")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Interval, E> {
        Ok(Interval::at(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Interval, E> {
        Ok(Interval::at(value as f64))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Interval, A::Error> {
        let Ends { min, max } = Ends::deserialize(MapAccessDeserializer::new(map))?;
        Ok(Interval { min, max })
    }
}

impl<'de> Deserialize<'de> for Interval {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberOrEnds)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_exact_and_steps_equal() {
        let tens = Interval { min: 10.0, max: 40.0 };
        assert_eq!(tens.linear(4), [10.0, 20.0, 30.0, 40.0]);
        assert_eq!(tens.linear(1), [25.0]);
        assert_eq!(Interval { min: 3.0, max: 3.0 }.linear(4), [3.0]);
        let squares = Interval { min: 1.0, max: 4.0 };
        assert_eq!(
            squares.geometric(3, |ratio, share| if share == 0.5 { ratio.sqrt() } else { f64::NAN }),
            [1.0, 2.0, 4.0]
        );
        assert!(tens.contains(10.0) && !tens.contains(9.9));
        assert_eq!((tens.single(), Interval::at(2.0).single()), (None, Some(2.0)));
    }
}
