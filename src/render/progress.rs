//! What the user sees while he waits, and how long each phase took.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Where progress goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// Bars on stderr, as long as it is a terminal.
    Stderr,
    /// Nowhere.
    Hidden,
}

/// A long piece of work; ends when dropped.
#[derive(Debug)]
pub struct Phase {
    name: &'static str,
    bar: ProgressBar,
    start: Instant,
}

impl Progress {
    /// Begins a piece of work of `steps` steps.
    #[must_use]
    pub fn phase(self, name: &'static str, steps: u64) -> Phase {
        let target = match self {
            Self::Stderr => ProgressDrawTarget::stderr(),
            Self::Hidden => ProgressDrawTarget::hidden(),
        };
        let style = ProgressStyle::with_template("{msg:20} {bar:40} {percent:>3} % {elapsed:>5}")
            .unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = ProgressBar::with_draw_target(Some(steps), target).with_style(style).with_message(name);
        bar.enable_steady_tick(Duration::from_millis(200));
        Phase { name, bar, start: Instant::now() }
    }
}

impl Phase {
    /// Some steps are done.
    pub fn advance(&self, steps: u64) {
        self.bar.inc(steps);
    }
}

impl Drop for Phase {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
        log::debug!("{}: {:.3} s", self.name, self.start.elapsed().as_secs_f64());
    }
}
