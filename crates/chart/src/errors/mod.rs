//! The data of the adviser: signed errors of every shader method on a lattice over clouds, suns and views.
//!
//! [`make`] solves the truth at every [`Nodes`] of every cloud and writes each method's error in per mille. Besides the lattice in
//! azimuth there are rows in scattering angle for glory (174° to 180°), fogbow (135° to 150°) and silver lining (0° to 20°), and rows
//! of R and T. Methods without [`single`](stratiform_methods::Ready::single), solvers and tracers, are no shader code and not listed.

mod colour;
mod known;
mod listed;
mod nodes;
mod rows;
mod truth;

use known::Known;
pub use listed::{Listed, listed};
pub use nodes::{Nodes, WAVELENGTHS_UM};

use stratiform_artifact::{ErrorData, ErrorTable};
use stratiform_methods::{Cloud, MethodError};
use stratiform_transport::TransportError;

/// Why there is no data.
#[derive(Debug, thiserror::Error)]
pub enum ErrorsError {
    /// The truth.
    #[error(transparent)]
    Transport(#[from] TransportError),
    /// A phase table.
    #[error(transparent)]
    Chart(#[from] crate::ChartError),
    /// A method.
    #[error(transparent)]
    Method(#[from] MethodError),
    /// A cloud is missing.
    #[error("the nodes name {wanted} clouds, and {given} are given")]
    Clouds {
        /// Radii and wavelengths.
        wanted: usize,
        /// Of the caller.
        given: usize,
    },
}

/// The data, for clouds of `nodes.radii_um`, each at [`WAVELENGTHS_UM`]; `step` is told after each cloud. Truths that `before` holds
/// are not solved again.
///
/// # Errors
/// [`ErrorsError`].
pub fn make(
    nodes: &Nodes,
    clouds: &[[Cloud; 3]],
    before: Option<&ErrorData>,
    step: &dyn Fn(),
) -> Result<ErrorData, ErrorsError> {
    if clouds.len() != nodes.radii_um.len() {
        return Err(ErrorsError::Clouds { wanted: nodes.radii_um.len(), given: clouds.len() });
    }
    let methods = listed()?;
    let known = before.map(Known::of).unwrap_or_default();
    let mut rows = Vec::new();
    let mut hues = Vec::new();
    for (place, waves) in clouds.iter().enumerate() {
        rows.extend(rows::of_cloud(nodes, nodes.radii_um[place], &waves[1], &methods, &known)?);
        if nodes.coloured(place) {
            hues.extend(colour::of_cloud(nodes, nodes.radii_um[place], waves, &known)?);
        }
        step();
    }
    let greens: Vec<&Cloud> = clouds.iter().map(|waves| &waves[1]).collect();
    let cards = listed::records(&methods, &greens, &rows)?;
    let names = cards.iter().map(|card| card.name.clone());
    let columns = ErrorData::ORDERS.iter().map(|name| (*name).to_owned()).chain(names).collect();
    let colour = ErrorTable { columns: vec!["red".to_owned(), "blue".to_owned()], rows: hues };
    Ok(ErrorData { methods: cards, errors: ErrorTable { columns, rows }, colour })
}
