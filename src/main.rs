//! The command line of Terrane.
fn main() {}
