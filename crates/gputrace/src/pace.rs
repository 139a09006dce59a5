//! How many looks at each photon one dispatch takes, by the time that the last one took.
//!
//! Long enough that its start costs nothing, short enough for a screen's watchdog and for a caller who wants to stop. The number
//! changes no result.

use std::time::Duration;

const FEWEST: u32 = 16;
/// With 16 flights each, Mesa's software driver has room for 3800.
const MOST: u32 = 2048;
const SHORT: Duration = Duration::from_millis(20);
const LONG: Duration = Duration::from_millis(80);

/// Looks of the next dispatch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace(u32);

impl Pace {
    pub fn new() -> Self {
        Self(FEWEST)
    }

    pub fn looks(self) -> u32 {
        self.0
    }

    /// The last dispatch took this long.
    pub fn took(&mut self, time: Duration) {
        if time < SHORT {
            self.0 = (2 * self.0).min(MOST);
        } else if time > LONG {
            self.0 = (self.0 / 2).max(FEWEST);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dispatches_become_neither_too_short_nor_too_long() {
        let mut pace = Pace::new();
        let settle = |pace: &mut Pace, per_look: Duration| {
            (0..20).for_each(|_| pace.took(per_look * pace.looks()));
            pace.looks()
        };
        assert_eq!(settle(&mut pace, Duration::from_micros(100)), 256);
        assert_eq!(settle(&mut pace, Duration::from_nanos(1)), MOST);
        assert_eq!(settle(&mut pace, Duration::from_secs(1)), FEWEST);
    }
}
