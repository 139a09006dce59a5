//! What is compared.

use stratiform_artifact::ChartRow;
use stratiform_quantities::Side;

/// A quantity of the chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// Reflectance factor of light that leaves a face.
    Radiance(Side),
    /// R.
    Reflectance,
    /// T.
    Transmittance,
}

impl Quantity {
    /// All, in the order of tables.
    pub const ALL: [Self; 4] =
        [Self::Radiance(Side::Top), Self::Radiance(Side::Bottom), Self::Reflectance, Self::Transmittance];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        let place = Self::ALL.iter().position(|one| *one == self).unwrap_or_default();
        ChartRow::QUANTITIES[place]
    }

    /// Whether it is a radiance.
    pub fn is_radiance(self) -> bool {
        matches!(self, Self::Radiance(_))
    }
}
