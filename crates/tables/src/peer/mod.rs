//! Files that other renderers and solvers load.
