//! The flags of a row in words.

use crate::chart::html as rich;
use maud::{Markup, html};
use stratiform_artifact::Flag;

fn words(flag: Flag) -> &'static str {
    match flag {
        Flag::CNotIdentifiable => {
            "the data do not determine c: b is near 1, or the misfit hides c's influence; the value emitted is interpolated or the \
             best found"
        }
        Flag::BOnBound => "b sits on a bound of the fit",
        Flag::COnBound => "c sits on a bound of the fit",
        Flag::KappaCOnBound => "κ_{c} sits on a bound of the fit",
        Flag::TOnBound => "t sits on a bound of the fit",
        Flag::ROnBound => "r sits on a bound of the fit",
        Flag::BetaFixed => "β was taken from the other rows, not fitted here",
        Flag::NegativeT3Plus => "the fitted model's T_{3+} is negative (below −0.001) at some thickness",
        Flag::NegativeR3Plus => "the fitted model's R_{3+} is negative (below −0.001) at some thickness",
        Flag::OutsideUnitInterval => "the fitted model leaves [0, 1] at some thickness",
        Flag::NotConverged => "the optimiser stopped before it converged",
    }
}

/// Notes numbered as in the table, each flag once.
pub fn list(flags: &[Flag]) -> Markup {
    html! {
        @if flags.is_empty() { p { "No row carries a flag." } }
        @else { ol class="flags" { @for flag in flags { li { (rich(words(*flag))) } } } }
    }
}
