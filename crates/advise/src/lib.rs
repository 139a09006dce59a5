//! The cheapest method that meets a budget, from chart data on disk.
