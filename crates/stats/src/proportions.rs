//! Whether counts of hits agree, without any normal approximation.
//!
//! Of n trials that hit with probability p, the chance of a share x or further from p on that side is at most
//! e^{-n D(x‖p)}, D the relative entropy of two coins (Chernoff 1952; Hoeffding 1963, J. Am. Stat. Assoc. 58, theorem 1).
//! The same holds for n drawn without replacement from a heap whose share is p (Hoeffding 1963, section 6), which is what
//! one of two samples is to both together if they agree. Twice that bounds the two-sided p-value for any counts,
//! none or all included; at p-values of 1e-8 a difference must be a tenth larger than by normal theory
//! to be seen, where one sample is much the larger; between samples of equal size, 1.5 times (the finite heap is not used).

/// Hits of a number of trials.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hits {
    /// How many hit.
    pub hits: u64,
    /// Of how many; at least 1 and not fewer than `hits`.
    pub trials: u64,
}

impl Hits {
    /// The share that hit.
    pub fn share(&self) -> f64 {
        self.hits as f64 / self.trials as f64
    }
}

/// A bound of the two-sided p-value of `sample`, if each trial hits with probability `p`.
///
/// `None` if there are no trials, fewer than hits, or `p` is no probability.
pub fn p_value_of_share(sample: Hits, p: f64) -> Option<f64> {
    if sample.trials == 0 || sample.hits > sample.trials || !(0.0..=1.0).contains(&p) {
        return None;
    }
    let exponent = sample.trials as f64 * relative_entropy(sample.share(), p);
    Some((2.0 * libm::exp(-exponent)).min(1.0))
}

/// A bound of the two-sided p-value of two samples, if the probability of a hit is the same in both.
///
/// `None` if one of them has no trials, or fewer than hits.
pub fn p_value_of_two(a: Hits, b: Hits) -> Option<f64> {
    let (smaller, larger) = if a.trials <= b.trials { (a, b) } else { (b, a) };
    if smaller.trials == 0 || larger.hits > larger.trials {
        return None;
    }
    let both = Hits { hits: a.hits + b.hits, trials: a.trials + b.trials };
    p_value_of_share(smaller, both.share())
}

/// D(x‖p) = x ln(x/p) + (1-x) ln((1-x)/(1-p)).
fn relative_entropy(x: f64, p: f64) -> f64 {
    let term = |x: f64, p: f64| if x == 0.0 { 0.0 } else { x * libm::log(x / p) };
    if x == p { 0.0 } else { (term(x, p) + term(1.0 - x, 1.0 - p)).max(0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Purpose, family_threshold, key, photon_stream};
    use rand::Rng;

    fn draw(index: u64, p: f64, trials: u64) -> Hits {
        let mut rng = photon_stream(key(11, Purpose::Calibration), index);
        let below = (p * 4_294_967_296.0) as u64;
        Hits { hits: (0..trials).filter(|_| u64::from(rng.next_u32()) < below).count() as u64, trials }
    }

    /// P(no hit in n) = (1-p)^n, and of all n = p^n: the one-sided bound is exact there.
    #[test]
    fn the_bound_is_exact_where_nothing_or_everything_hits() {
        let none = p_value_of_share(Hits { hits: 0, trials: 20 }, 0.3).unwrap();
        assert!((none - 2.0 * libm::pow(0.7, 20.0)).abs() < 1e-15);
        let all = p_value_of_share(Hits { hits: 20, trials: 20 }, 0.3).unwrap();
        assert!((all / (2.0 * libm::pow(0.3, 20.0)) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn equals_agree_and_what_cannot_be_does_not() {
        let same = Hits { hits: 250, trials: 1000 };
        assert_eq!(p_value_of_share(same, 0.25).unwrap(), 1.0);
        assert_eq!(p_value_of_two(same, Hits { hits: 25_000, trials: 100_000 }).unwrap(), 1.0);
        assert_eq!(p_value_of_two(Hits { hits: 0, trials: 9 }, Hits { hits: 0, trials: 99 }).unwrap(), 1.0);
        assert_eq!(p_value_of_share(Hits { hits: 1, trials: 1000 }, 0.0).unwrap(), 0.0);
        assert_eq!(p_value_of_share(Hits { hits: 999, trials: 1000 }, 1.0).unwrap(), 0.0);
    }

    #[test]
    fn what_is_no_sample_is_refused() {
        let sound = Hits { hits: 3, trials: 9 };
        for (hits, trials) in [(0, 0), (10, 9)] {
            assert_eq!(p_value_of_share(Hits { hits, trials }, 0.5), None);
            assert_eq!(p_value_of_two(Hits { hits, trials }, sound), None);
            assert_eq!(p_value_of_two(sound, Hits { hits, trials }), None);
        }
        assert!([f64::NAN, -0.1, 1.1].into_iter().all(|p| p_value_of_share(sound, p).is_none()));
    }

    /// 2000 pairs of each kind that agree, at α = 0.05: at most 100 alarms expected (the bound is no equality), 140 are four
    /// standard deviations beyond. Thin counts, for which normal theory fails, are among them.
    #[test]
    fn the_false_alarm_rate_is_at_most_as_stated() {
        for (kind, p) in [0.5, 0.01, 0.001].into_iter().enumerate() {
            let alarms = (0..2000_u64)
                .filter(|i| {
                    let index = 10_000 * kind as u64 + 2 * i;
                    p_value_of_two(draw(index, p, 300), draw(index + 1, p, 3000)).unwrap() < 0.05
                })
                .count();
            assert!(alarms <= 140, "p = {p}: {alarms} of 2000");
        }
    }

    /// A shift of 1.5 thresholds is always seen; the normal threshold at this rate is 5.7.
    #[test]
    fn a_planted_difference_just_above_the_threshold_is_rejected() {
        let alpha = 1e-8;
        let trials = 100_000;
        let std_error = (0.25 / trials as f64).sqrt();
        let at = |sigmas: f64| Hits { hits: ((0.5 + sigmas * std_error) * trials as f64) as u64, trials };
        let normal = family_threshold(alpha, 1).unwrap();
        assert!(p_value_of_share(at(normal), 0.5).unwrap() > alpha);
        assert!(p_value_of_share(at(1.1 * normal), 0.5).unwrap() < alpha);
        assert!(p_value_of_share(at(-1.1 * normal), 0.5).unwrap() < alpha);
        let stored = Hits { hits: 50_000_000, trials: 100_000_000 };
        assert!(p_value_of_two(at(1.1 * normal), stored).unwrap() < alpha);
    }
}
