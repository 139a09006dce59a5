//! Containers: CSV, JSON, npz, EXR, KTX2.
