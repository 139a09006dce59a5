//! Jobs that need one thread each, side by side.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// `job` of every item, in their order, on as many threads as the current pool has. Threads of their own: a worker of the
/// pool that waits for [`alone`](crate::cost::alone) would take up another job meanwhile, and two would share its core.
pub(crate) fn side_by_side<T: Sync, R: Send>(items: &[T], job: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let (next, done) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some((place, item)) = {
            let place = next.fetch_add(1, Ordering::Relaxed);
            items.get(place).map(|item| (place, item))
        } {
            let result = job(item);
            done.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).push((place, result));
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..rayon::current_num_threads().min(items.len()) {
            scope.spawn(work);
        }
    });
    let mut done = done.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_stand_in_the_order_of_their_items() {
        let items: Vec<u64> = (0..100).collect();
        let squares: Vec<u64> = items.iter().map(|i| i * i).collect();
        assert_eq!(side_by_side(&items, |i| i * i), squares);
        assert!(side_by_side(&[] as &[u64], |i| *i).is_empty());
    }
}
