//! The text of a probe: values taken apart to words and put together again.

use std::fmt::Write as _;

use naga::{ArraySize, Handle, ImageClass, ImageDimension, Module, Scalar, ScalarKind, Type, TypeInner, VectorSize};

use super::{Probe, Resource};
use crate::machine::error::MachineError;

type Result<T> = std::result::Result<T, MachineError>;

/// Writes a probe of one function.
pub(super) struct Text<'a> {
    module: &'a Module,
    function: &'a str,
    /// Words read so far.
    inputs: usize,
    resources: Vec<(Resource, String)>,
    /// An expression for each word of the result.
    outputs: Vec<String>,
}

impl<'a> Text<'a> {
    pub(super) fn new(module: &'a Module, function: &'a str) -> Self {
        Self { module, function, inputs: 0, resources: Vec::new(), outputs: Vec::new() }
    }

    fn unsupported<T>(&self, ty: &TypeInner) -> Result<T> {
        let construct = format!("a value of type {ty:?}");
        Err(MachineError::Unsupported { function: self.function.to_owned(), construct })
    }

    /// The expression of an argument, read from the next words.
    fn argument(&mut self, handle: Handle<Type>) -> Result<String> {
        let module = self.module;
        let ty = &module.types[handle];
        match ty.inner {
            TypeInner::Image { .. } | TypeInner::Sampler { .. } => self.resource(&ty.inner),
            TypeInner::Struct { ref members, .. } => {
                let parts = members.iter().map(|member| self.argument(member.ty)).collect::<Result<Vec<_>>>()?;
                Ok(format!("{}({})", ty.name.clone().unwrap_or_default(), parts.join(", ")))
            }
            TypeInner::Array { base, size: ArraySize::Constant(count), .. } => {
                let parts = (0..count.get()).map(|_| self.argument(base)).collect::<Result<Vec<_>>>()?;
                Ok(format!("array({})", parts.join(", ")))
            }
            ref inner => {
                let (name, scalars, scalar) = self.numbers(inner)?;
                let words: Vec<String> = (0..scalars).map(|_| self.read(scalar)).collect();
                Ok(format!("{name}({})", words.join(", ")))
            }
        }
    }

    fn read(&mut self, scalar: Scalar) -> String {
        let word = format!("probe_arguments[first + {}u]", self.inputs);
        self.inputs += 1;
        match scalar.kind {
            ScalarKind::Uint => word,
            ScalarKind::Bool => format!("{word} != 0u"),
            _ => format!("bitcast<{}>({word})", name(scalar.kind)),
        }
    }

    /// WGSL's name of a scalar, vector or matrix, and how many scalars of which kind it has.
    fn numbers(&self, inner: &TypeInner) -> Result<(String, u32, Scalar)> {
        let size = |size: VectorSize| size as u32;
        let (text, count, scalar) = match *inner {
            TypeInner::Scalar(scalar) => (name(scalar.kind).to_owned(), 1, scalar),
            TypeInner::Vector { size: n, scalar } => {
                (format!("vec{}<{}>", size(n), name(scalar.kind)), size(n), scalar)
            }
            TypeInner::Matrix { columns, rows, scalar } => {
                let (columns, rows) = (size(columns), size(rows));
                (format!("mat{columns}x{rows}<{}>", name(scalar.kind)), columns * rows, scalar)
            }
            _ => return self.unsupported(inner),
        };
        if scalar.width != 4 && scalar.kind != ScalarKind::Bool {
            return self.unsupported(inner);
        }
        Ok((text, count, scalar))
    }

    fn resource(&mut self, inner: &TypeInner) -> Result<String> {
        let (resource, ty) = match *inner {
            TypeInner::Image {
                dim: ImageDimension::D2,
                arrayed,
                class: ImageClass::Sampled { kind, multi: false },
            } => {
                let array = if arrayed { "_array" } else { "" };
                (Resource::Texture, format!("texture_2d{array}<{}>", name(kind)))
            }
            TypeInner::Sampler { comparison: false } => (Resource::Sampler, "sampler".to_owned()),
            _ => return self.unsupported(inner),
        };
        self.resources.push((resource, ty));
        Ok(format!("probe_resource_{}", self.resources.len()))
    }

    /// Takes a result apart.
    fn result(&mut self, handle: Handle<Type>, value: &str) -> Result<()> {
        let module = self.module;
        match module.types[handle].inner {
            TypeInner::Struct { ref members, .. } => {
                for member in members {
                    self.result(member.ty, &format!("{value}.{}", member.name.clone().unwrap_or_default()))?;
                }
            }
            TypeInner::Array { base, size: ArraySize::Constant(count), .. } => {
                for i in 0..count.get() {
                    self.result(base, &format!("{value}[{i}]"))?;
                }
            }
            ref inner => {
                let (_, count, scalar) = self.numbers(inner)?;
                let place = |i: u32| match *inner {
                    TypeInner::Scalar(_) => String::new(),
                    TypeInner::Matrix { rows, .. } => format!("[{}][{}]", i / rows as u32, i % rows as u32),
                    _ => format!("[{i}]"),
                };
                let words = (0..count).map(|i| word(scalar.kind, &format!("{value}{}", place(i))));
                self.outputs.extend(words);
            }
        }
        Ok(())
    }
}

fn name(kind: ScalarKind) -> &'static str {
    match kind {
        ScalarKind::Sint => "i32",
        ScalarKind::Uint => "u32",
        ScalarKind::Bool => "bool",
        _ => "f32",
    }
}

fn word(kind: ScalarKind, value: &str) -> String {
    match kind {
        ScalarKind::Uint => value.to_owned(),
        ScalarKind::Bool => format!("u32({value})"),
        _ => format!("bitcast<u32>({value})"),
    }
}

/// The whole shader.
pub(super) fn probe(
    mut text: Text<'_>,
    parameters: &[Handle<Type>],
    result: Option<Handle<Type>>,
    declarations: &str,
) -> Result<Probe> {
    let arguments = parameters.iter().map(|parameter| text.argument(*parameter)).collect::<Result<Vec<_>>>()?;
    if let Some(result) = result {
        text.result(result, "result")?;
    }
    let mut shader = String::from(declarations);
    shader += "@group(0) @binding(0) var<storage, read> probe_arguments: array<u32>;\n";
    shader += "@group(0) @binding(1) var<storage, read_write> probe_results: array<u32>;\n";
    for (i, (_, ty)) in text.resources.iter().enumerate() {
        let _ = writeln!(shader, "@group(0) @binding({}) var probe_resource_{}: {ty};", i + 2, i + 1);
    }
    let (inputs, outputs) = (text.inputs, text.outputs.len());
    let _ = writeln!(shader, "\n@compute @workgroup_size({})", Probe::WORKGROUP);
    shader += "fn probe_main(@builtin(global_invocation_id) id: vec3u) {\n";
    let _ = writeln!(
        shader,
        "    if (id.x >= arrayLength(&probe_results) / {}u) {{\n        return;\n    }}",
        outputs.max(1)
    );
    let _ = writeln!(shader, "    let first = id.x * {inputs}u;");
    let _ = writeln!(shader, "    let result = {}({});", text.function, arguments.join(", "));
    for (i, output) in text.outputs.iter().enumerate() {
        let _ = writeln!(shader, "    probe_results[id.x * {outputs}u + {i}u] = {output};");
    }
    shader += "}\n";
    let resources = text.resources.into_iter().map(|(resource, _)| resource).collect();
    Ok(Probe { function: text.function.to_owned(), shader, resources, inputs, outputs })
}
