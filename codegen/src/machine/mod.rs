//! Evaluates naga IR on the CPU, generic over the number domain.
//!
//! A node is written once, in WGSL, and runs here in several arithmetics ([`Domain`]): as the shader computes it
//! ([`F32`]), as the reference ([`F64`]), as the set of what a conforming GPU may give ([`Accept`]). Every call also
//! counts operations ([`Counts`]): cost without a clock. A [`Probe`] runs the same function on a GPU, to be judged.
//!
//! # How it runs
//! A function is compiled once to a `Program`: each scalar has a dense register, and swizzles,
//! constructors and member accesses are resolved to registers before anything runs. A call evaluates many points per
//! step: a register holds one scalar of a few hundred points (lanes), or one for all of them while it does not vary.
//! Control flow works on sets of lanes: both sides of a branch run, each on its lanes; a loop runs until its last lane
//! has left. A called function sees its active lanes closed up, so its arithmetic is dense again.
//!
//! A value that is the same for all points is computed once: that saves a fifth of the time of a surface of noises,
//! where seeds, octaves and amplitudes are such.
//!
//! In an abstract domain a condition may be open. Then the lane takes both sides, one after the other, from the same
//! state, and wherever paths meet (behind a branch, a loop, a turn of a loop, at the return) their states are joined.
//! So a counted loop stays counted even if a lane may have left it. A lane that may have left a loop a thousand turns
//! ago is let go with a state of which nothing is known.
//!
//! # What it promises
//! The value of a lane does not depend on the other lanes, and has the same bits on every platform: transcendental
//! functions come from `libm`. What is not supported is an error that names it, and a loop that does not end is one
//! too. An index outside an array is clamped to it.

mod compile;
mod count;
pub mod domain;
mod error;
mod image;
pub mod probe;
mod program;
mod run;
mod texture;
mod value;

use naga::Module;
use naga::valid::ModuleInfo;

pub use self::count::Counts;
pub use self::domain::{Accept, Domain, F32, F64};
pub use self::error::MachineError;
pub use self::image::{Image, Images, Sampler, Wrap};
pub use self::probe::Probe;
use self::program::Program;
use self::run::Run;
pub use self::texture::{Count, Footprint, Load, NoTextures, Region, Sample, Textures, Within};
pub use self::value::{Component, Value};

/// A module, ready to be called in any domain.
pub struct Machine<'a> {
    /// By the index of naga's function.
    programs: Vec<Result<Program, MachineError>>,
    names: Vec<Option<String>>,
    /// The host's id of each global variable.
    bindings: Vec<u32>,
    globals: Vec<Option<String>>,
    textures: &'a dyn Textures,
    iteration_limit: u32,
    chunk: usize,
}

impl<'a> Machine<'a> {
    /// Compiles all functions of a valid module. Those that cannot be fail when they are called.
    pub fn new(module: &Module, info: &ModuleInfo, textures: &'a dyn Textures) -> Self {
        let mut programs = Vec::new();
        for (handle, function) in module.functions.iter() {
            let program = compile::compile(module, &info[handle], function, &programs);
            programs.push(program);
        }
        let globals: Vec<_> = module.global_variables.iter().map(|(_, variable)| variable.name.clone()).collect();
        let names = module.functions.iter().map(|(_, function)| function.name.clone()).collect();
        Self {
            programs,
            names,
            bindings: vec![0; globals.len()],
            globals,
            textures,
            iteration_limit: 1 << 16,
            chunk: 512,
        }
    }

    /// How often a loop may turn before it counts as endless; 65536 unless set.
    pub fn set_iteration_limit(&mut self, limit: u32) {
        self.iteration_limit = limit;
    }

    /// How many points each instruction works on at a time; 512 unless set. Results do not depend on it.
    pub fn set_chunk(&mut self, points: usize) {
        self.chunk = points.max(1);
    }

    /// Gives a texture or sampler variable the host's id; 0 unless set.
    ///
    /// # Errors
    /// If there is no such variable.
    pub fn bind(&mut self, variable: &str, id: u32) -> Result<(), MachineError> {
        let found = self.globals.iter().position(|name| name.as_deref() == Some(variable));
        let index = found.ok_or_else(|| MachineError::UnknownGlobal { name: variable.to_owned() })?;
        self.bindings[index] = id;
        Ok(())
    }

    /// Whether a function can be evaluated.
    ///
    /// # Errors
    /// Why it cannot.
    pub fn supports(&self, function: &str) -> Result<(), MachineError> {
        self.program(function).map(|_| ())
    }

    fn program(&self, function: &str) -> Result<(usize, &Program), MachineError> {
        let found = self.names.iter().position(|name| name.as_deref() == Some(function));
        let index = found.ok_or_else(|| MachineError::UnknownFunction { name: function.to_owned() })?;
        let program = self.programs[index].as_ref().map_err(Clone::clone)?;
        Ok((index, program))
    }

    /// The result of a function at `points` points, and what it cost.
    ///
    /// # Errors
    /// If the function is unknown or cannot be evaluated, or the arguments are not what it takes.
    pub fn call<D: Domain>(
        &self,
        function: &str,
        arguments: &[Value<D>],
        points: usize,
    ) -> Result<(Value<D>, Counts), MachineError> {
        let (index, program) = self.program(function)?;
        check(program, arguments, points)?;
        let mut result = run::empty(program);
        let mut run = Run::new(self);
        for start in (0..points).step_by(self.chunk) {
            run.chunk(index, arguments, start..points.min(start + self.chunk), &mut result)?;
        }
        Ok((result, run.counts))
    }
}

/// Whether the arguments have the types of the parameters, and one scalar for each point or for all.
fn check<D: Domain>(program: &Program, arguments: &[Value<D>], points: usize) -> Result<(), MachineError> {
    let wrong = |parameter, expected: String, found: String| MachineError::Argument {
        function: program.name.clone(),
        parameter,
        expected,
        found,
    };
    if arguments.len() != program.parameters.len() {
        return Err(MachineError::Arity {
            function: program.name.clone(),
            expected: program.parameters.len(),
            found: arguments.len(),
        });
    }
    for (i, (argument, parameter)) in arguments.iter().zip(&program.parameters).enumerate() {
        let expected: Vec<&str> = parameter.iter().map(|register| register.bank.family()).collect();
        let found: Vec<&str> = argument.components.iter().map(Component::family).collect();
        if expected != found {
            return Err(wrong(i, format!("({})", expected.join(", ")), format!("({})", found.join(", "))));
        }
        if let Some(lanes) = argument.components.iter().filter_map(Component::lanes).find(|lanes| *lanes != points) {
            return Err(wrong(i, format!("for {points} points"), format!("for {lanes}")));
        }
    }
    Ok(())
}
