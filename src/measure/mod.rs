//! Time against error: relief methods over maps and views, each judged by the reference in f64.
//!
//! ```text
//! Subject  --View-->    rays            a window of parallel rays at one elevation
//! Method   --Tracer-->  outcomes        time, taken in turns with the other methods
//! outcomes --Errors-->  Row             against `first_hit`
//! rows     --report-->  table, CSV
//! rows     --plot-->    SVG, PNG        error against time, and against loads
//! rows     --recommend-->  a sentence   the fastest that is good enough
//! ```
//!
//! Exact methods are also attacked: [`attack`] traces as many rays as there is time for, made to make them fail.

mod adversary;
mod errors;
mod histogram;
mod judge;
mod maps;
mod plot;
mod pyramids;
mod recommend;
mod report;
mod row;
mod run;
mod slope;
mod subject;
mod times;
mod view;

pub use adversary::{Attack, Verdict, attack, table as verdicts};
pub use errors::{Errors, Spread};
pub use histogram::Histogram;
pub use judge::{Fault, Judge};
pub use maps::{BuiltIn, MAPS, UnknownMap};
pub use plot::{Cost, Plot, PlotError};
pub use pyramids::{Built, Spent, pyramids, pyramids_csv, pyramids_table};
pub use recommend::{Candidate, Recommendation, recommend};
pub use report::{blocks, csv, table};
pub use row::Row;
pub use run::{BASELINE, Plan, measure};
pub use subject::{Subject, SubjectError, read};
pub use view::View;
