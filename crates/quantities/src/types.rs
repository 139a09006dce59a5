//! Checked numbers. Constructors refuse what is out of domain; kernels work on the plain `f64` inside.

use crate::{DomainError, Range};
use serde::{Deserialize, Serialize};
use std::fmt;

macro_rules! quantity {
    ($(#[$doc:meta])* $name:ident, $label:literal, $range:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize, Deserialize)]
        #[serde(try_from = "f64", into = "f64")]
        pub struct $name(f64);

        impl $name {
            /// The values this quantity may have.
            pub const RANGE: Range = $range;

            /// Checks `value`.
            ///
            /// # Errors
            /// [`DomainError`] if it is not finite or outside [`Self::RANGE`].
            pub fn new(value: f64) -> Result<Self, DomainError> {
                // Adding zero makes -0 and 0 one value, in text and in hashes too.
                Self::RANGE.check($label, value).map(|value| Self(value + 0.0))
            }

            /// The number.
            pub const fn get(self) -> f64 {
                self.0
            }
        }

        impl TryFrom<f64> for $name {
            type Error = DomainError;
            fn try_from(value: f64) -> Result<Self, DomainError> {
                Self::new(value)
            }
        }

        impl From<$name> for f64 {
            fn from(quantity: $name) -> f64 {
                quantity.0
            }
        }
    };
}

quantity!(
    /// Extinction optical thickness of the full medium along the slab's normal, τ = κH. The upper end is
    /// where the number of scatterings in a lossless slab (2τ on average) stops being computable.
    OpticalThickness, "tau", Range::closed(0.0, 1e6)
);
quantity!(
    /// Single-scattering albedo ω: the share of extinction that is scattering.
    SingleScatteringAlbedo, "omega", Range::closed(0.0, 1.0)
);
quantity!(
    /// Asymmetry parameter g, the mean of cosΘ.
    Asymmetry, "g", Range::open(-1.0, 1.0)
);
quantity!(
    /// Cosine of the zenith angle of incident light, μ0.
    CosZenith, "mu0", Range::closed(0.0, 1.0)
);

impl SingleScatteringAlbedo {
    /// Nothing is absorbed.
    pub const CONSERVATIVE: Self = Self(1.0);
}

/// How the slab is lit from above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Incidence {
    /// A parallel beam.
    Beam(CosZenith),
    /// Uniform radiance from the whole upper hemisphere; μ0 has density 2μ0.
    Diffuse,
}

impl Incidence {
    /// A beam whose zenith angle has cosine `mu0`.
    ///
    /// # Errors
    /// [`DomainError`] unless 0 ≤ `mu0` ≤ 1.
    pub fn beam(mu0: f64) -> Result<Self, DomainError> {
        CosZenith::new(mu0).map(Self::Beam)
    }
}

impl fmt::Display for Incidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Incidence::Beam(mu0) => write!(f, "{}", mu0.get()),
            Incidence::Diffuse => f.write_str("diffuse"),
        }
    }
}

impl std::str::FromStr for Incidence {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "diffuse" {
            return Ok(Incidence::Diffuse);
        }
        let mu0: f64 =
            text.parse().map_err(|_| format!("mu0 `{text}` is neither a number in [0, 1] nor `diffuse`"))?;
        Incidence::beam(mu0).map_err(|error| error.to_string())
    }
}

/// Serialised as a number or `"diffuse"`.
impl Serialize for Incidence {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Incidence::Beam(mu0) => mu0.serialize(serializer),
            Incidence::Diffuse => serializer.serialize_str("diffuse"),
        }
    }
}

impl<'de> Deserialize<'de> for Incidence {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Text {
            Number(f64),
            Word(String),
        }
        match Text::deserialize(deserializer)? {
            Text::Number(mu0) => Incidence::beam(mu0).map_err(serde::de::Error::custom),
            Text::Word(word) => word.parse().map_err(serde::de::Error::custom),
        }
    }
}

/// Which medium light is traced through; see the conventions of the [crate].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Medium {
    /// κ and P as they are.
    Full,
    /// κ_S and P_S: scattering by less than θ_f counts as no scattering.
    Modified,
}

impl fmt::Display for Medium {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Medium::Full => "full",
            Medium::Modified => "modified",
        })
    }
}

/// Which extinction per metre a thickness in metres refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ExtinctionConvention {
    /// κ = N0 π r_e², as in Bouthors, Neyret & Lefebvre 2006, section 3.1.
    Paper,
    /// κ = N0 ⟨Q_ext π r²⟩, the physical extinction.
    Mie,
}

impl fmt::Display for ExtinctionConvention {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ExtinctionConvention::Paper => "paper",
            ExtinctionConvention::Mie => "mie",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn out_of_domain_is_refused() {
        assert!(OpticalThickness::new(-1e-300).is_err());
        assert!(OpticalThickness::new(f64::NAN).is_err());
        assert!(SingleScatteringAlbedo::new(1.0 + f64::EPSILON).is_err());
        assert!(Asymmetry::new(1.0).is_err() && Asymmetry::new(-0.999).is_ok());
        assert!(CosZenith::new(0.0).is_ok() && CosZenith::new(1.0).is_ok() && CosZenith::new(-0.1).is_err());
    }

    #[test]
    fn incidence_is_a_number_or_the_word_diffuse() {
        for text in ["0", "0.5", "1", "diffuse"] {
            let incidence: Incidence = text.parse().unwrap();
            let json = serde_json::to_string(&incidence).unwrap();
            assert_eq!(serde_json::from_str::<Incidence>(&json).unwrap(), incidence);
        }
        for text in ["1.5", "-0.1", "nan", "inf", "Diffuse", ""] {
            assert!(text.parse::<Incidence>().is_err(), "{text}");
        }
    }

    #[test]
    fn names_are_those_of_the_artifacts() {
        assert_eq!(serde_json::to_string(&ExtinctionConvention::Paper).unwrap(), "\"paper\"");
        assert_eq!(Medium::Modified.to_string(), "modified");
    }
}
