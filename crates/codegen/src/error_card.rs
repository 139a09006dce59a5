//! How far the emitted table is from reference values: median, 95th percentile and worst absolute error.

use crate::{
    CodegenError, Inputs, QUANTITIES, ReferencePoint, diffuse_parameters, parameter_grid, tables::angles,
};
use stratiform_model::table::{ParameterGrid, cos_degrees};
use stratiform_model::{Form, Parameters, Thickness};
use stratiform_quantities::Incidence;

/// The spread of a set of absolute errors.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorCard {
    /// One of [`QUANTITIES`].
    pub quantity: String,
    /// Number of values.
    pub count: usize,
    /// Median.
    pub median: f64,
    /// 95th percentile.
    pub percentile_95: f64,
    /// Largest.
    pub worst: f64,
    /// Largest error that the reference values claim: errors of this size say nothing about the table.
    pub reference_error: f64,
}

/// Spread of `errors`, which need no order; nothing for none.
pub(crate) fn spread(quantity: &str, mut errors: Vec<f64>) -> Option<ErrorCard> {
    errors.sort_by(f64::total_cmp);
    let at = |share: usize| errors.get(((errors.len() * share).div_ceil(100)).saturating_sub(1)).copied();
    Some(ErrorCard {
        quantity: quantity.to_owned(),
        count: errors.len(),
        median: at(50)?,
        percentile_95: at(95)?,
        worst: at(100)?,
        reference_error: 0.0,
    })
}

/// Which reference points a card is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// At the table's angles up to [`STEEP_DEG`].
    Nodes,
    /// Between them: interpolation error included.
    Between,
    /// At and between the table's angles nearer to the horizon, where the model's form fails.
    Grazing,
    /// In diffuse light.
    Diffuse,
}

/// Up to here the model's form can describe a cloud; at 90° it cannot.
pub(crate) const STEEP_DEG: f64 = 80.0;

fn place(incidence: Incidence, nodes: &[f64]) -> Place {
    match incidence {
        Incidence::Diffuse => Place::Diffuse,
        Incidence::Beam(mu) if mu.get() < cos_degrees(STEEP_DEG) - 1e-9 => Place::Grazing,
        Incidence::Beam(mu) if nodes.iter().any(|node| (node - mu.get()).abs() < 1e-9) => Place::Nodes,
        Incidence::Beam(_) => Place::Between,
    }
}

struct Table {
    grid: ParameterGrid<f64>,
    diffuse: Parameters<f64>,
}

impl Table {
    fn error(&self, point: &ReferencePoint) -> Result<f64, CodegenError> {
        let parameters = match point.incidence {
            Incidence::Beam(mu) => self.grid.at(mu.get())?,
            Incidence::Diffuse => self.diffuse,
        };
        let fluxes = parameters.fluxes(Form::Corrected, Thickness::new(point.tau.get())?).named();
        let model = fluxes.iter().find(|(name, _)| *name == point.quantity).map(|(_, value)| *value);
        let unknown = || CodegenError::UnknownQuantity { quantity: point.quantity.clone() };
        Ok((model.ok_or_else(unknown)? - point.value).abs())
    }
}

/// The cards of the points at one place.
pub(crate) fn cards(inputs: &Inputs, wanted: Place) -> Result<Vec<ErrorCard>, CodegenError> {
    let optical = &inputs.parameters.optical;
    let nodes: Vec<_> = angles(optical).iter().map(|angle| cos_degrees(angle.theta_l_deg)).collect();
    let table = Table { grid: parameter_grid(optical)?, diffuse: diffuse_parameters(optical)? };
    let mut cards = Vec::new();
    for quantity in QUANTITIES {
        let here = inputs.reference.iter().filter(|point| point.quantity == quantity);
        let here: Vec<_> = here.filter(|point| place(point.incidence, &nodes) == wanted).collect();
        let errors = here.iter().map(|point| table.error(point)).collect::<Result<Vec<_>, _>>()?;
        let reference_error = here.iter().fold(0.0_f64, |worst, point| worst.max(point.std_error));
        cards.extend(spread(quantity, errors).map(|card| ErrorCard { reference_error, ..card }));
    }
    Ok(cards)
}

/// Errors at the table's angles up to 80°, between them, nearer to the horizon, and in diffuse light.
///
/// # Errors
/// [`CodegenError`] if the inputs are out of domain.
pub fn error_card(inputs: &Inputs) -> Result<[Vec<ErrorCard>; 4], CodegenError> {
    let [nodes, between, grazing, diffuse] =
        [Place::Nodes, Place::Between, Place::Grazing, Place::Diffuse].map(|place| cards(inputs, place));
    Ok([nodes?, between?, grazing?, diffuse?])
}
