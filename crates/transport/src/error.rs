//! What can go wrong.

use stratiform_quantities::DomainError;

/// Why a trace or a solution gave no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TransportError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// No thickness was asked for.
    #[error("tau: the list of optical thicknesses is empty")]
    NoThickness,
    /// No incidence was asked for.
    #[error("mu0: the list of incidences is empty")]
    NoIncidence,
    /// No view was asked for.
    #[error("views: the list of view directions is empty")]
    NoView,
    /// The finest angular rule of order 2 does not reach the tolerance.
    #[error("tolerance = {wanted:e} is not met: the finest angular rule of order 2 reaches {reached:.1e}")]
    Rule {
        /// Asked for.
        wanted: f64,
        /// Estimated error at the end.
        reached: f64,
    },
    /// The solver's finest quadrature does not reach the tolerance.
    #[error("tolerance = {wanted:e} is not met: {streams} streams per hemisphere reach {reached:.1e}{place}")]
    Tolerance {
        /// Asked for.
        wanted: f64,
        /// Estimated error at the end.
        reached: f64,
        /// Streams per hemisphere.
        streams: usize,
        /// Where, as ` at …`; empty if the list is not searched for it.
        place: String,
    },
    /// Thicknesses times orders exceed what the tallies hold.
    #[error("{thicknesses} thicknesses with {orders} orders each make more than {max} rows")]
    TooManyRows {
        /// Number of thicknesses.
        thicknesses: usize,
        /// Rows per thickness: orders 0…N and the tail.
        orders: usize,
        /// Largest product.
        max: usize,
    },
    /// Views or bins times orders exceed what is kept.
    #[error("{places} views or bins with {orders} orders each make more than {max} cells")]
    TooManyCells {
        /// Number of views, or of bins of both faces.
        places: usize,
        /// Rows of each: orders 1…N, tail and total.
        orders: usize,
        /// Largest product.
        max: usize,
    },
    /// Edges that make no bins.
    #[error("bin edges {name} must be two or more and ascend{}", at.map_or(String::new(), |(a, b)| format!(": {a} is followed by {b}")))]
    Edges {
        /// Of which coordinate.
        name: &'static str,
        /// The first two in the wrong order; none if there are too few.
        at: Option<(f64, f64)>,
    },
    /// The caller asked to stop.
    #[error("cancelled")]
    Cancelled,
    /// Photons were lost or counted twice: a defect of the tracer.
    #[error("at tau = {tau}, {counted} photons were counted of {launched} launched")]
    Books {
        /// Optical thickness of the slab.
        tau: f64,
        /// Reflected, transmitted and absorbed ones together.
        counted: u64,
        /// Histories started.
        launched: u64,
    },
}
