//! Scattering orders as they stand in tables: a number, the tail beyond the last one, or the total.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::fmt;

/// Which scattering events a flux counts. Serialised as a number, `"tail"` or `"total"`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Order {
    /// Light scattered exactly this many times; 0 is unscattered light.
    Exactly(u32),
    /// Light scattered more often than the largest order listed.
    Tail,
    /// All light, unscattered included.
    Total,
}

impl Order {
    /// 0, 1 … `max`, tail, total: the rows of one result.
    pub fn rows(max: u32) -> impl Iterator<Item = Order> {
        (0..=max).map(Order::Exactly).chain([Order::Tail, Order::Total])
    }
}

impl fmt::Display for Order {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Order::Exactly(n) => write!(f, "{n}"),
            Order::Tail => f.write_str("tail"),
            Order::Total => f.write_str("total"),
        }
    }
}

impl std::str::FromStr for Order {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "tail" => Ok(Order::Tail),
            "total" => Ok(Order::Total),
            number => number
                .parse()
                .map(Order::Exactly)
                .map_err(|_| format!("order `{text}` is neither a whole number, `tail` nor `total`")),
        }
    }
}

impl Serialize for Order {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Order::Exactly(n) => serializer.serialize_u32(*n),
            other => serializer.collect_str(other),
        }
    }
}

impl<'de> Deserialize<'de> for Order {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl de::Visitor<'_> for Visitor {
            type Value = Order;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a scattering order, `tail` or `total`")
            }
            fn visit_u64<E: de::Error>(self, n: u64) -> Result<Order, E> {
                u32::try_from(n).map(Order::Exactly).map_err(E::custom)
            }
            fn visit_str<E: de::Error>(self, text: &str) -> Result<Order, E> {
                text.parse().map_err(E::custom)
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_round_trip_through_json() {
        for order in Order::rows(3) {
            let text = serde_json::to_string(&order).unwrap();
            assert_eq!(serde_json::from_str::<Order>(&text).unwrap(), order, "{text}");
        }
        assert_eq!(serde_json::to_string(&Order::Exactly(2)).unwrap(), "2");
        assert_eq!(serde_json::to_string(&Order::Total).unwrap(), "\"total\"");
    }

    #[test]
    fn anything_else_is_refused() {
        for text in ["-1", "\"all\"", "1.5", "null"] {
            assert!(serde_json::from_str::<Order>(text).is_err(), "{text}");
        }
    }
}
