// Judges WGSL with Tint, Chrome's compiler, on Dawn's null backend: full validation, no GPU, no driver.
//
//     node validate.mjs                    one request a line on stdin, one report a line on stdout
//     node validate.mjs FILE|FOLDER …      WGSL files; exit code 1 if one is refused
//
// Request: {name, wgsl, pipelines: [{name, vertex?, fragment?, compute?, layouts?}]}. `vertex` and `fragment` are
// those of a GPURenderPipelineDescriptor without `module`, `compute` likewise; `layouts` is an array of arrays of
// GPUBindGroupLayoutEntry, group by group. Every pipeline is created with the automatic layout, and once more with
// `layouts` if they are given, so that the limits of WebGPU are enforced.
// Report: {name, messages: [{type, line, column, text}], pipelines: [{name, layout: "auto"|"explicit", error}]}.

import { readFileSync, readdirSync, statSync } from 'node:fs';
import { createInterface } from 'node:readline';
import { join } from 'node:path';
import { create, globals } from 'webgpu';

Object.assign(globalThis, globals);

/** Runs `make` and gives its result beside the validation error that it caused, if any. */
async function guarded(device, make) {
  device.pushErrorScope('validation');
  let result, thrown;
  try {
    result = make();
  } catch (error) {
    thrown = error;
  }
  const error = await device.popErrorScope();
  return { result, error: thrown?.message ?? error?.message ?? null };
}

function pipelineDescriptor(module, { vertex, fragment, compute }) {
  if (compute) return { compute: { ...compute, module } };
  return {
    vertex: { ...vertex, module },
    ...(fragment && { fragment: { ...fragment, module } }),
    // Always there: a vertex stage alone needs an attachment, and a fragment stage may write depth.
    depthStencil: { format: 'depth32float', depthWriteEnabled: true, depthCompare: 'less' },
  };
}

async function createPipeline(device, module, pipeline, layout) {
  return guarded(device, () => {
    const descriptor = { ...pipelineDescriptor(module, pipeline), layout: layout ?? 'auto' };
    return pipeline.compute ? device.createComputePipeline(descriptor) : device.createRenderPipeline(descriptor);
  });
}

async function explicitLayout(device, groups) {
  return guarded(device, () => {
    const bindGroupLayouts = groups.map((entries) => device.createBindGroupLayout({ entries }));
    return device.createPipelineLayout({ bindGroupLayouts });
  });
}

async function judgePipeline(device, module, pipeline) {
  const { name, layouts } = pipeline;
  const automatic = await createPipeline(device, module, pipeline);
  const verdicts = [{ name, layout: 'auto', error: automatic.error }];
  if (layouts) {
    const { result, error } = await explicitLayout(device, layouts);
    const explicit = error ? { error } : await createPipeline(device, module, pipeline, result);
    verdicts.push({ name, layout: 'explicit', error: explicit.error });
  }
  return verdicts;
}

async function judge(device, { name, wgsl, pipelines = [] }) {
  const { result: module, error } = await guarded(device, () => device.createShaderModule({ code: wgsl }));
  const info = module ? await module.getCompilationInfo() : { messages: [] };
  const messages = info.messages.map(({ type, lineNum, linePos, message }) => ({
    type,
    line: lineNum,
    column: linePos,
    text: message,
  }));
  const refused = messages.some(({ type }) => type === 'error');
  // An error that no message tells of, such as text that is no valid Unicode.
  if (error && !refused) messages.push({ type: 'error', line: 0, column: 0, text: error });
  const verdicts = error ? [] : await Promise.all(pipelines.map((pipeline) => judgePipeline(device, module, pipeline)));
  return { name, messages, pipelines: verdicts.flat() };
}

function wgslFiles(path) {
  if (!statSync(path).isDirectory()) return [path];
  const entries = readdirSync(path, { withFileTypes: true }).sort((a, b) => (a.name < b.name ? -1 : 1));
  return entries.flatMap((entry) => {
    if (entry.isDirectory()) return wgslFiles(join(path, entry.name));
    return entry.name.endsWith('.wgsl') ? [join(path, entry.name)] : [];
  });
}

async function judgeFiles(device, paths) {
  for (const file of paths.flatMap(wgslFiles)) {
    const { messages } = await judge(device, { name: file, wgsl: readFileSync(file, 'utf8') });
    for (const { type, line, column, text } of messages) console.log(`${file}:${line}:${column}: ${type}: ${text}`);
    if (messages.some(({ type }) => type === 'error')) process.exitCode = 1;
  }
}

async function judgeLines(device) {
  for await (const line of createInterface({ input: process.stdin })) {
    process.stdout.write(JSON.stringify(await judge(device, JSON.parse(line))) + '\n');
  }
}

const gpu = create(['backend=null']); // Dawn lives as long as this variable.
const adapter = await gpu.requestAdapter();
// WebGPU's default limits and no optional feature: what every browser has.
const device = await adapter.requestDevice();
const paths = process.argv.slice(2);
await (paths.length ? judgeFiles(device, paths) : judgeLines(device));
device.destroy();
