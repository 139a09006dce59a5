//! What holds between the crates: the tests are in `tests/`.
