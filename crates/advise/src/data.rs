//! The error data, with a lattice for each block.

use crate::lattice::Lattice;
use crate::{AdviseError, Ask};
use std::collections::BTreeMap;
use std::path::Path;
use stratiform_artifact::{ErrorBlock, ErrorData, ErrorMethod, ErrorRow, ErrorTable};
use stratiform_quantities::{Range, Side};
use stratiform_scene::{Effect, Interval, Scene};

/// v_e of the data's droplets.
const VARIANCE: f64 = 0.25;

/// v_e of scenes that they may stand for, with a warning.
const VARIANCES: Interval = Interval { min: 0.03, max: 0.35 };

/// The peaks: errors inside them are not those of their neighbourhood.
const AUREOLE_DEG: f64 = 20.0;
const GLORY_DEG: f64 = 174.0;

/// Nearer ones need no warning.
const VARIANCE_NEAR: f64 = 0.02;

/// Wavelengths whose errors the data stand for.
const VISIBLE_UM: Interval = Interval { min: 0.44, max: 0.66 };

/// Errors of every listed method, ready to be asked.
pub struct Data {
    pub(crate) tables: ErrorData,
    errors: BTreeMap<ErrorBlock, Lattice>,
    colour: BTreeMap<ErrorBlock, Lattice>,
}

/// A value between nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Value {
    Known(f64),
    /// The method gives no answer at a node.
    Refused,
    /// No node near has a truth.
    Unknown,
}

impl Data {
    /// The data that come with the program.
    ///
    /// # Errors
    /// [`AdviseError::Artifact`] if they are damaged.
    pub fn committed() -> Result<Self, AdviseError> {
        let [methods, errors, colour] = [
            include_str!("../../../fit-configs/chart/methods.csv"),
            include_str!("../../../fit-configs/chart/errors.csv"),
            include_str!("../../../fit-configs/chart/colour.csv"),
        ];
        let origin = Path::new("fit-configs/chart");
        let methods = stratiform_artifact::parse_csv(methods, &origin.join("methods.csv"))?;
        let table = |text, name| ErrorTable::parse(text, &origin.join(name));
        let (errors, colour) = (table(errors, "errors.csv")?, table(colour, "colour.csv")?);
        Self::new(ErrorData::new(methods, errors, colour, &origin.join("errors.csv"))?)
    }

    /// A folder that `stratiform errors` wrote.
    ///
    /// # Errors
    /// [`AdviseError::Artifact`] with file and line.
    pub fn load(folder: &Path) -> Result<Self, AdviseError> {
        Self::new(ErrorData::read(folder)?)
    }

    /// Puts lattices over the tables.
    ///
    /// # Errors
    /// [`AdviseError::Missing`] if a block has no rows.
    pub fn new(tables: ErrorData) -> Result<Self, AdviseError> {
        let (errors, colour) = (lattices(&tables.errors), lattices(&tables.colour));
        let all = [
            ErrorBlock::Grid,
            ErrorBlock::Glory,
            ErrorBlock::Fogbow,
            ErrorBlock::SilverLining,
            ErrorBlock::Flux,
        ];
        match all.into_iter().find(|block| !errors.contains_key(block)) {
            Some(block) => Err(AdviseError::Missing { block: format!("{block:?}").to_lowercase() }),
            None => Ok(Self { tables, errors, colour }),
        }
    }

    /// The listed methods.
    pub fn methods(&self) -> &[ErrorMethod] {
        &self.tables.methods
    }

    /// The tables.
    pub fn tables(&self) -> &ErrorData {
        &self.tables
    }

    /// The ends of r_e, thickness, sun and view.
    pub(crate) fn bounds(&self) -> [Interval; 4] {
        let ends = |axis: &[f64], raw: fn(f64) -> f64| Interval {
            min: axis.first().map_or(0.0, |x| raw(*x)),
            max: axis.last().map_or(0.0, |x| raw(*x)),
        };
        let grid = &self.errors[&ErrorBlock::Grid];
        let power = |x: f64| (libm::exp(x) * 1e6).round() / 1e6;
        [
            ends(grid.axis(0), power),
            ends(grid.axis(1), power),
            ends(grid.axis(2), |x| x),
            ends(grid.axis(3), |x| x),
        ]
    }

    /// The nodes of r_e.
    pub(crate) fn radii(&self) -> Vec<f64> {
        self.errors[&ErrorBlock::Grid].axis(0).iter().map(|x| (libm::exp(*x) * 1e6).round() / 1e6).collect()
    }

    /// The suns of R and T.
    pub(crate) fn flux_suns(&self) -> &[f64] {
        self.errors[&ErrorBlock::Flux].axis(2)
    }

    /// Refuses what the data do not cover: r_e, thickness, sun, view, and absorption.
    ///
    /// # Errors
    /// [`AdviseError::Domain`].
    pub(crate) fn check(&self, scene: &Scene, tau: Interval) -> Result<(), AdviseError> {
        let [radius, thickness, sun, view] = self.bounds();
        let inside = |name: &str, asked: Interval, known: Interval| {
            let range = Range::closed(known.min, known.max);
            range.check(&format!("{name}.min"), asked.min)?;
            range.check(&format!("{name}.max"), asked.max).map(|_| ())
        };
        inside("droplets.effective_radius_um", scene.droplets.effective_radius_um, radius)?;
        inside("optical thickness", tau, thickness)?;
        inside("sun.theta_deg", scene.sun.theta_deg, sun)?;
        inside("view.theta_deg", scene.view.theta_deg, view)?;
        let variance = scene.droplets.effective_variance;
        Range::closed(VARIANCES.min, VARIANCES.max).check("droplets.effective_variance", variance)?;
        if let Some(omega) = scene.droplets.single_scattering_albedo {
            Range::closed(0.9999, 1.0).check("droplets.single_scattering_albedo", omega.get())?;
        }
        Ok(())
    }

    /// What of the scene the promise does not cover.
    pub(crate) fn notes(&self, scene: &Scene, unseen: &[Effect]) -> Vec<String> {
        let mut notes: Vec<String> = unseen
            .iter()
            .map(|effect| format!("{effect:?} is listed as visible, but no direction in the ranges shows it"))
            .collect();
        let variance = scene.droplets.effective_variance;
        if (variance - VARIANCE).abs() > VARIANCE_NEAR {
            notes.push(format!(
                "WARNING: the errors were found at droplets of effective variance {VARIANCE}; the scene's is {variance}, for which \
                 they are a guess, above all in bow and glory"
            ));
        }
        if scene.wavelengths_um.iter().any(|wavelength| !VISIBLE_UM.contains(*wavelength)) {
            notes.push("the errors are those at 0.55 um, the colours those of 0.65 and 0.45 um".to_owned());
        }
        notes
    }

    /// What `size` makes of column `column` of `errors.csv` there; nodes that the method refuses are left out. Sizes are interpolated,
    /// not signed errors, which would cancel.
    pub(crate) fn size(
        &self,
        nodes: &[(usize, f64)],
        column: usize,
        size: impl Fn(f64) -> f64,
    ) -> Option<f64> {
        let share = |row: usize| self.tables.errors.rows[row].values[column].map(|e| f64::from(e) / 1000.0);
        let answers: Vec<_> = nodes.iter().copied().filter(|(row, _)| share(*row).is_some()).collect();
        match mean(&answers, |row| share(row).map(&size)) {
            Value::Known(size) => Some(size),
            _ => None,
        }
    }

    /// Rows with weights round a place of a block, those without truth left out. In the grid a place near the sun or opposite to it is
    /// answered by that peak's own lattice, and elsewhere nodes in the peaks do not count: their errors reach nowhere else.
    pub(crate) fn nodes(&self, block: ErrorBlock, ask: &Ask) -> Vec<(usize, f64)> {
        let known = |(row, _): &(usize, f64)| self.tables.errors.rows[*row].truth.is_some();
        let block = answering(block, ask);
        let mut all = self.errors[&block].around(&coordinates(block, ask));
        all.retain(known);
        let outside = |(row, _): &&(usize, f64)| peak(&asked(&self.tables.errors.rows[*row])).is_none();
        if block == ErrorBlock::Grid && all.iter().any(|node| outside(&node)) {
            all.retain(|node| outside(&node));
        }
        all
    }

    /// Column `column` of `errors.csv` there, a share.
    pub(crate) fn value(&self, nodes: &[(usize, f64)], column: usize) -> Value {
        mean(nodes, |row| self.tables.errors.rows[row].values[column].map(|value| f64::from(value) / 1000.0))
    }

    /// The truth there.
    pub(crate) fn truth(&self, nodes: &[(usize, f64)]) -> Value {
        mean(nodes, |row| self.tables.errors.rows[row].truth)
    }

    /// Red and blue over green, less 1; `None` where the data do not say.
    pub(crate) fn hues(&self, block: ErrorBlock, ask: &Ask) -> Option<[f64; 2]> {
        let block = answering(block, ask);
        let nodes = self.colour.get(&block)?.around(&coordinates(block, ask));
        let hue = |column: usize| {
            let rows = &self.tables.colour.rows;
            let known: Vec<_> =
                nodes.iter().filter(|(row, _)| rows[*row].values[column].is_some()).copied().collect();
            match mean(&known, |row| rows[row].values[column].map(|value| f64::from(value) / 1000.0)) {
                Value::Known(value) => Some(value),
                _ => None,
            }
        };
        Some([hue(0)?, hue(1)?])
    }
}

/// The peak in which a place lies.
fn peak(ask: &Ask) -> Option<ErrorBlock> {
    match ask.side {
        Side::Bottom if ask.scattering_deg < AUREOLE_DEG => Some(ErrorBlock::SilverLining),
        Side::Top if ask.scattering_deg > GLORY_DEG => Some(ErrorBlock::Glory),
        _ => None,
    }
}

/// The lattice that answers a place.
fn answering(block: ErrorBlock, ask: &Ask) -> ErrorBlock {
    if block == ErrorBlock::Grid { peak(ask).unwrap_or(block) } else { block }
}

fn mean(nodes: &[(usize, f64)], of: impl Fn(usize) -> Option<f64>) -> Value {
    let (mut sum, mut total) = (0.0, 0.0);
    for (row, weight) in nodes {
        let Some(value) = of(*row) else { return Value::Refused };
        (sum, total) = (sum + weight * value, total + weight);
    }
    if total > 0.0 { Value::Known(sum / total) } else { Value::Unknown }
}

fn lattices(table: &ErrorTable) -> BTreeMap<ErrorBlock, Lattice> {
    let mut places: BTreeMap<ErrorBlock, Vec<(usize, Vec<f64>)>> = BTreeMap::new();
    for (place, row) in table.rows.iter().enumerate() {
        places.entry(row.block).or_default().push((place, coordinates(row.block, &asked(row))));
    }
    places.into_iter().map(|(block, places)| (block, Lattice::new(&places))).collect()
}

fn asked(row: &ErrorRow) -> Ask {
    Ask {
        effective_radius_um: row.effective_radius_um,
        tau: row.tau,
        theta_l_deg: row.theta_l_deg,
        theta_v_deg: row.theta_v_deg,
        phi_deg: row.phi_deg,
        scattering_deg: row.scattering_deg,
        side: row.side,
    }
}

/// The axes of a block: r_e and thickness in logarithms, the sun, then what else its rows run through.
fn coordinates(block: ErrorBlock, ask: &Ask) -> Vec<f64> {
    let side = if ask.side == Side::Top { 0.0 } else { 1.0 };
    let mut at = vec![libm::log(ask.effective_radius_um), libm::log(ask.tau), ask.theta_l_deg];
    match block {
        ErrorBlock::Grid => at.extend([ask.theta_v_deg, ask.phi_deg, side]),
        ErrorBlock::Fogbow => at.extend([ask.theta_v_deg, ask.scattering_deg]),
        ErrorBlock::Glory | ErrorBlock::SilverLining => at.push(ask.scattering_deg),
        ErrorBlock::Flux => at.push(side),
    }
    at
}
