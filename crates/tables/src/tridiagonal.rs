//! Symmetric tridiagonal systems by elimination (Thomas's algorithm): for matrices that need no pivots, such as those of
//! least squares over hat functions.

/// x of `diagonal[i]` x_i + `beside[i-1]` x_{i-1} + `beside[i]` x_{i+1} = `right[i]`; `beside` is one shorter.
pub(crate) fn solve(mut diagonal: Vec<f64>, beside: &[f64], right: Vec<f64>) -> Vec<f64> {
    let mut x = right;
    for i in 1..x.len() {
        let factor = beside[i - 1] / diagonal[i - 1];
        diagonal[i] -= factor * beside[i - 1];
        x[i] -= factor * x[i - 1];
    }
    for i in (0..x.len()).rev() {
        let next = if i + 1 < x.len() { beside[i] * x[i + 1] } else { 0.0 };
        x[i] = (x[i] - next) / diagonal[i];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_solution_fulfils_the_system() {
        let (diagonal, beside) = (vec![2.0, 3.0, 4.0, 3.5, 1.0], [0.5, -1.0, 0.25, 0.75]);
        let right = vec![1.0, -2.0, 0.5, 3.0, 0.25];
        let x = solve(diagonal.clone(), &beside, right.clone());
        for i in 0..5 {
            let before = if i > 0 { beside[i - 1] * x[i - 1] } else { 0.0 };
            let after = if i < 4 { beside[i] * x[i + 1] } else { 0.0 };
            assert!((diagonal[i] * x[i] + before + after - right[i]).abs() < 1e-14, "{i}");
        }
    }
}
