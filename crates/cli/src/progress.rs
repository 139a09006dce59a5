//! Progress bars with rate and time left on a terminal, below each other; nothing when piped or quiet.

use indicatif::{MultiProgress, ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::LazyLock;

static BARS: LazyLock<MultiProgress> = LazyLock::new(MultiProgress::new);

/// Does what prints a line without tearing the bars.
pub fn beside_bars(print: impl FnOnce()) {
    BARS.suspend(print);
}

/// Puts `bar` below the others, or nowhere.
fn shown(bar: ProgressBar, quiet: bool) -> ProgressBar {
    if !quiet && std::io::stderr().is_terminal() {
        return BARS.add(bar);
    }
    bar.set_draw_target(ProgressDrawTarget::hidden());
    bar
}

/// A sign of life for work whose length is not known.
pub fn spinner(what: &str, quiet: bool) -> ProgressBar {
    let spinner = shown(ProgressBar::no_length().with_message(what.to_owned()), quiet);
    spinner.set_style(
        ProgressStyle::with_template("{spinner} {msg} {elapsed}")
            .unwrap_or_else(|_| ProgressStyle::default_spinner()),
    );
    spinner.enable_steady_tick(std::time::Duration::from_millis(200));
    spinner
}

/// A bar over `total` steps of `what`.
///
/// # Panics
/// Never: the template is a constant that a test exercises.
pub fn bar(total: u64, what: &str, quiet: bool) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg} [{bar:30}] {human_pos}/{human_len} {per_sec} {eta} left")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    shown(ProgressBar::new(total).with_message(what.to_owned()), quiet).with_style(style)
}
