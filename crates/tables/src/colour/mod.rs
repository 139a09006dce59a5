//! Phase functions in linear sRGB, through the CIE 1931 colour matching functions.
