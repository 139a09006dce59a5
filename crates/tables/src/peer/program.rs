//! A cloud's files for one program: the full P at every wavelength of a [`PhaseSet`], or the whole cloud in one file.

use super::{PeerFile, bevy, disort, eradiate, mcx, mitsuba};
use crate::TablesError;
use crate::colour::srgb_phase;
use crate::set::{Channel, ChannelMedium, Function, NamedCard, PhaseSet};
use crate::write::{Precision, texels_ktx2};
use stratiform_optics::phase::PhaseTable;

/// Values of `tabphase`: 2¹⁶ + 1 hold the peak of the paper's cloud to a percent.
const TABPHASE_VALUES: usize = (1 << 16) + 1;

/// Values of MCX's inverse distribution.
const MCX_VALUES: usize = 1022;

/// Columns of Bevy's texture, as many as there can be, and the `phase_resolution` that its card is about.
const BEVY: [usize; 2] = [8192, 1024];

/// Who reads the files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    /// Mitsuba 3, `tabphase`.
    Mitsuba,
    /// Eradiate's kernel, `tabphase_irregular`.
    MitsubaIrregular,
    /// Eradiate, Aer-Core v2.
    Eradiate,
    /// MCX and MCX-CL.
    Mcx,
    /// DISORT.
    Disort,
    /// Bevy, linear sRGB.
    Bevy,
}

/// A file with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedFile {
    /// The name.
    pub name: String,
    /// The content.
    pub bytes: Vec<u8>,
    /// What its reader's look-up is worth.
    pub cards: Vec<NamedCard>,
}

impl Program {
    /// The program's files.
    ///
    /// # Errors
    /// [`TablesError`] for what the program cannot represent.
    pub fn files(self, set: &PhaseSet) -> Result<Vec<NamedFile>, TablesError> {
        let each = |ending: &str, write: &dyn Fn(&PhaseTable) -> Result<PeerFile<String>, TablesError>| {
            let file = |(channel, table): (&Channel, &PhaseTable)| text_file(channel, ending, write(table)?);
            full(set).map(file).collect()
        };
        match self {
            Self::Mitsuba => each("tabphase.xml", &|table| mitsuba::tabphase(table, TABPHASE_VALUES)),
            Self::MitsubaIrregular => each("irregular.xml", &|table| Ok(mitsuba::tabphase_irregular(table))),
            Self::Mcx => each("mcx.json", &|table| mcx::inverse_cdf(table, MCX_VALUES)),
            Self::Disort => each("pmom.txt", &|table| disort::pmom(table, disort::moments_for(table))),
            Self::Eradiate => Ok(vec![eradiate_file(set)?]),
            Self::Bevy => Ok(vec![bevy_file(set)?]),
        }
    }
}

/// The full function in every channel.
fn full(set: &PhaseSet) -> impl Iterator<Item = (&Channel, &PhaseTable)> {
    let rows = set.rows.iter().filter(|row| row.function == Function::Full);
    rows.flat_map(|row| set.channels.iter().zip(&row.tables))
}

/// The same with the medium, ascending in wavelength.
fn spectrum(set: &PhaseSet) -> Vec<(&ChannelMedium, &PhaseTable)> {
    let mut spectrum: Vec<_> = set.about.medium.iter().zip(full(set).map(|(_, table)| table)).collect();
    spectrum.sort_by(|a, b| a.0.wavelength_um.total_cmp(&b.0.wavelength_um));
    spectrum
}

fn text_file(channel: &Channel, ending: &str, file: PeerFile<String>) -> Result<NamedFile, TablesError> {
    let name = channel.name();
    let cards = cards(&file, std::slice::from_ref(&name), Precision::F32);
    Ok(NamedFile { name: format!("phase.{name}.{ending}"), bytes: file.content.into_bytes(), cards })
}

fn cards<T>(file: &PeerFile<T>, channels: &[String], precision: Precision) -> Vec<NamedCard> {
    let named = |(channel, card): (&String, &crate::card::Card)| NamedCard {
        function: Function::Full,
        channel: channel.clone(),
        precision,
        texels: file.values,
        scaled_by: 1.0,
        card: *card,
    };
    channels.iter().zip(&file.cards).map(named).collect()
}

fn eradiate_file(set: &PhaseSet) -> Result<NamedFile, TablesError> {
    let spectrum = spectrum(set);
    let names: Vec<String> =
        spectrum.iter().map(|(medium, _)| Channel::WavelengthUm(medium.wavelength_um).name()).collect();
    let moments = spectrum.iter().fold(0, |most, (_, table)| most.max(disort::moments_for(table)));
    let wavelengths: Vec<eradiate::Wavelength<'_>> = spectrum
        .iter()
        .map(|(medium, phase)| eradiate::Wavelength {
            wavelength_um: medium.wavelength_um,
            extinction_per_m: medium.extinction_mie_per_m,
            single_scattering_albedo: medium.single_scattering_albedo,
            phase,
        })
        .collect();
    let file = eradiate::particle_properties(&wavelengths, moments)?;
    let cards = cards(&file, &names, Precision::F64);
    Ok(NamedFile { name: "particles.nc".to_owned(), bytes: file.content, cards })
}

fn bevy_file(set: &PhaseSet) -> Result<NamedFile, TablesError> {
    let spectrum: Vec<(f64, PhaseTable)> =
        spectrum(set).into_iter().map(|(medium, table)| (medium.wavelength_um, table.clone())).collect();
    let [columns, resolution] = BEVY;
    let file = bevy::chromatic_texture(&srgb_phase(&spectrum)?, columns, resolution)?;
    let cards = cards(&file, &["R", "G", "B"].map(str::to_owned), Precision::F32);
    let texels: Vec<f64> = file.content.iter().flatten().map(|value| f64::from(*value)).collect();
    let about = format!(
        "Phase function per steradian in linear sRGB, D65 white, over the cosine of the scattering angle from -1 to 1; \
         set phase_resolution to {resolution}"
    );
    Ok(NamedFile { name: "phase.bevy.ktx2".to_owned(), bytes: texels_ktx2(columns, texels, &about)?, cards })
}
