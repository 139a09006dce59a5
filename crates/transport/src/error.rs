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
    /// A sum stopped at its largest number.
    #[error("at tau = {tau} there are more scatterings than can be counted, {}", u64::MAX - 1)]
    TooManyScatterings {
        /// Optical thickness of the slab.
        tau: f64,
    },
    /// Text that names no share.
    #[error("shard = `{text}` is not K/N with whole numbers 1 <= K <= N <= 4294967296")]
    Share {
        /// What was given.
        text: String,
    },
    /// Rounds of a trace with a target error depend on all photons before them.
    #[error(
        "a trace that stops at a standard error cannot be split: its length depends on the results of all photons"
    )]
    OneAfterTheOther,
    /// Photons that are counted already.
    #[error("photons {from} to {} would be counted twice", to - 1)]
    CountedTwice {
        /// The first of them.
        from: u64,
        /// One past the last of the first such range.
        to: u64,
    },
    /// Photons that nobody counted.
    #[error("{photons} photons are missing, from photon {from} to {} first", to - 1)]
    Missing {
        /// How many.
        photons: u64,
        /// The first of them.
        from: u64,
        /// One past the last of the first such range.
        to: u64,
    },
    /// A tally of more or fewer photons than its cell has.
    #[error("{launched} photons were launched as numbers {from} to {}", to - 1)]
    Launched {
        /// The first number.
        from: u64,
        /// One past the last.
        to: u64,
        /// Histories started.
        launched: u64,
    },
    /// A tally of other slabs or orders.
    #[error("the tally is not of {thicknesses} thicknesses with {orders} orders each")]
    Shape {
        /// Number of thicknesses.
        thicknesses: usize,
        /// Rows per thickness: orders 0…N and the tail.
        orders: usize,
    },
    /// A part of another trace.
    #[error("it belongs to another trace: its {what} is {found}, not {wanted}")]
    Foreign {
        /// What differs first.
        what: &'static str,
        /// Its value there.
        found: String,
        /// The value here.
        wanted: String,
    },
    /// Stored counts that contradict themselves.
    #[error("the stored counts contradict themselves")]
    Damaged,
}
