//! The books of a trace: every photon that was launched has been reflected, transmitted or absorbed, or is in flight.

use crate::GpuTraceError;
use std::fmt;

/// Where the photons are, after some dispatches. Each is counted by the invocation that carried it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Books {
    /// Taken from the queue.
    pub launched: u64,
    /// Left through the top.
    pub reflected: u64,
    /// Passed the thickest slab.
    pub transmitted: u64,
    /// Absorbed.
    pub absorbed: u64,
    /// Neither; below 0 if photons ended that were never launched.
    pub in_flight: i64,
}

impl Books {
    /// Enters one dispatch's ledger: asked of the queue, launched, reflected, transmitted, absorbed, and the change of
    /// those in flight modulo 2³².
    ///
    /// # Errors
    /// [`GpuTraceError::Books`] if they do not balance.
    pub(crate) fn enter(&mut self, ledger: &[u32; LEDGER]) -> Result<(), GpuTraceError> {
        let [_, launched, reflected, transmitted, absorbed, change] = *ledger;
        self.launched += u64::from(launched);
        self.reflected += u64::from(reflected);
        self.transmitted += u64::from(transmitted);
        self.absorbed += u64::from(absorbed);
        self.in_flight += i64::from(change as i32);
        if self.balance() { Ok(()) } else { Err(GpuTraceError::Books(*self)) }
    }

    /// Photons that are through.
    pub fn ended(&self) -> u64 {
        self.reflected + self.transmitted + self.absorbed
    }

    fn balance(&self) -> bool {
        u64::try_from(self.in_flight).is_ok_and(|in_flight| self.launched == self.ended() + in_flight)
    }
}

/// Words of one dispatch's ledger.
pub(crate) const LEDGER: usize = 6;

impl fmt::Display for Books {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { launched, reflected, transmitted, absorbed, in_flight } = self;
        write!(
            f,
            "{launched} photons launched, {reflected} reflected, {transmitted} transmitted, {absorbed} absorbed, {in_flight} in flight"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn photons_in_flight_are_carried_from_dispatch_to_dispatch() {
        let mut books = Books::default();
        books.enter(&[9, 9, 2, 1, 0, 6]).unwrap();
        books.enter(&[0, 0, 0, 3, 1, 4_u32.wrapping_neg()]).unwrap();
        assert_eq!(books, Books { launched: 9, reflected: 2, transmitted: 4, absorbed: 1, in_flight: 2 });
    }

    #[test]
    fn lost_and_invented_photons_are_refused() {
        for ledger in [[9, 9, 2, 1, 0, 5], [9, 9, 2, 2, 0, 6], [0, 0, 1, 0, 0, u32::MAX]] {
            assert!(matches!(Books::default().enter(&ledger), Err(GpuTraceError::Books(_))));
        }
    }
}
