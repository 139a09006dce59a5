//! What clear air consists of.
//!
//! Molecules: τ of the whole column by B. A. Bodhaine, N. B. Wood, E. G. Dutton & J. R. Slusser, J. Atmos. Oceanic Technol. 16, 1854 (1999),
//! equation 30, exponential in height; scalar Rayleigh scattering. Ozone: absorption in a thin shell, coefficients as M. Iqbal, An Introduction to Solar
//! Radiation (1983), prints them (`reference-data/ozone-iqbal-1983`). Aerosol: τ ∝ λ^-1.3, exponential in height, Henyey–Greenstein;
//! its amount from the turbidity T = (τ_molecules + τ_aerosol)/τ_molecules at 0.55 µm. T = 1 is pure air, 2 very clear, 5 hazy.

use super::chapman::air_mass;
use crate::WorldError;
use stratiform_quantities::Range;

/// λ at which skies are computed, µm.
pub(super) const WAVELENGTHS_UM: [f64; 9] = [0.39, 0.43, 0.47, 0.51, 0.55, 0.59, 0.63, 0.67, 0.71];

/// Ozone's absorption at those, 1/cm at normal pressure and temperature.
pub(super) const OZONE_PER_CM: [f64; 9] = [0.0, 0.0, 0.009, 0.04, 0.085, 0.115, 0.09, 0.048, 0.018];

/// Ångström's exponent.
const ANGSTROM: f64 = 1.3;

/// A clear atmosphere. Lengths in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Air {
    /// T, 1 to 10.
    pub turbidity: f64,
    /// Albedo of the ground below, the same in all directions and colours.
    pub ground_albedo: f64,
    /// Where the sky is seen from.
    pub altitude_m: f64,
    /// Of the earth.
    pub radius_m: f64,
    /// Over which molecules thin out by e.
    pub molecules_height_m: f64,
    /// Over which aerosol does.
    pub aerosol_height_m: f64,
    /// Aerosol's ω.
    pub aerosol_albedo: f64,
    /// Aerosol's g.
    pub aerosol_asymmetry: f64,
    /// Ozone's column at normal pressure and temperature, cm.
    pub ozone_cm: f64,
    /// Altitude of its shell.
    pub ozone_height_m: f64,
}

impl Default for Air {
    /// Very clear air over a dark earth, seen from 2 km.
    fn default() -> Self {
        Self {
            turbidity: 2.0,
            ground_albedo: 0.2,
            altitude_m: 2000.0,
            radius_m: 6.371e6,
            molecules_height_m: 8000.0,
            aerosol_height_m: 1200.0,
            aerosol_albedo: 0.95,
            aerosol_asymmetry: 0.7,
            ozone_cm: 0.3,
            ozone_height_m: 22_000.0,
        }
    }
}

/// Optical thicknesses from the ground to space at one wavelength.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    pub molecules: f64,
    pub aerosol: f64,
    pub ozone: f64,
}

impl Air {
    /// Optical thickness of the molecules from sea level to space.
    pub fn molecules_thickness(wavelength_um: f64) -> f64 {
        molecules(wavelength_um)
    }

    /// Of aerosol's extinction what counts where light that it scatters is taken as unscattered with probability g: 1 - ωg.
    pub(super) fn similar_share(&self) -> f64 {
        1.0 - self.aerosol_albedo * self.aerosol_asymmetry
    }

    pub(super) fn check(&self) -> Result<(), WorldError> {
        let heights = Range::closed(100.0, 20_000.0);
        let checks = [
            ("turbidity", self.turbidity, Range::closed(1.0, 10.0)),
            ("ground_albedo", self.ground_albedo, Range::closed(0.0, 1.0)),
            ("altitude_m", self.altitude_m, Range::closed(0.0, 20_000.0)),
            ("radius_m", self.radius_m, Range::closed(1e6, 1e13)),
            ("molecules_height_m", self.molecules_height_m, heights),
            ("aerosol_height_m", self.aerosol_height_m, heights),
            ("aerosol_albedo", self.aerosol_albedo, Range::closed(0.0, 1.0)),
            ("aerosol_asymmetry", self.aerosol_asymmetry, Range::closed(0.0, 0.9)),
            ("ozone_cm", self.ozone_cm, Range::closed(0.0, 1.0)),
            ("ozone_height_m", self.ozone_height_m, Range::closed(20_000.0, 30_000.0)),
        ];
        checks.into_iter().try_for_each(|(name, value, range)| Ok(range.check(name, value).map(drop)?))
    }

    /// The columns at each of [`WAVELENGTHS_UM`].
    pub(super) fn columns(&self) -> [Columns; WAVELENGTHS_UM.len()] {
        std::array::from_fn(|k| {
            let wavelength = WAVELENGTHS_UM[k];
            let aerosol = (self.turbidity - 1.0) * molecules(0.55) * libm::pow(wavelength / 0.55, -ANGSTROM);
            Columns { molecules: molecules(wavelength), aerosol, ozone: self.ozone_cm * OZONE_PER_CM[k] }
        })
    }
}

/// Columns of a path over the vertical ones of the whole atmosphere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slant {
    molecules: f64,
    aerosol: f64,
    ozone: f64,
}

impl Slant {
    /// From `altitude_m` to space, `mu` to the vertical; none where the ground is in the way.
    pub(super) fn new(air: &Air, altitude_m: f64, mu: f64) -> Option<Self> {
        let radius = air.radius_m + altitude_m;
        let of =
            |height: f64| Some(libm::exp(-altitude_m / height) * air_mass(radius, air.radius_m, height, mu)?);
        let [molecules, aerosol] = [of(air.molecules_height_m)?, of(air.aerosol_height_m)?];
        let below = altitude_m < air.ozone_height_m;
        Some(Self { molecules, aerosol, ozone: if below { ozone_mass(air, radius, mu) } else { 0.0 } })
    }

    /// Optical thickness, of which aerosol counts with `share`.
    pub(super) fn thickness(&self, columns: &Columns, share: f64) -> f64 {
        columns.molecules * self.molecules
            + share * columns.aerosol * self.aerosol
            + columns.ozone * self.ozone
    }
}

/// The secant at which a path from below crosses the ozone's shell.
pub(super) fn ozone_mass(air: &Air, radius: f64, mu: f64) -> f64 {
    let ratio = radius / (air.radius_m + air.ozone_height_m);
    1.0 / (1.0 - ratio * ratio * (1.0 - mu * mu)).sqrt()
}

/// τ of the molecules at sea level.
fn molecules(wavelength_um: f64) -> f64 {
    let square = wavelength_um * wavelength_um;
    0.002_152 * (1.045_599_6 - 341.290_61 / square - 0.902_308_5 * square)
        / (1.0 + 0.002_705_988_9 / square - 85.968_563 * square)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// J. E. Hansen & L. D. Travis, Space Sci. Rev. 16, 527 (1974), equation 2.30, fitted to other measurements.
    #[test]
    fn molecules_have_their_published_thickness() {
        for wavelength in WAVELENGTHS_UM {
            let w = 1.0 / (wavelength * wavelength);
            let expected = 0.008_569 * w * w * (1.0 + 0.0113 * w + 0.000_13 * w * w);
            assert!(
                (molecules(wavelength) / expected - 1.0).abs() < 0.01,
                "{wavelength}: {}",
                molecules(wavelength)
            );
        }
    }

    #[test]
    fn ozone_is_the_transcribed_one() {
        let text = stratiform_reference_data::read("ozone-iqbal-1983", "absorption.csv").unwrap();
        let rows: Vec<[f64; 2]> = text
            .lines()
            .skip(1)
            .map(|line| {
                let (nm, k) = line.split_once(',').unwrap();
                [nm.parse().unwrap(), k.parse().unwrap()]
            })
            .collect();
        for (wavelength, k) in WAVELENGTHS_UM.iter().zip(OZONE_PER_CM) {
            let listed = rows.iter().find(|row| (row[0] - 1000.0 * wavelength).abs() < 0.5);
            // Between 0.355 and 0.445 µm the table has a gap: no absorption.
            assert_eq!(listed.map_or(0.0, |row| row[1]), k, "{wavelength}");
        }
    }

    #[test]
    fn what_is_no_air_is_refused() {
        let clear = Air::default();
        let wrong = [
            Air { turbidity: 0.9, ..clear },
            Air { turbidity: f64::NAN, ..clear },
            Air { ground_albedo: 1.1, ..clear },
            Air { altitude_m: -1.0, ..clear },
            Air { aerosol_asymmetry: 1.0, ..clear },
        ];
        assert!(clear.check().is_ok());
        for air in wrong {
            assert!(air.check().unwrap_err().to_string().contains(" is outside ["), "{air:?}");
        }
    }
}
