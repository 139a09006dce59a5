//! The artifacts of a folder, read and checked before anything is drawn.
//!
//! Needed: `optics/optics.json` and the phase tables it names, `orders.csv`, `parameters.json`. The rest is
//! optional: without it the figures and paragraphs that need it are left out, and the page says so. A file
//! that is there but damaged is an error, needed or not.

use crate::{LeftOut, ReportError, checks};
use serde::de::DeserializeOwned;
use std::path::{Component, Path, PathBuf};
use stratiform_artifact::{
    AgreementDocument, AgreementRow, AngularBooksRow, ArtifactError, ConvergenceRow, CurvesRow, LadderRow,
    NotesDocument, OpticsDocument, OrdersRow, ParametersDocument, PrincipalPlaneRow, PublishedRow,
    QuadratureRow, SolverCostRow, read_csv, read_json,
};

/// One row of a phase table.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PhaseRow {
    /// Scattering angle in degrees.
    pub theta_deg: f64,
    /// Phase function, mean 1 over the sphere.
    pub p: f64,
}

/// Everything a report is made from.
pub struct Inputs {
    pub optics: OpticsDocument,
    /// The full phase function of each entry of `optics.wavelengths`.
    pub phases: Vec<Vec<PhaseRow>>,
    pub orders: Vec<OrdersRow>,
    pub parameters: ParametersDocument,
    pub sphere: Option<Vec<PhaseRow>>,
    pub agreement: Option<(AgreementDocument, Vec<AgreementRow>)>,
    pub ladder: Option<Vec<LadderRow>>,
    pub convergence: Option<Vec<ConvergenceRow>>,
    pub solver_cost: Option<Vec<SolverCostRow>>,
    pub quadrature: Option<Vec<QuadratureRow>>,
    pub angular_books: Option<Vec<AngularBooksRow>>,
    pub principal_plane: Option<Vec<PrincipalPlaneRow>>,
    pub published: Option<Vec<PublishedRow>>,
    pub curves: Option<Vec<CurvesRow>>,
    pub notes: Option<NotesDocument>,
}

/// Names of the optional files, relative to the folder.
pub mod optional {
    pub const SPHERE: &str = "optics/sphere.csv";
    pub const AGREEMENT: &str = "agreement.json";
    pub const LADDER: &str = "ladder.csv";
    pub const CONVERGENCE: &str = "convergence.csv";
    pub const SOLVER_COST: &str = "solver_cost.csv";
    pub const QUADRATURE: &str = "optics/quadrature.csv";
    pub const ANGULAR_BOOKS: &str = "angular-books.csv";
    pub const PRINCIPAL_PLANE: &str = "figures/principal-plane.csv";
    pub const PUBLISHED: &str = "published.csv";
    pub const CURVES: &str = "curves.csv";
    pub const NOTES: &str = "notes.json";
}

impl Inputs {
    /// Reads and checks the folder.
    ///
    /// # Errors
    /// [`ReportError::Missing`], [`ReportError::Artifact`] or [`ReportError::Domain`], each naming the file.
    pub fn read(dir: &Path) -> Result<Self, ReportError> {
        let optics_path = dir.join("optics/optics.json");
        let optics: OpticsDocument = document(&optics_path, OpticsDocument::SCHEMA, "the medium's optics")?;
        checks::optics(&optics_path, &optics)?;
        let parameters_path = dir.join("parameters.json");
        let parameters: ParametersDocument =
            document(&parameters_path, ParametersDocument::SCHEMA, "the fitted parameters")?;
        checks::parameters(&parameters_path, &parameters)?;
        let notes = optional_document(&dir.join(optional::NOTES), NotesDocument::SCHEMA)?;
        Ok(Self {
            phases: phases(&dir.join("optics"), &optics)?,
            orders: table(&dir.join("orders.csv"), checks::orders)
                .map_err(missing("fluxes per scattering order"))?,
            agreement: agreement(dir)?,
            ladder: optional_table(&dir.join(optional::LADDER), checks::ladder)?,
            sphere: optional_table(&dir.join(optional::SPHERE), checks::phase)?,
            convergence: optional_table(&dir.join(optional::CONVERGENCE), checks::convergence)?,
            solver_cost: optional_table(&dir.join(optional::SOLVER_COST), checks::solver_cost)?,
            quadrature: optional_table(&dir.join(optional::QUADRATURE), checks::quadrature)?,
            angular_books: optional_table(&dir.join(optional::ANGULAR_BOOKS), checks::angular_books)?,
            principal_plane: optional_table(&dir.join(optional::PRINCIPAL_PLANE), checks::principal_plane)?,
            published: optional_table(&dir.join(optional::PUBLISHED), checks::published)?,
            curves: optional_table(&dir.join(optional::CURVES), checks::curves)?,
            optics,
            parameters,
            notes,
        })
    }
}

/// The verdict and the table it was reached on.
fn agreement(dir: &Path) -> Result<Option<(AgreementDocument, Vec<AgreementRow>)>, ReportError> {
    let verdict = optional_document(&dir.join(optional::AGREEMENT), AgreementDocument::SCHEMA)?;
    let rows = |verdict| {
        let rows = table(&dir.join("agreement.csv"), checks::agreement)
            .map_err(missing("the agreement of both sources"))?;
        Ok((verdict, rows))
    };
    verdict.map(rows).transpose()
}

fn phases(folder: &Path, optics: &OpticsDocument) -> Result<Vec<Vec<PhaseRow>>, ReportError> {
    let read = |name: &String| {
        let path = inside(folder, name)?;
        table(&path, checks::phase).map_err(missing("the phase function of each wavelength"))
    };
    optics.wavelengths.iter().map(|w| read(&w.phase_csv)).collect()
}

/// `name` within `folder`, refused if it leads out of it.
fn inside(folder: &Path, name: &str) -> Result<PathBuf, ReportError> {
    if Path::new(name).components().all(|part| matches!(part, Component::Normal(_))) {
        return Ok(folder.join(name));
    }
    let message = format!("phase_csv = `{name}` must be a path inside the folder of this file");
    Err(ArtifactError::format(folder.join("optics.json"), None, message).into())
}

/// Turns "no such file" into the error that says what it is needed for.
fn missing(needed_for: &'static str) -> impl Fn(ReportError) -> ReportError {
    move |error| match error {
        ReportError::Artifact(ArtifactError::Io { path, source, .. })
            if source.kind() == std::io::ErrorKind::NotFound =>
        {
            ReportError::Missing { path, needed_for }
        }
        other => other,
    }
}

fn document<T: DeserializeOwned>(
    path: &Path,
    schema: &str,
    needed_for: &'static str,
) -> Result<T, ReportError> {
    checks::schema(path, schema).and_then(|()| Ok(read_json(path)?)).map_err(missing(needed_for))
}

fn optional_document<T: DeserializeOwned>(path: &Path, schema: &str) -> Result<Option<T>, ReportError> {
    absent_is_none(document(path, schema, "its notes"))
}

fn table<T: DeserializeOwned>(
    path: &Path,
    check: impl Fn(&Path, &[T]) -> Result<(), ReportError>,
) -> Result<Vec<T>, ReportError> {
    let rows = read_csv(path)?;
    check(path, &rows)?;
    Ok(rows)
}

fn optional_table<T: DeserializeOwned>(
    path: &Path,
    check: impl Fn(&Path, &[T]) -> Result<(), ReportError>,
) -> Result<Option<Vec<T>>, ReportError> {
    absent_is_none(table(path, check).map_err(missing("it")))
}

fn absent_is_none<T>(read: Result<T, ReportError>) -> Result<Option<T>, ReportError> {
    match read {
        Ok(value) => Ok(Some(value)),
        Err(ReportError::Missing { .. }) => Ok(None),
        Err(error) => Err(error),
    }
}

impl Inputs {
    /// What the page lacks.
    pub fn left_out(&self) -> Vec<LeftOut> {
        let lacking = |absent: bool, what, file| absent.then_some(LeftOut { what, file });
        [
            lacking(self.sphere.is_none(), "the single droplet in the phase functions", optional::SPHERE),
            lacking(self.curves.is_none(), "the model curves beside the reference points", optional::CURVES),
            lacking(self.published.is_none(), "the published parameters", optional::PUBLISHED),
            lacking(self.notes.is_none(), "the reasons why the published table differs", optional::NOTES),
            lacking(self.agreement.is_none(), "the comparison of solver and photons", optional::AGREEMENT),
            lacking(self.ladder.is_none(), "the ladder of approximations", optional::LADDER),
            lacking(self.convergence.is_none(), "the convergence figure", optional::CONVERGENCE),
            lacking(self.solver_cost.is_none(), "the cost of the solver", optional::SOLVER_COST),
            lacking(
                self.principal_plane.is_none(),
                "radiance in the plane of the sun",
                optional::PRINCIPAL_PLANE,
            ),
            lacking(self.quadrature.is_none(), "the convergence of the size average", optional::QUADRATURE),
            lacking(self.angular_books.is_none(), "the energy of the angular model", optional::ANGULAR_BOOKS),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}
