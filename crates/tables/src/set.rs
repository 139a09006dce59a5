//! The phase functions of one cloud that go into one file: functions as rows, wavelengths or colours as channels.

use crate::TablesError;
use crate::card::Card;
use crate::colour::srgb_phase;
use crate::sampled::Sampled;
use crate::write::Precision;
use serde::{Deserialize, Serialize};
use stratiform_artifact::Provenance;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::Range;

/// Which phase function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Function {
    /// P.
    Full,
    /// P_S = P/(1-P_f) for Θ ≥ θ_f and 0 below.
    Modified,
    /// P_S convolved with itself on the sphere.
    Squared,
}

impl Function {
    /// The name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Modified => "modified",
            Self::Squared => "squared",
        }
    }

    /// What the function is, in a line.
    pub fn definition(self) -> &'static str {
        match self {
            Self::Full => "P",
            Self::Modified => {
                "P_S = P/(1 - P_f) for theta >= theta_f, 0 below; sampled, the edge is a ramp of about two \
                               texels: compute P_S from P where the edge matters"
            }
            Self::Squared => "P_S convolved with itself on the sphere",
        }
    }
}

/// What tells the tables of one function apart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Channel {
    /// A wavelength in µm.
    WavelengthUm(f64),
    /// A primary of linear sRGB: `R`, `G` or `B`.
    LinearSrgb(char),
}

impl Channel {
    /// The name in files: `550nm` (`532,5nm`: a dot would make a layer of it in EXR), or `R`, `G`, `B`.
    pub fn name(&self) -> String {
        match self {
            // A wavelength in µm has few digits; 1e-9 nm takes the product's rounding away.
            Self::WavelengthUm(um) => format!("{}nm", (um * 1e12).round() / 1e9).replace('.', ","),
            Self::LinearSrgb(primary) => primary.to_string(),
        }
    }
}

/// Optical properties of the medium in one channel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChannelMedium {
    /// Wavelength.
    pub wavelength_um: f64,
    /// n, k.
    pub refractive_index: [f64; 2],
    /// ω.
    pub single_scattering_albedo: f64,
    /// κ = N0 π r_e², 1/m.
    pub extinction_paper_per_m: f64,
    /// κ = N0 ⟨Q_ext π r²⟩, 1/m.
    pub extinction_mie_per_m: f64,
    /// g of the full function, from the Mie coefficients.
    pub asymmetry: f64,
    /// P_f.
    pub forward_fraction: f64,
}

/// What stands in every file beside the numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct About {
    /// The cloud's name.
    pub title: String,
    /// The droplets' distribution in words.
    pub droplets: String,
    /// r_e.
    pub effective_radius_um: f64,
    /// v_e.
    pub effective_variance: f64,
    /// Droplets per cm³.
    pub number_density_per_cm3: f64,
    /// θ_f in degrees.
    pub theta_f_deg: f64,
    /// One per wavelength.
    pub medium: Vec<ChannelMedium>,
    /// How the tables were made.
    pub provenance: Provenance,
}

/// One function in every channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Which.
    pub function: Function,
    /// One table per channel.
    pub tables: Vec<PhaseTable>,
}

/// Phase functions before sampling.
#[derive(Clone, Debug, PartialEq)]
pub struct PhaseSet {
    /// The channels, in order.
    pub channels: Vec<Channel>,
    /// The functions, in order.
    pub rows: Vec<Row>,
    /// What they are about.
    pub about: About,
}

impl PhaseSet {
    /// The three functions of each channel's P: full, squared, modified.
    ///
    /// # Errors
    /// [`TablesError::Optics`] if θ_f leaves nothing, or if P*P cannot be held by the table's nodes.
    pub fn new(full: Vec<(Channel, PhaseTable)>, about: About) -> Result<Self, TablesError> {
        let theta_f_deg = about.theta_f_deg;
        let (channels, full): (Vec<_>, Vec<_>) = full.into_iter().unzip();
        let modified: Vec<_> =
            full.iter().map(|table| table.modified(theta_f_deg)).collect::<Result<_, _>>()?;
        let squared = modified.iter().map(PhaseTable::squared).collect::<Result<_, _>>()?;
        // The emitted look-up reads P and P_S * P_S in the first two rows.
        let rows = [(Function::Full, full), (Function::Squared, squared), (Function::Modified, modified)];
        let rows = rows.map(|(function, tables)| Row { function, tables }).into();
        Ok(Self { channels, rows, about })
    }

    /// The same functions with the channels R, G, B of linear sRGB.
    ///
    /// # Errors
    /// As [`srgb_phase`]; [`TablesError::Domain`] naming Θ where a colour is outside sRGB's gamut.
    pub fn linear_srgb(&self) -> Result<Self, TablesError> {
        let rows = self.rows.iter().map(|row| {
            let tables = srgb_tables(self.spectrum(row))?;
            Ok(Row { function: row.function, tables })
        });
        let rows = rows.collect::<Result<_, TablesError>>()?;
        Ok(Self {
            channels: ['R', 'G', 'B'].map(Channel::LinearSrgb).to_vec(),
            rows,
            about: self.about.clone(),
        })
    }

    /// A row's tables with their wavelengths, ascending.
    fn spectrum(&self, row: &Row) -> Vec<(f64, PhaseTable)> {
        let wavelength = |channel: &Channel| match channel {
            Channel::WavelengthUm(um) => Some(*um),
            Channel::LinearSrgb(_) => None,
        };
        let pairs = self.channels.iter().zip(&row.tables);
        let mut spectrum: Vec<_> =
            pairs.filter_map(|(channel, table)| Some((wavelength(channel)?, table.clone()))).collect();
        spectrum.sort_by(|a, b| a.0.total_cmp(&b.0));
        spectrum
    }

    /// Every table with `texels` values.
    ///
    /// # Errors
    /// [`TablesError::Domain`] unless 64 ≤ `texels` ≤ 1024.
    pub fn sample(&self, texels: usize) -> Result<SampledSet, TablesError> {
        let row = |row: &Row| row.tables.iter().map(|table| Sampled::new(table, texels)).collect();
        let rows = self.rows.iter().map(row).collect::<Result<Vec<Vec<Sampled>>, _>>()?;
        let functions = self.rows.iter().map(|row| row.function).collect();
        Ok(SampledSet { texels, channels: self.channels.clone(), functions, rows, about: self.about.clone() })
    }

    /// The card of every function and channel of `sampled`, stored with `precision`.
    ///
    /// # Errors
    /// [`TablesError::Domain`] for values that the precision cannot hold.
    pub fn cards(&self, sampled: &SampledSet, precision: Precision) -> Result<Vec<NamedCard>, TablesError> {
        let mut cards = Vec::new();
        for (row, samples) in self.rows.iter().zip(&sampled.rows) {
            for ((channel, table), sample) in self.channels.iter().zip(&row.tables).zip(samples) {
                let stored: Vec<f64> = sample.values.iter().map(|value| precision.stored(*value)).collect();
                cards.push(NamedCard {
                    function: row.function,
                    channel: channel.name(),
                    precision,
                    texels: sampled.texels,
                    scaled_by: sample.scaled_by,
                    card: Card::new(table, &stored)?,
                });
            }
        }
        Ok(cards)
    }
}

/// R, G and B of a spectrum.
fn srgb_tables(spectrum: Vec<(f64, PhaseTable)>) -> Result<Vec<PhaseTable>, TablesError> {
    let colour = srgb_phase(&spectrum)?;
    let (least, theta_deg) = colour.smallest_channel();
    Range::at_least(0.0).check(&format!("channel of linear sRGB at theta_deg = {theta_deg}"), least)?;
    let channel = |c: usize| {
        let p = colour.rgb.iter().map(|rgb| rgb[c]).collect();
        Ok(PhaseTable::new(colour.theta_deg.clone(), p, Norm::Strict)?)
    };
    (0..3).map(channel).collect()
}

/// Phase functions as files hold them.
#[derive(Clone, Debug, PartialEq)]
pub struct SampledSet {
    /// Values of each function and channel.
    pub texels: usize,
    /// The channels, in order.
    pub channels: Vec<Channel>,
    /// The functions, in order.
    pub functions: Vec<Function>,
    /// `rows[function][channel]`.
    pub rows: Vec<Vec<Sampled>>,
    /// What they are about.
    pub about: About,
}

/// A card and what it belongs to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NamedCard {
    /// Which function.
    pub function: Function,
    /// Which channel, by name.
    pub channel: String,
    /// How the container stores numbers.
    pub precision: Precision,
    /// Values of the function.
    pub texels: usize,
    /// What the fitted values were multiplied by.
    pub scaled_by: f64,
    /// The errors.
    #[serde(flatten)]
    pub card: Card,
}

impl NamedCard {
    /// Names of the columns of [`NamedCard::csv`].
    pub fn columns() -> String {
        format!("function,channel,precision,texels,scaled_by,{}", Card::COLUMNS)
    }

    /// The row under [`NamedCard::columns`].
    pub fn csv(&self) -> String {
        let channel =
            if self.channel.contains(',') { format!("\"{}\"", self.channel) } else { self.channel.clone() };
        format!(
            "{},{channel},{},{},{},{}",
            self.function.name(),
            self.precision.name(),
            self.texels,
            self.scaled_by,
            self.card.csv()
        )
    }
}
