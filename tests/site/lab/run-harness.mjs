// Labs as the page has them, over the built engine, without a page: site/browser/lab/run/ bundled, and a lab's
// module in the generator's form. MJCOURSE_ENGINE is the folder with the engine.

import { readFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { built, models as engineModels, require } from "../../engine/harness.mjs";

const root = path.resolve(import.meta.dirname, "../../..");

// One bundle, so that its parts know one another's classes.
const parts = [
  ...["engine/engine", "engine/errors", "lab/run/base64url", "lab/run/clock", "lab/run/cpp-state"],
  ...["lab/run/resources", "lab/run/fixed", "lab/run/history", "lab/run/lab-link"],
  ...["lab/run/playback", "lab/run/run", "lab/run/samples", "lab/run/trial", "lab/run/trouble"],
];
const { outputFiles } = await require("esbuild").build({
  stdin: {
    contents: parts.map((part) => `export * from "./${part}.ts";`).join("\n"),
    resolveDir: path.join(root, "site/browser"),
  },
  bundle: true,
  format: "esm",
  target: "es2022",
  write: false,
});

// Everything that those modules export.
export const lab = await importText(outputFiles[0].text);

export function newEngine() {
  return lab.loadEngine({
    glue: pathToFileURL(path.join(built, "engine.mjs")).href,
    wasmBinary: readFileSync(path.join(built, "engine.wasm")),
  });
}

// The MJCF of a model of the course, or of tests/engine/models.
export function mjcfOf(name) {
  const folder = { joint_zoo: "models", pick_place: "models" }[name];
  const file = path.join(folder ? path.join(root, folder) : engineModels, `${name}.xml`);
  return readFileSync(file, "utf8");
}

const worldNames = ["body", "ctrl", "data", "joint", "Math", "model", "qpos", "reset", "step"];

// A lab's module, as the generator writes it, of a description where scripts and expressions are
// text. `describe` gets a function for each kind, which gives the index of what it is given.
export async function labModule(model, describe) {
  const scripts = [];
  const add = (before, text, after, names) => {
    const used = names.filter((name) => new RegExp(`\\b${name}\\b`).test(text));
    return scripts.push(`({ ${used.join(", ")} }) => ${before}\n${text}\n${after},`) - 1;
  };
  const run = (text) => add("{", text, "}", worldNames);
  const write = (bind) => add("{", `${bind} = value;`, "}", [...worldNames, "value"]);
  const value = (text) => add("{ return (", text, "); }", worldNames);
  const name = "model.xml";
  const description = {
    title: "A lab",
    model: { name, texts: { [name]: model }, assets: {} },
    height: 300,
    camera: { azimuth: 90, elevation: -20, distance: 2, target: [0, 0, 0.5] },
    toggles: ["joints"],
    overlays: [],
    controls: [],
    readouts: [],
    plots: [],
    speed: 1,
    predict: null,
    goal: null,
    ghost: null,
    editable: null,
    ...describe({ run, write, value }),
  };
  const text = [
    `export const lab = ${JSON.stringify(description)};`,
    "export const scripts = [",
    ...scripts,
    "];",
  ];
  return importText(text.join("\n"));
}

// The run of such a lab.
export async function openRun(engine, model, describe = () => ({})) {
  const module = await labModule(model, describe);
  return new lab.Run(engine, module, module.lab.model.texts);
}

// A slider of steps of 0.1, for what `description` binds it to. `kinds` is what `describe` gets.
export function slider({ value, write }, { bind, ...description }) {
  const scripts = { read: value(bind), write: write(bind) };
  return { type: "slider", bind, step: 0.1, ...description, ...scripts };
}

export function gravitySlider(kinds, value = null) {
  const range = { min: -20, max: 0, value };
  const shown = { label: "Gravity", digits: 1, unit: "m/s²" };
  return slider(kinds, { bind: "model.opt.gravity[2]", ...range, ...shown });
}

// The simulation of a model with no lab around it.
export function openPlain(engine, mjcf) {
  return engine.load("plain.xml", { "plain.xml": mjcf });
}

function importText(text) {
  return import(`data:text/javascript;base64,${Buffer.from(text).toString("base64")}`);
}
