//! Time against error: relief methods over maps and views, each judged by the reference in f64.
//!
//! ```text
//! Subject  --view-->   rays        a window of parallel rays at one elevation
//! Method   --Tracer--> outcomes    time, taken in turns with the other methods
//! outcomes --judge-->  Errors      against `first_hit`
//! all      --report--> table, CSV
//! ```

mod errors;
mod report;
mod run;
mod subject;
mod view;

pub use errors::Errors;
pub use report::{csv, table};
pub use run::{Plan, Row, measure};
pub use subject::{Subject, SubjectError, built_in, read};
pub use view::View;
