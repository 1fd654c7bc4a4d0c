//! The rules of the house, as tests: what a reviewer would otherwise have to look for.

mod budgets;
mod documents;
mod files;
mod graphs;
mod words;
