//! Time against error: relief methods over maps and views, each judged by the reference in f64.
//!
//! ```text
//! Subject  --view-->   rays        a window of parallel rays at one elevation
//! Method   --Tracer--> outcomes    time, taken in turns with the other methods
//! outcomes --judge-->  Errors      against `first_hit`
//! all      --report--> table, CSV
//! ```
//!
//! Exact methods are also attacked: [`attack`] traces as many rays as there is time for, made to make them fail.

mod adversary;
mod errors;
mod judge;
mod report;
mod run;
mod spread;
mod subject;
mod view;

pub use adversary::{Attack, Verdict, attack, table as verdicts};
pub use errors::Errors;
pub use judge::{Fault, Judge};
pub use report::{csv, table};
pub use run::{Plan, Row, measure};
pub use spread::Spread;
pub use subject::{Subject, SubjectError, built_in, read};
pub use view::View;
