//! The page `report.html`: one file without scripts and without references to other files.

mod agreement;
mod angular;
mod appendix;
mod details;
mod flags;
mod glossary;
mod ladder;
mod number;
mod optics;
mod provenance;
mod why;

use crate::LeftOut;
use crate::chart::{Figure, html as rich};
use crate::input::Inputs;
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("style.css");

/// The page as text.
pub fn render(inputs: &Inputs, figures: &[Figure], left_out: &[LeftOut]) -> String {
    let title = format!("Stratiform: {}", inputs.optics.droplets);
    let named = |prefix: &'static str| figures.iter().filter(move |f| f.name.starts_with(prefix));
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                header { h1 { (title) } (provenance::lead(inputs)) }
                (contents())
                main {
                    (absences(left_out))
                    section id="appendix" {
                        h2 { @if inputs.published.is_some() { "The regenerated Appendix B" } @else { "The fitted parameters" } }
                        (appendix::tables(inputs))
                        (drawn(named("parameters")))
                    }
                    section id="misfit" {
                        h2 { "How well the model fits" }
                        (appendix::misfits(inputs))
                        (drawn(named("misfit")))
                    }
                    section id="ladder" {
                        h2 { "What each approximation loses" }
                        (ladder::section(inputs.ladder.as_deref()))
                        (drawn(named("ladder")))
                    }
                    section id="agreement" {
                        h2 { "Solver against photons" }
                        (agreement::section(inputs))
                        (drawn(named("agreement")))
                    }
                    section id="orders" { h2 { "Scattering orders" } (drawn(named("orders"))) }
                    section id="radiance" { h2 { "The energy of the angular model" } (angular::section(inputs.angular_books.as_deref())) }
                    section id="plane" { h2 { "Radiance in the plane of the sun" } (drawn(named("plane"))) }
                    section id="why" { h2 { @if inputs.published.is_some() { "Why the published table differs" } @else { "The modified medium" } } (why::section(inputs)) }
                    section id="optics" {
                        h2 { "Droplets and phase functions" }
                        (optics::table(&inputs.optics))
                        (drawn(named("droplet")))
                        (drawn(named("phase")))
                    }
                    section id="convergence" { h2 { "Convergence" } (drawn(named("convergence"))) (drawn(named("solver-cost"))) (drawn(named("quadrature"))) }
                    section id="numbers" { h2 { "All numbers" } (details::tables(inputs)) }
                    section id="glossary" { h2 { "Symbols and units" } (glossary::list()) }
                    section id="provenance" { h2 { "Provenance" } (provenance::table(inputs)) }
                }
            }
        }
    };
    page.into_string()
}

fn contents() -> Markup {
    const SECTIONS: [(&str, &str); 13] = [
        ("#appendix", "Parameters"),
        ("#misfit", "Misfit"),
        ("#ladder", "Ladder"),
        ("#agreement", "Agreement"),
        ("#orders", "Scattering orders"),
        ("#radiance", "Radiance"),
        ("#plane", "Plane of the sun"),
        ("#why", "Medium and reasons"),
        ("#optics", "Optics"),
        ("#convergence", "Convergence"),
        ("#numbers", "All numbers"),
        ("#glossary", "Symbols"),
        ("#provenance", "Provenance"),
    ];
    html! { nav { @for (target, name) in SECTIONS { a href=(target) { (name) } " " } } }
}

fn absences(left_out: &[LeftOut]) -> Markup {
    html! {
        @if !left_out.is_empty() {
            aside {
                p { "This page lacks:" }
                ul { @for item in left_out { li { (item.what) " (no file " code { (item.file) } ")" } } }
            }
        }
    }
}

fn drawn<'a>(figures: impl Iterator<Item = &'a Figure>) -> Markup {
    let mut figures = figures.peekable();
    html! {
        @if figures.peek().is_none() { p { "No figure: its data are not in the folder." } }
        @for figure in figures {
            figure id={ "figure-" (figure.name) } {
                div class="drawing" { (figure.draw()) }
                figcaption { (rich(&figure.caption)) " File: " code { "figures/" (figure.name) ".svg" } "." }
            }
        }
    }
}
