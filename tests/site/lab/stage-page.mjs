// What tests/site/lab/stage.mjs has in its page: the stage without a lab around it.

import { loadEngine } from "../../../site/browser/engine/engine.ts";
import { Stage } from "../../../site/browser/lab/stage/stage.ts";
import { View } from "../../../site/browser/lab/stage/view.ts";

// The stage's own context, which it keeps to itself, to take it away.
let webgl;
const { getContext } = HTMLCanvasElement.prototype;
HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
  const context = getContext.call(this, kind, ...rest);
  if (kind === "webgl2") webgl ??= context;
  return context;
};

// Makes a browser whose textures may have no more than `limits` pixels a side: larger ones are refused,
// as WebGL does. Gives a function that makes it what it was.
function lower({ flat, cube }) {
  const { prototype } = WebGL2RenderingContext;
  const { MAX_TEXTURE_SIZE, MAX_CUBE_MAP_TEXTURE_SIZE, TEXTURE_CUBE_MAP } = prototype;
  const { getParameter, texStorage2D, texImage2D } = prototype;
  const limitOf = (target) => (target === TEXTURE_CUBE_MAP ? cube : flat);
  prototype.getParameter = function (name) {
    if (name === MAX_TEXTURE_SIZE) return flat;
    return name === MAX_CUBE_MAP_TEXTURE_SIZE ? cube : getParameter.call(this, name);
  };
  prototype.texStorage2D = function (target, levels, format, width, height) {
    if (Math.max(width, height) > limitOf(target)) return;
    texStorage2D.call(this, target, levels, format, width, height);
  };
  prototype.texImage2D = function (target, level, format, width, height, ...rest) {
    if (Math.max(width, height) > limitOf(target)) return;
    texImage2D.call(this, target, level, format, width, height, ...rest);
  };
  return () => Object.assign(prototype, { getParameter, texStorage2D, texImage2D });
}

const stage = Stage.open();
const canvas = document.querySelector("canvas");
const events = [];
stage.onLost = () => events.push("lost");
stage.onRestored = () => events.push("restored");
let engine, simulation, scene, view;

// Opens the lab whose element is `lab`, at its poster's size, and shows its first frame.
async function open({ module, glue, wasm, width, height }) {
  engine ??= await loadEngine({ glue, wasm });
  const { lab } = await import(module);
  const old = simulation;
  simulation = engine.load(lab.model.name, lab.model.texts);
  scene = simulation.openScene();
  for (const name of lab.overlays) scene.showOverlay(name, true);
  const { camera } = scene;
  camera.numbers.azimuth[0] = lab.camera.azimuth;
  camera.numbers.elevation[0] = lab.camera.elevation;
  camera.numbers.distance[0] = lab.camera.distance;
  camera.numbers.lookat.set(lab.camera.target);
  resize(width, height);
  if (view === undefined) view = new View(stage, canvas, simulation, scene);
  else view.replace(simulation, scene);
  old?.free();
  draw();
}

function resize(width, height) {
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
}

function draw(ghost) {
  scene.update();
  view.draw(ghost);
}

function pixels(image) {
  const copy = new OffscreenCanvas(image.width, image.height).getContext("2d");
  copy.drawImage(image, 0, 0);
  return copy.getImageData(0, 0, image.width, image.height).data;
}

// The mean difference of a number of 0 to 255, and the part of the pixels that differ by more than
// an eye would let pass for the same.
function difference(a, b) {
  if (a.length !== b.length) return { mean: 255, far: 1 };
  let [sum, far] = [0, 0];
  for (let i = 0; i < a.length; i += 4) {
    const off = [0, 1, 2].reduce((total, k) => total + Math.abs(a[i + k] - b[i + k]), 0) / 3;
    sum += off;
    if (off > 24) ++far;
  }
  return { mean: (4 * sum) / a.length, far: (4 * far) / a.length };
}

async function compare(poster) {
  const bytes = await (await fetch(poster)).blob();
  return difference(pixels(canvas), pixels(await createImageBitmap(bytes)));
}

function withOverlays(names) {
  for (const name of scene.overlays) scene.showOverlay(name, false);
  for (const name of names) scene.showOverlay(name, true);
  draw();
  return pixels(canvas);
}

// What the overlay `name` changes; for those that only name what another shows, beside that one.
function overlayChanges(name) {
  const others = { "force-labels": ["forces"], "joint-labels": ["joints"] }[name] ?? [];
  return difference(withOverlays(others), withOverlays([...others, name])).mean;
}

// A second run of the same model, `steps` on: what its ghost changes.
async function ghostChanges(module, steps) {
  const { lab } = await import(module);
  const second = engine.load(lab.model.name, lab.model.texts);
  if (steps > 0) second.step(steps);
  const ghost = second.openScene();
  ghost.update();
  draw();
  const without = pixels(canvas);
  draw(ghost);
  const { mean } = difference(without, pixels(canvas));
  second.free();
  return mean;
}

// Another model so large that MuJoCo's memory moves.
function growMemory() {
  const mjcf = `<mujoco><size nstack="20000000"/><worldbody><body><freejoint/><geom size="1"/></body></worldbody></mujoco>`;
  engine.load("large.xml", { "large.xml": mjcf }).free();
}

// Takes the context away and gives it back, drawing all the while; says what happened.
async function loseContext() {
  const before = pixels(canvas);
  const extension = webgl.getExtension("WEBGL_lose_context");
  const heard = (type) =>
    new Promise((resolve) => webgl.canvas.addEventListener(type, resolve, { once: true }));
  const lost = heard("webglcontextlost");
  extension.loseContext();
  await lost;
  const wasLost = stage.lost;
  draw();
  const kept = difference(before, pixels(canvas)).mean;
  const restored = heard("webglcontextrestored");
  setTimeout(() => extension.restoreContext());
  await restored;
  canvas.getContext("2d").clearRect(0, 0, canvas.width, canvas.height);
  draw();
  const again = difference(before, pixels(canvas)).mean;
  return { events, wasLost, isLost: stage.lost, kept, again };
}

// What these limits change of the picture, and the canvas of a lab that is larger than they are.
async function compareUnder(limits) {
  draw();
  const free = pixels(canvas);
  const raise = lower(limits);
  const modest = Stage.open();
  const modestView = new View(modest, canvas, simulation, scene);
  modestView.draw();
  const change = difference(free, pixels(canvas));
  const before = [canvas.style.width, canvas.style.height].map(parseFloat);
  resize(limits.flat, limits.flat / 2);
  modestView.draw();
  const size = [canvas.width, canvas.height];
  resize(...before);
  modestView.dispose();
  modest.dispose();
  raise();
  return { ...change, size };
}

// Milliseconds of script for a frame, as a rule.
async function drawingTime() {
  const times = [];
  for (let i = 0; i < 40; ++i) {
    simulation.step();
    scene.update();
    const start = performance.now();
    view.draw();
    times.push(performance.now() - start);
    await new Promise(requestAnimationFrame);
  }
  return times.sort((a, b) => a - b)[20];
}

Object.assign(window, {
  open,
  resize,
  draw,
  compare,
  overlayChanges,
  ghostChanges,
});
Object.assign(window, { withOverlays, growMemory, loseContext, compareUnder, drawingTime });
window.overlays = () => scene.overlays;
