//! Everything that the printed bytes of a trace of fluxes depend on, and the printing.

use super::{Device, Engine};
use crate::args::{Estimator, TraceArgs};
use crate::commands::order_rows;
use crate::medium::Medium;
use crate::output::Data;
use crate::{CliError, pipeline};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use stratiform_artifact::{OrderResult, OrdersDocument, Provenance, TracedMedium, hash_of, to_json};
use stratiform_quantities::{Incidence, Order};
use stratiform_transport::{Stop, TraceJob, TraceRequest, Traced, Tracer};

/// A trace as asked for, one incidence after the other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TraceRun {
    medium: TracedMedium,
    tau: Vec<f64>,
    mu0: Vec<String>,
    photons: u64,
    std_error: Option<f64>,
    orders: u32,
    seed: u64,
    estimator: Estimator,
    /// The adapter, on a graphics device.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    device: Option<String>,
}

impl TraceRun {
    /// What `args` ask for in `medium` on `device`.
    pub fn new(args: &TraceArgs, medium: &Medium, device: &Device) -> Self {
        Self {
            medium: medium.record().clone(),
            tau: args.slab.tau.clone(),
            mu0: args.slab.mu0.clone(),
            photons: args.photons,
            std_error: args.std_error,
            orders: args.orders,
            seed: args.seed,
            estimator: args.estimator.unwrap_or(Estimator::HalfSpace),
            device: device.adapter(),
        }
    }

    /// Checks what can be checked before the medium is known.
    ///
    /// # Errors
    /// [`CliError::Input`] naming the number that is out of domain.
    pub fn check(args: &TraceArgs) -> Result<(), CliError> {
        for incidence in order_rows::parse_incidences(&args.slab.mu0)? {
            let stop = stop(args.photons, args.std_error);
            let (tau, max_order) = (args.slab.tau.clone(), args.orders);
            let request = TraceRequest { tau, incidence, stop, max_order, seed: args.seed, stream: 0 };
            request.check().map_err(pipeline::trace_error)?;
        }
        Ok(())
    }

    /// One tracer per incidence.
    ///
    /// # Errors
    /// [`CliError::Input`] naming what is out of domain.
    pub fn engines<'a>(
        &self,
        medium: &'a Medium,
        device: &'a Device,
    ) -> Result<Vec<Box<dyn Engine + 'a>>, CliError> {
        let tracer = match self.estimator {
            Estimator::HalfSpace => Tracer::HalfSpace,
            Estimator::Plain => Tracer::Plain,
        };
        let engine = |request| -> Result<Box<dyn Engine + 'a>, CliError> {
            if let Some(engine) = device.engine(medium.traced(), request)? {
                return Ok(engine);
            }
            let job = TraceJob::new(tracer, medium.traced(), request).map_err(pipeline::trace_error)?;
            Ok(Box::new(job))
        };
        self.requests()?.iter().map(engine).collect()
    }

    /// One request per incidence.
    ///
    /// # Errors
    /// [`CliError::Input`] naming an incidence that is none.
    pub fn requests(&self) -> Result<Vec<TraceRequest>, CliError> {
        let incidences = order_rows::parse_incidences(&self.mu0)?;
        Ok(incidences.into_iter().map(|incidence| self.request(incidence)).collect())
    }

    fn request(&self, incidence: Incidence) -> TraceRequest {
        TraceRequest {
            tau: self.tau.clone(),
            incidence,
            stop: stop(self.photons, self.std_error),
            max_order: self.orders,
            seed: self.seed,
            stream: pipeline::stream_of(incidence, self.medium.medium),
        }
    }

    /// Incidences as typed.
    pub fn mu0(&self) -> &[String] {
        &self.mu0
    }

    /// The first thing in which `self` differs from `wanted`, in words.
    pub fn difference(&self, wanted: &Self) -> Option<String> {
        let value = |run: &Self| serde_json::to_value(run).unwrap_or_default();
        difference("", &value(self), &value(wanted))
    }

    /// What belongs on stdout.
    ///
    /// # Errors
    /// [`CliError::Unmet`], with the result, if the error asked for was not reached.
    pub fn print(&self, traced: &[Traced], json: bool) -> Result<Data, CliError> {
        let data = self.render(traced.iter().flat_map(|traced| self.rows(traced)).collect(), json)?;
        let worst = traced.iter().map(Traced::worst_error).fold(0.0, f64::max);
        match self.std_error.filter(|target| worst > *target) {
            None => Ok(data),
            Some(target) => {
                let photons = self.photons;
                let message = format!(
                    "{photons} photons reach a standard error of {worst:.3e}, not {target:.3e}: raise --photons"
                );
                Err(CliError::Unmet { message, data })
            }
        }
    }

    fn rows(&self, traced: &Traced) -> Vec<OrderResult> {
        let orders = |index: usize| Order::rows(self.orders).map(move |order| (index, order));
        let row = |(index, order): (usize, Order)| {
            let (reflectance, transmittance) = traced.estimate(index, order);
            let (photons, mu0) = (Some(traced.photons()), traced.incidence());
            OrderResult { tau: self.tau[index], mu0, order, photons, reflectance, transmittance }
        };
        (0..self.tau.len()).flat_map(orders).map(row).collect()
    }

    fn render(&self, results: Vec<OrderResult>, json: bool) -> Result<Data, CliError> {
        if !json {
            return order_rows::csv(self.medium.medium, results);
        }
        let inputs = (&self.medium, &self.tau, &self.mu0, self.photons, self.std_error, self.orders);
        let half_space = "half-space Monte Carlo; std_error is one standard deviation of the mean, at least 1/(photons + 3)";
        let method = match (self.estimator, &self.device) {
            (Estimator::HalfSpace, None) => half_space.to_owned(),
            (Estimator::HalfSpace, Some(adapter)) => {
                format!("{half_space}; in single precision on {adapter}")
            }
            (Estimator::Plain, _) => {
                "plain three-dimensional Monte Carlo; std_error as for half-space".to_owned()
            }
        };
        let document = OrdersDocument {
            schema: OrdersDocument::SCHEMA.to_owned(),
            medium: self.medium.clone(),
            provenance: Provenance::new(hash_of(&inputs), Some(self.seed), &method),
            results,
        };
        Ok(to_json(&document)?)
    }
}

fn stop(photons: u64, std_error: Option<f64>) -> Stop {
    match std_error {
        Some(target) => Stop::StdError { target, max_photons: photons },
        None => Stop::Photons(photons),
    }
}

/// The first difference of two documents.
fn difference(place: &str, found: &Value, wanted: &Value) -> Option<String> {
    if let (Value::Object(found), Value::Object(wanted)) = (found, wanted) {
        let keys = wanted.keys().chain(found.keys().filter(|key| !wanted.contains_key(*key)));
        let below = |key: &String| if place.is_empty() { key.clone() } else { format!("{place}.{key}") };
        let null = Value::Null;
        let inside =
            |key| difference(&below(key), found.get(key).unwrap_or(&null), wanted.get(key).unwrap_or(&null));
        return keys.into_iter().find_map(inside);
    }
    (found != wanted).then(|| format!("its {place} is {found}, not {wanted}"))
}
