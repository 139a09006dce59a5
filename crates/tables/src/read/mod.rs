//! Reading phase tables of other programs.
