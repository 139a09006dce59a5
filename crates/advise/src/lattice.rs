//! Linear interpolation on a lattice some of whose nodes may be missing.

/// Rows at the nodes of a tensor of axes.
#[derive(Clone, Debug)]
pub(crate) struct Lattice {
    axes: Vec<Vec<f64>>,
    /// Row at each node, the last axis fastest.
    rows: Vec<Option<usize>>,
}

impl Lattice {
    /// From the coordinates of each row; every list is as long as the first.
    pub(crate) fn new(places: &[(usize, Vec<f64>)]) -> Self {
        let count = places.first().map_or(0, |(_, at)| at.len());
        let axis = |i: usize| {
            let mut values: Vec<f64> = places.iter().map(|(_, at)| at[i]).collect();
            values.sort_by(f64::total_cmp);
            values.dedup();
            values
        };
        let axes: Vec<Vec<f64>> = (0..count).map(axis).collect();
        let mut rows = vec![None; axes.iter().map(Vec::len).product()];
        for (row, at) in places {
            let node = axes.iter().zip(at).map(|(axis, x)| axis.partition_point(|node| node < x));
            rows[flat(&axes, node)] = Some(*row);
        }
        Self { axes, rows }
    }

    /// The values of an axis.
    pub(crate) fn axis(&self, place: usize) -> &[f64] {
        self.axes.get(place).map_or(&[], Vec::as_slice)
    }

    /// Rows round a place, with weights that add up to 1 if none is missing. Beyond an end its value counts.
    pub(crate) fn around(&self, at: &[f64]) -> Vec<(usize, f64)> {
        let spans: Vec<(usize, f64)> = self.axes.iter().zip(at).map(|(axis, x)| span(axis, *x)).collect();
        let mut corners = Vec::new();
        for corner in 0..1_usize << spans.len() {
            let upper = |axis: usize| corner >> axis & 1;
            let weight = spans.iter().enumerate().fold(1.0, |weight, (i, (_, share))| {
                weight * if upper(i) == 1 { *share } else { 1.0 - share }
            });
            if weight > 0.0 {
                let node = spans.iter().enumerate().map(|(i, (low, _))| low + upper(i));
                corners.extend(self.rows[flat(&self.axes, node)].map(|row| (row, weight)));
            }
        }
        corners
    }
}

/// The node below `x` and how far `x` lies towards the next.
fn span(axis: &[f64], x: f64) -> (usize, f64) {
    let low = axis.partition_point(|node| *node <= x).saturating_sub(1);
    match axis.get(low + 1) {
        Some(next) if x > axis[low] => (low, (x - axis[low]) / (next - axis[low])),
        _ => (low, 0.0),
    }
}

fn flat(axes: &[Vec<f64>], node: impl Iterator<Item = usize>) -> usize {
    axes.iter().zip(node).fold(0, |place, (axis, i)| place * axis.len() + i)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_linear_is_exact_and_missing_nodes_leave_the_rest() {
        let value = |at: &[f64]| 1.0 + 2.0 * at[0] - 3.0 * at[1];
        let places: Vec<(usize, Vec<f64>)> =
            [0.0, 1.0, 4.0].iter().flat_map(|x| [0.0, 2.0].map(|y| vec![*x, y])).enumerate().collect();
        let lattice = Lattice::new(&places);
        let sum = |at: &[f64]| {
            lattice.around(at).iter().fold(0.0, |sum, (row, weight)| sum + weight * value(&places[*row].1))
        };
        for at in [[0.0, 0.0], [0.5, 0.7], [3.0, 2.0], [4.0, 1.0]] {
            assert!((sum(&at) - value(&at)).abs() < 1e-12, "{at:?}");
        }
        assert_eq!(sum(&[9.0, 0.0]), value(&[4.0, 0.0]));
        let thinned = Lattice::new(&places[1..]);
        assert!(
            (thinned.around(&[0.5, 0.0]).iter().map(|(_, weight)| weight).sum::<f64>() - 0.5).abs() < 1e-12
        );
    }
}
