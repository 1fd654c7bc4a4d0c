//! What bounds cost, as values and as a table.

use std::fmt::Write as _;

use super::{Built, Spent};

/// Comma-separated values with a head line.
#[must_use]
pub fn pyramids_csv(all: &[Built]) -> String {
    let lines = all.iter().map(|one| {
        let Built { map, side, form, bounds, bytes, host: Spent { build, update }, device } = one;
        let device = device.map_or_else(|| ",".into(), |Spent { build, update }| format!("{build},{update}"));
        format!("{map},{side},{form},{bounds},{bytes},{build},{update},{device}\n")
    });
    std::iter::once("map,side,form,bounds,bytes_per_texel,time_ms,update_ms,device_ms,device_update_ms\n".to_owned())
        .chain(lines)
        .collect()
}

/// The same for the eye.
#[must_use]
pub fn pyramids_table(all: &[Built]) -> String {
    let mut text = String::from(
        "map           side  form     bounds             bytes/texel  build ms  update ms  on the device     update\n",
    );
    for Built { map, side, form, bounds, bytes, host, device } in all {
        let [build, update] = device.map_or_else(
            || ["-".into(), "-".into()],
            |times| [times.build, times.update].map(|time| format!("{time:.2}")),
        );
        let Spent { build: host_build, update: host_update } = host;
        let _ = writeln!(
            text,
            "{map:<12} {side:>5}  {form:<7}  {bounds:<17}  {bytes:>11.3}  {host_build:>8.2}  {host_update:>9.2}  {build:>13}  {update:>9}"
        );
    }
    text
}
