//! What ranks say to each other: whether all may go on, and what they have counted.
//!
//! Counts travel as the sealed bytes that `stratiform merge` reads, up a binomial tree: at step s = 1, 2, 4 … rank r
//! sends to r - s if bit s of r is set and takes from r + s otherwise, so that each rank holds two parts at most and
//! ⌈log₂ N⌉ steps suffice. Merging refuses doubled and foreign photons, printing refuses missing ones.

use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives, Destination, Root, Source};
use stratiform_cli::trace::RunParts;
use stratiform_cli::{CliError, output};
use stratiform_transport::Share;

/// Bytes of one message: MPI counts in 32 bits.
const MESSAGE: usize = 1 << 30;

/// The ranks of a job, seen from one of them.
pub struct Ranks {
    world: SimpleCommunicator,
}

impl Ranks {
    /// All ranks of `world`.
    pub fn new(world: SimpleCommunicator) -> Self {
        Self { world }
    }

    /// Whether this rank prints.
    pub fn is_first(&self) -> bool {
        self.world.rank() == 0
    }

    /// How many they are.
    pub fn count(&self) -> u64 {
        self.world.size() as u64
    }

    /// This rank's share of the photons.
    ///
    /// # Errors
    /// [`CliError::Input`] for more than 2³² ranks.
    pub fn share(&self) -> Result<Share, CliError> {
        let share = Share::new(self.world.rank() as u64 + 1, self.count());
        share.map_err(|error| CliError::Input(error.to_string()))
    }

    /// What `result` holds if no rank failed; else the exit code of the first that did, whose `say` tells why.
    ///
    /// # Errors
    /// The exit code.
    pub fn agree<T, E>(&self, result: Result<T, E>, say: impl FnOnce(E) -> u8) -> Result<T, u8> {
        let (rank, all) = (self.world.rank(), self.world.size());
        let mut first = all;
        let failed = if result.is_err() { rank } else { all };
        self.world.all_reduce_into(&failed, &mut first, SystemOperation::min());
        let mut code = 0;
        match result {
            Ok(value) if first == all => return Ok(value),
            Err(error) if first == rank => code = say(error),
            _ => {}
        }
        self.world.process_at_rank(first).broadcast_into(&mut code);
        Err(code)
    }

    /// Refuses, before anything is traced, parts of another trace than the first rank's.
    ///
    /// # Errors
    /// [`CliError::Input`] naming the first difference.
    pub fn check_same(&self, parts: &RunParts) -> Result<(), CliError> {
        let mut bytes = if self.is_first() { parts.to_bytes().unwrap_or_default() } else { Vec::new() };
        let mut length = bytes.len() as u64;
        let first = self.world.process_at_rank(0);
        first.broadcast_into(&mut length);
        bytes.resize(length as usize, 0);
        bytes.chunks_mut(MESSAGE).for_each(|piece| first.broadcast_into(piece));
        if self.is_first() { Ok(()) } else { RunParts::from_bytes(&bytes)?.merge(parts) }
    }

    /// Says what happened and ends every rank of the job.
    pub fn end_all(&self, error: CliError) -> ! {
        let code = match error {
            // A signal reaches every rank; one speaks for all.
            CliError::Interrupted if !self.is_first() => error.code(),
            error => self.say(error),
        };
        self.world.abort(i32::from(code))
    }

    /// Says which rank failed and why. Returns the exit code.
    pub fn say(&self, error: CliError) -> u8 {
        let place = format!("rank {} of {}", self.world.rank() + 1, self.world.size());
        output::finish(Err(error.at(&place)))
    }

    /// The sum of all ranks' parts at the first rank, nothing at the others.
    ///
    /// # Errors
    /// [`CliError::Input`] if ranks traced different things, or the same photons: the others still wait then.
    pub fn sum(&self, mut parts: RunParts) -> Result<Option<RunParts>, CliError> {
        let (rank, size) = (self.world.rank(), self.world.size());
        let mut step = 1;
        while step < size {
            if rank & step != 0 {
                self.send(&parts.to_bytes()?, rank - step);
                return Ok(None);
            }
            if step < size - rank {
                parts.merge(&RunParts::from_bytes(&self.receive(rank + step))?)?;
            }
            step = step.saturating_mul(2);
        }
        Ok(Some(parts))
    }

    fn send(&self, bytes: &[u8], rank: i32) {
        let to = self.world.process_at_rank(rank);
        to.send(&(bytes.len() as u64));
        bytes.chunks(MESSAGE).for_each(|piece| to.send(piece));
    }

    fn receive(&self, rank: i32) -> Vec<u8> {
        let from = self.world.process_at_rank(rank);
        let (length, _) = from.receive::<u64>();
        let mut bytes = Vec::new();
        while (bytes.len() as u64) < length {
            bytes.append(&mut from.receive_vec().0);
        }
        bytes
    }
}
