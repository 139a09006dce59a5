//! The truth of a picture: paths of light through the height field, traced backwards, with an error for every pixel.
