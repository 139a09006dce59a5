//! Which numbers a colour map spans.

use super::Colours;
use crate::Grey;

/// Colours for [0, most] or [-most, most].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Which.
    pub colours: Colours,
    /// Positive.
    pub most: f64,
}

impl Scale {
    /// Up to 1, 2 or 5 times a power of ten, at least the 99th percentile of the values' size; up to 1 where all are 0.
    pub fn covering(colours: Colours, values: &Grey) -> Self {
        let mut sizes: Vec<f64> = values.values().iter().map(|value| f64::from(value.abs())).collect();
        sizes.sort_by(f64::total_cmp);
        let size = sizes[(sizes.len() - 1) * 99 / 100];
        let size = if size > 0.0 { size } else { sizes[sizes.len() - 1] };
        Self { colours, most: if size > 0.0 { round_up(size) } else { 1.0 } }
    }

    /// The least number.
    pub fn least(&self) -> f64 {
        match self.colours {
            Colours::Sequential => 0.0,
            Colours::Diverging => -self.most,
        }
    }

    /// The colour of `value`.
    pub fn colour(&self, value: f64) -> [u8; 3] {
        self.colours.of(value / self.most)
    }
}

fn round_up(size: f64) -> f64 {
    let exponent = libm::floor(libm::log10(size));
    let step = |factor: f64, exponent: f64| {
        // Division by a whole power is exact to the last digit, so that 0.02 prints as such.
        let power = libm::pow(10.0, libm::fabs(exponent));
        if exponent < 0.0 { factor / power } else { factor * power }
    };
    [(1.0, exponent), (2.0, exponent), (5.0, exponent)]
        .into_iter()
        .map(|(factor, exponent)| step(factor, exponent))
        .find(|candidate| *candidate >= size * (1.0 - 1e-9))
        .unwrap_or_else(|| step(1.0, exponent + 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_end_at_round_numbers() {
        for (size, end) in
            [(0.013, 0.02), (0.02, 0.02), (3e-5, 5e-5), (0.7, 1.0), (6.0, 10.0), (150.0, 200.0)]
        {
            assert_eq!(round_up(size), end, "{size}");
        }
        let values = Grey::new(2, 1, vec![-0.3, 0.1]).unwrap();
        assert_eq!(Scale::covering(Colours::Diverging, &values).least(), -0.2);
        let none = Grey::new(1, 1, vec![0.0]).unwrap();
        assert_eq!(Scale::covering(Colours::Sequential, &none).most, 1.0);
    }
}
