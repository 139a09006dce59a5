//! What some photons of a run have counted: one part per incidence.

use super::{Checkpoint, Engine, TraceRun, seal};
use crate::output::{Data, Talk};
use crate::{CliError, interrupt, pipeline, progress};
use serde::{Deserialize, Serialize};
use std::path::Path;
use stratiform_artifact::{ArtifactError, write_atomic};
use stratiform_transport::{Part, Share};

/// The parts of one run, in the order of its incidences, and the share of the photons that they are for.
#[derive(Clone, Debug, PartialEq)]
pub struct RunParts {
    run: TraceRun,
    share: Share,
    parts: Vec<Part>,
}

/// What the file's first line says.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct About {
    shard: String,
    run: TraceRun,
}

impl RunParts {
    /// No photon yet.
    pub fn nothing(run: TraceRun, share: Share, engines: &[Box<dyn Engine + '_>]) -> Self {
        Self { run, share, parts: engines.iter().map(|engine| engine.part()).collect() }
    }

    /// The share of the photons that this is for.
    pub fn share(&self) -> Share {
        self.share
    }

    /// Photons counted, of all incidences.
    pub fn photons(&self) -> u64 {
        self.parts.iter().map(Part::photons).sum()
    }

    /// Traces what is missing of the share, incidence by incidence. `keep` sees all parts whenever there are more
    /// photons in them, and may store them.
    ///
    /// # Errors
    /// [`CliError::Interrupted`], when the parts have all that was traced by then.
    pub fn trace(
        &mut self,
        engines: &[Box<dyn Engine + '_>],
        talk: Talk,
        mut keep: impl FnMut(&Snapshot<'_>) + Send,
    ) -> Result<(), CliError> {
        let (run, share, watch) = (&self.run, self.share, interrupt::watch());
        for (index, engine) in engines.iter().enumerate() {
            let (before, rest) = self.parts.split_at_mut(index);
            let Some((part, after)) = rest.split_first_mut() else { continue };
            let bar = progress::bar(0, &format!("mu0 {}", run.mu0()[index]), talk.quiet);
            let advanced = |done: u64, total: u64| {
                bar.set_length(total);
                bar.set_position(done);
            };
            let control = pipeline::control(&advanced, &watch);
            let (before, after) = (&*before, &*after);
            let mut kept = |part: &Part| keep(&Snapshot { run, share, before, part, after });
            engine.trace(part, share, control, &mut kept)?;
            bar.finish_and_clear();
        }
        Ok(())
    }

    /// As [`trace`](Self::trace); the checkpoint, where there is one, is kept up, and complete at the end.
    ///
    /// # Errors
    /// As [`trace`](Self::trace).
    pub fn trace_keeping(
        &mut self,
        engines: &[Box<dyn Engine + '_>],
        checkpoint: Option<Checkpoint>,
        talk: Talk,
    ) -> Result<(), CliError> {
        let Some(mut checkpoint) = checkpoint else { return self.trace(engines, talk, |_| ()) };
        let _watch = interrupt::watch();
        let traced = self.trace(engines, talk, |snapshot| checkpoint.keep(snapshot));
        checkpoint.keep_now(self);
        if matches!(traced, Err(CliError::Interrupted)) {
            let photons = self.photons();
            talk.say(format!("{photons} photons are kept: the same command goes on from there"));
        }
        traced
    }

    /// Whether every photon of its share is there.
    ///
    /// # Errors
    /// [`CliError::Input`] if some are not: it is the checkpoint of an unfinished trace.
    pub fn check_complete(&self) -> Result<(), CliError> {
        for (part, mu0) in self.parts.iter().zip(self.run.mu0()) {
            if part.is_complete(self.share).map_err(pipeline::trace_error)? {
                continue;
            }
            return Err(CliError::Input(format!(
                "the trace of shard {} is not finished: it has {} photons at mu0 = {mu0}",
                self.share,
                part.photons()
            )));
        }
        Ok(())
    }

    /// Takes the counts of `held`, which is to be the same share of the same run.
    ///
    /// # Errors
    /// [`CliError::Input`] naming the first difference.
    pub fn take_over(&mut self, held: Self) -> Result<(), CliError> {
        held.check_same(&self.run)?;
        if held.share != self.share {
            return Err(CliError::Input(format!("it is of shard {}, not {}", held.share, self.share)));
        }
        for (part, held) in self.parts.iter().zip(&held.parts) {
            held.check_same(part).map_err(pipeline::trace_error)?;
        }
        self.parts = held.parts;
        Ok(())
    }

    /// Adds the photons of `other`, another share of the same run.
    ///
    /// # Errors
    /// [`CliError::Input`] naming the first difference, or the photons that both have.
    pub fn merge(&mut self, other: &Self) -> Result<(), CliError> {
        other.check_same(&self.run)?;
        for (index, (part, other)) in self.parts.iter_mut().zip(&other.parts).enumerate() {
            let place = format!("mu0 = {}", self.run.mu0()[index]);
            part.merge(other).map_err(|error| pipeline::trace_error(error).at(&place))?;
        }
        Ok(())
    }

    /// Whether this is of `run`.
    ///
    /// # Errors
    /// [`CliError::Input`] naming the first difference.
    pub fn check_same(&self, run: &TraceRun) -> Result<(), CliError> {
        match self.run.difference(run) {
            None => Ok(()),
            Some(difference) => Err(CliError::Input(format!("it belongs to another trace: {difference}"))),
        }
    }

    /// What belongs on stdout, if no photon is missing.
    ///
    /// # Errors
    /// [`CliError::Input`] naming missing photons; as [`TraceRun::print`].
    pub fn print(&self, json: bool) -> Result<Data, CliError> {
        let mut traced = Vec::new();
        for (part, mu0) in self.parts.iter().zip(self.run.mu0()) {
            let place = format!("mu0 = {mu0}");
            traced.push(part.finish().map_err(|error| pipeline::trace_error(error).at(&place))?);
        }
        self.run.print(&traced, json)
    }

    /// As a file holds it.
    ///
    /// # Errors
    /// [`CliError::Input`] if it cannot be written down.
    pub fn to_bytes(&self) -> Result<Vec<u8>, CliError> {
        let (before, Some((part, after))) = (&[][..], self.parts.split_first()) else {
            return Err(CliError::Input("mu0: the list of incidences is empty".to_owned()));
        };
        Snapshot { run: &self.run, share: self.share, before, part, after }.to_bytes()
    }

    /// From what [`to_bytes`](Self::to_bytes) gave.
    ///
    /// # Errors
    /// [`CliError::Input`] that says whether the bytes are of another kind, cut short, damaged, or of another program
    /// version.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, CliError> {
        let (about, body) = seal::open::<About>(bytes).map_err(CliError::Input)?;
        let damaged = || CliError::Input("its counts contradict themselves".to_owned());
        let parts: Vec<Part> = postcard::from_bytes(body).map_err(|_| damaged())?;
        let share = about.shard.parse().map_err(pipeline::trace_error)?;
        if parts.is_empty() || !parts.iter().map(Part::request).eq(&about.run.requests()?) {
            return Err(damaged());
        }
        Ok(Self { run: about.run, share, parts })
    }

    /// Reads a file.
    ///
    /// # Errors
    /// As [`from_bytes`](Self::from_bytes), with the file's name.
    pub fn read(path: &Path) -> Result<Self, CliError> {
        let io = |source| ArtifactError::Io { action: "read", path: path.to_owned(), source };
        let bytes = std::fs::read(path).map_err(io)?;
        Self::from_bytes(&bytes).map_err(|error| error.at(&path.display().to_string()))
    }

    /// Writes a file, whole or not at all.
    ///
    /// # Errors
    /// [`CliError::Input`] if the system refuses.
    pub fn write(&self, path: &Path) -> Result<(), CliError> {
        Ok(write_atomic(path, &self.to_bytes()?)?)
    }
}

/// [`RunParts`] while one of them grows.
pub struct Snapshot<'a> {
    run: &'a TraceRun,
    share: Share,
    before: &'a [Part],
    part: &'a Part,
    after: &'a [Part],
}

impl Snapshot<'_> {
    /// As a file holds it.
    ///
    /// # Errors
    /// [`CliError::Input`] if it cannot be written down.
    pub fn to_bytes(&self) -> Result<Vec<u8>, CliError> {
        let parts: Vec<&Part> = self.before.iter().chain([self.part]).chain(self.after).collect();
        let about = About { shard: self.share.to_string(), run: self.run.clone() };
        let body = postcard::to_allocvec(&parts).map_err(|error| CliError::Input(error.to_string()))?;
        seal::seal(&about, &body).map_err(CliError::Input)
    }
}
