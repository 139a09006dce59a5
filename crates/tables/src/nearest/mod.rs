//! The nearest analytic phase functions, with their measured error.
