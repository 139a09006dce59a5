//! Eradiate's particle radiative properties: netCDF in its format Aer-Core v2.
//!
//! Format as Eradiate 1.2.0 writes and reads it: dimensions `w`, `phamat`, `iangle`, `imom`; coordinates `w` (nm,
//! ascending), `phamat` ("11": no polarisation), `mu` and `theta` (w × iangle, μ ascending from -1 to 1, 1 forward,
//! padded with NaN to the longest); variables `ext` (m⁻¹), `ssa`, `phase` (phamat × w × iangle, ∫p dμ = 2, which is P),
//! `nangles`, `pmom` (w × imom, with the factor 2l+1) and `nmom`. The kernel is linear in μ between nodes
//! (`tabphase_irregular`); nodes are those of the irregular form, different in f32 because the single-precision modes
//! refuse equal ones. The container is classic netCDF (CDF-1).

use super::cosine::OverCosine;
use super::{PeerFile, worth};
use crate::TablesError;
use netcdf_writer::{DimensionId, NcAttrValue, NcFileBuilder, NcWriteOptions, VariableId};
use stratiform_optics::phase::{PhaseFunction, PhaseTable};
use stratiform_quantities::Range;

/// What the file says of one wavelength.
#[derive(Clone, Copy, Debug)]
pub struct Wavelength<'a> {
    /// λ.
    pub wavelength_um: f64,
    /// κ per metre.
    pub extinction_per_m: f64,
    /// ω.
    pub single_scattering_albedo: f64,
    /// P.
    pub phase: &'a PhaseTable,
}

/// Numbers of moments that are written.
pub const MOMENTS: Range = Range::closed(2.0, 32768.0);

/// The file's bytes, with `moments` Legendre coefficients of every wavelength.
///
/// # Errors
/// [`TablesError::Domain`] for no wavelength, wavelengths that do not ascend, a negative extinction, an albedo outside
/// \[0, 1\], or a number of moments outside \[2, 32768\].
pub fn particle_properties(
    spectrum: &[Wavelength<'_>],
    moments: usize,
) -> Result<PeerFile<Vec<u8>>, TablesError> {
    check(spectrum, moments)?;
    let over: Vec<OverCosine> = spectrum.iter().map(|one| OverCosine::irregular(one.phase)).collect();
    let content = dataset(spectrum, &over, moments).map_err(container)?;
    let cards = over.iter().zip(spectrum).map(|(over, one)| over.card(one.phase)).collect();
    let values = over.iter().fold(0, |most, over| most.max(over.mu.len()));
    Ok(PeerFile { content, values, cards })
}

fn check(spectrum: &[Wavelength<'_>], moments: usize) -> Result<(), TablesError> {
    Range::at_least(1.0).check("wavelengths of the data set", spectrum.len() as f64)?;
    MOMENTS.check("moments of the data set", moments as f64)?;
    let mut last = 0.0;
    for one in spectrum {
        last = Range::above(last).check("wavelength_um (ascending)", one.wavelength_um)?;
        Range::at_least(0.0).check("extinction_per_m", one.extinction_per_m)?;
        Range::closed(0.0, 1.0).check("single_scattering_albedo", one.single_scattering_albedo)?;
    }
    Ok(())
}

fn container(error: netcdf_writer::Error) -> TablesError {
    TablesError::Container { format: "netCDF", reason: error.to_string() }
}

fn dataset(
    spectrum: &[Wavelength<'_>],
    over: &[OverCosine],
    moments: usize,
) -> netcdf_writer::Result<Vec<u8>> {
    let angles = over.iter().fold(0, |most, over| most.max(over.mu.len()));
    let mut file = Dataset::default();
    let w = file.dimension("w", spectrum.len())?;
    let phamat = file.dimension("phamat", 1)?;
    let iangle = file.dimension("iangle", angles)?;
    let imom = file.dimension("imom", moments)?;

    let of = |f: fn(&Wavelength<'_>) -> f64| spectrum.iter().map(f).collect::<Vec<_>>();
    file.numbers("w", &[w], &of(|one| 1000.0 * one.wavelength_um), "wavelength", "nm")?;
    file.word("phamat", phamat, "11", "component")?;
    let padded = |f: &dyn Fn(&OverCosine) -> Vec<f64>| -> Vec<f64> {
        over.iter().flat_map(|over| pad(f(over), angles)).collect()
    };
    file.numbers("mu", &[w, iangle], &padded(&|over| over.mu.clone()), "cos_scattering_angle", "1")?;
    file.numbers("theta", &[w, iangle], &padded(&degrees), "scattering_angle", "deg")?;
    file.numbers("ext", &[w], &of(|one| one.extinction_per_m), "extinction_coefficient", "m^-1")?;
    file.numbers("ssa", &[w], &of(|one| one.single_scattering_albedo), "single_scattering_albedo", "1")?;
    file.numbers("phase", &[phamat, w, iangle], &padded(&|over| over.p.clone()), "phase_matrix", "1")?;
    file.counts("nangles", w, over.iter().map(|over| over.mu.len()), "n_angular_samples")?;
    file.counts("nmom", w, spectrum.iter().map(|_| moments), "n_legendre_polys")?;
    let coefficients: Vec<f64> = spectrum.iter().flat_map(|one| coefficients(one.phase, moments)).collect();
    file.numbers("pmom", &[w, imom], &coefficients, "legendre_polys", "1")?;
    file.bytes()
}

fn pad(mut row: Vec<f64>, length: usize) -> Vec<f64> {
    row.resize(length, f64::NAN);
    row
}

fn degrees(over: &OverCosine) -> Vec<f64> {
    over.mu.iter().map(|mu| worth::degrees(*mu)).collect()
}

/// (2l+1)χ_l.
fn coefficients(phase: &PhaseTable, moments: usize) -> Vec<f64> {
    let mut chi = phase.moments(moments);
    chi[0] = 1.0;
    chi.iter().enumerate().map(|(l, chi)| (2 * l + 1) as f64 * chi).collect()
}

/// A data set under construction.
#[derive(Default)]
struct Dataset(NcFileBuilder);

impl Dataset {
    fn dimension(&mut self, name: &str, size: usize) -> netcdf_writer::Result<DimensionId> {
        self.0.add_dimension(name, size as u64)
    }

    fn label(&mut self, variable: VariableId, name: &str, value: &str) -> netcdf_writer::Result<()> {
        self.0.add_variable_attribute(variable, name, NcAttrValue::Chars(value.to_owned()))
    }

    fn numbers(
        &mut self,
        name: &str,
        dimensions: &[DimensionId],
        values: &[f64],
        standard_name: &str,
        units: &str,
    ) -> netcdf_writer::Result<()> {
        let variable = self.0.add_variable::<f64>(name, dimensions)?;
        self.label(variable, "standard_name", standard_name)?;
        self.label(variable, "units", units)?;
        self.0.write_variable(variable, values)
    }

    fn counts(
        &mut self,
        name: &str,
        dimension: DimensionId,
        counts: impl Iterator<Item = usize>,
        standard_name: &str,
    ) -> netcdf_writer::Result<()> {
        let variable = self.0.add_variable::<i32>(name, &[dimension])?;
        self.label(variable, "standard_name", standard_name)?;
        let counts: Vec<i32> = counts.map(|count| count as i32).collect();
        self.0.write_variable(variable, &counts)
    }

    fn word(
        &mut self,
        name: &str,
        dimension: DimensionId,
        word: &str,
        standard_name: &str,
    ) -> netcdf_writer::Result<()> {
        let letters = self.dimension("letters", word.len())?;
        let variable = self.0.add_char_variable(name, &[dimension, letters])?;
        self.label(variable, "standard_name", standard_name)?;
        self.0.write_char_variable(variable, word.as_bytes())
    }

    fn bytes(mut self) -> netcdf_writer::Result<Vec<u8>> {
        let about = "Single-scattering properties of droplets, Aer-Core v2: phase integrates to 2 over mu, pmom includes 2l+1";
        self.0.add_attribute("title", NcAttrValue::Chars(about.to_owned()))?;
        Ok(self.0.to_vec(NcWriteOptions::default())?.1)
    }
}
