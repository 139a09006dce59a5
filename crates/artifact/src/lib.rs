//! The files that pass between stages: their schemas, hashes, provenance, and how they are written.
//!
//! A stage reads and writes these types and knows no other stage's code. Documents are JSON, tables CSV;
//! both keep every bit of an `f64`. Field names carry units. A file appears whole or not at all.

mod ablation;
mod agreement;
mod angular_books;
mod atlas;
mod atomic;
mod chart;
mod comparison;
mod convergence;
mod curves;
mod error;
mod errors;
mod estimators;
mod family;
mod hash;
mod json;
mod ladder;
mod notes;
mod optics;
mod orders;
mod parameters;
mod phase_colour;
mod place;
mod principal_plane;
mod provenance;
mod quadrature;
mod radiance;
mod radiance_parameters;
mod solver_cost;
mod table;

pub use ablation::{AblationRow, RenderCostRow};
pub use agreement::{AgreementDocument, AgreementRow};
pub use angular_books::{AngularBooksRow, AngularForm};
pub use atlas::{AtlasCount, AtlasDocument, AtlasMethod, AtlasPlane, AtlasRow};
pub use atomic::{create_folder, read_text, write_atomic};
pub use chart::{ChartCloud, ChartDocument, ChartMethod, ChartRow, ChartScene, KnobRow};
pub use comparison::{ComparisonDocument, ComparisonPicture, ComparisonRow};
pub use convergence::ConvergenceRow;
pub use curves::{CurveModel, CurveQuantity, CurvesRow, PublishedRow};
pub use error::ArtifactError;
pub use errors::{ErrorBlock, ErrorData, ErrorMethod, ErrorRow, ErrorTable};
pub use estimators::EstimatorErrorRow;
pub use family::{FamilyDocument, FamilyErrorRow, FamilyMember, FamilyPhaseRow};
pub use hash::{hash_bytes, hash_of};
pub use json::{read_json, to_json, write_json};
pub use ladder::LadderRow;
pub use notes::{
    AngularShares, CoarseTabulation, ModifiedBias, NotesDocument, PublishedMisfit, WavelengthShares,
};
pub use optics::{Extinction, ForwardFraction, OpticsDocument, ReachedError, SizeDensity, WavelengthOptics};
pub use orders::{OrderResult, OrdersDocument, OrdersRow, TracedMedium};
pub use parameters::{
    FittedParameter, Flag, MediumRecord, Misfit, ParameterRow, ParameterTable, ParametersCsvRow,
    ParametersDocument, RowIncidence,
};
pub use phase_colour::{PhaseColour, PhaseColourRow};
pub use place::{key_line, line_of};
pub use principal_plane::{PlaneOrder, PlaneSource, PrincipalPlaneRow};
pub use provenance::Provenance;
pub use quadrature::QuadratureRow;
pub use radiance::{RadianceDocument, RadianceResult};
pub use radiance_parameters::{RadianceFace, RadianceMisfit, RadianceParametersDocument, RadianceSample};
pub use solver_cost::SolverCostRow;
pub use table::{parse_csv, read_csv, read_numbered_csv, to_csv, write_csv};
