//! One value for all channels, or one each.

use crate::predict::{Points, Prediction, predict};
use crate::{Budget, Channels, Data};

/// What a method promises with the channels it needs: one value where that is within the budget or there is one wavelength.
pub(crate) fn channels(
    data: &Data,
    points: &Points,
    column: usize,
    budget: &Budget,
    wavelengths: usize,
) -> (Channels, Prediction) {
    let coloured = predict(data, points, column, false);
    if wavelengths == 1 {
        return (Channels::Grey, coloured);
    }
    let grey = predict(data, points, column, true);
    if budget.max_error.is_some() && budget.allows_error(grey.error) {
        (Channels::Grey, grey)
    } else if wavelengths > 1 {
        (Channels::Rgb, coloured)
    } else {
        (Channels::Grey, grey)
    }
}
