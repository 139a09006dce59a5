//! Which of ascending nodes is the last at or below x: a table of starting places instead of a search.
//!
//! The range of the nodes is cut into equal buckets, each of which knows the node at its lower edge; from there a few steps lead to
//! the node sought (Chen & Asau 1974). The answer is that of a binary search, whatever rounding does to the bucket.

/// Buckets per node.
const DENSITY: usize = 8;

/// Starting places for one list of nodes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Guide {
    first: f64,
    /// Buckets per unit of x.
    scale: f64,
    starts: Vec<u32>,
}

impl Guide {
    /// For `nodes` that do not fall, two at least.
    pub(super) fn new(nodes: &[f64]) -> Self {
        let (first, last) = (nodes[0], nodes[nodes.len() - 1]);
        let buckets = DENSITY * nodes.len();
        let width = (last - first) / buckets as f64;
        let start = |bucket: usize| search(nodes, first + width * bucket as f64) as u32;
        Self { first, scale: 1.0 / width, starts: (0..=buckets).map(start).collect() }
    }

    /// The last place i with `nodes[i]` ≤ `x`; 0 if there is none, and some place for NaN.
    pub(super) fn place(&self, nodes: &[f64], x: f64) -> usize {
        // A cast takes what is below the nodes, and NaN, to bucket 0.
        let bucket = ((x - self.first) * self.scale) as usize;
        let mut place = self.starts[bucket.min(self.starts.len() - 1)] as usize;
        while place > 0 && nodes[place] > x {
            place -= 1;
        }
        while place + 1 < nodes.len() && nodes[place + 1] <= x {
            place += 1;
        }
        place
    }
}

fn search(nodes: &[f64], x: f64) -> usize {
    nodes.partition_point(|node| *node <= x).saturating_sub(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Graded nodes with repetitions, at the nodes, beside them, between them, and outside.
    #[test]
    fn the_place_is_that_of_a_search() {
        let graded: Vec<f64> = (0..300).map(|i| libm::pow(f64::from(i / 2) / 149.0, 3.0)).collect();
        for nodes in [graded, vec![0.0, 1.0], vec![0.0, 0.0, 1.0, 1.0], vec![-2.0, 1e-300, 1e-299, 3.0]] {
            let guide = Guide::new(&nodes);
            let ends = [f64::NEG_INFINITY, -1.0, 0.0, 2.0, f64::INFINITY];
            let around = nodes.iter().flat_map(|x| [x.next_down(), *x, x.next_up(), x + 1e-3]);
            for x in around.chain(ends) {
                assert_eq!(guide.place(&nodes, x), search(&nodes, x), "{x}");
            }
            assert!(guide.place(&nodes, f64::NAN) < nodes.len());
        }
    }
}
