// The scene in the page is MuJoCo's own: node --test tests/engine/scene.mjs

import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";

import { load, models, newEngine } from "./harness.mjs";

const engine = await newEngine();
const simulation = load(engine, path.join(models, "box_and_sphere.xml"));
const scene = simulation.openScene();
const mjOBJ_GEOM = 5;
const shown = () => scene.geoms.map(({ numbers }) => numbers);

test("each geom of the model is in it where mj_forward puts it", () => {
  assert.ok(scene.update());
  const { data } = simulation.world;
  const geoms = shown().filter(({ objtype }) => objtype[0] === mjOBJ_GEOM);
  assert.equal(geoms.length, 3);
  for (const { objid, pos } of geoms) {
    for (let i = 0; i < 3; i++) {
      assert.ok(Math.abs(pos[i] - data.geom_xpos[3 * objid[0] + i]) < 1e-6);
    }
  }
});

test("skins are where their bodies have brought them", () => {
  const cloth = load(engine, path.join(models, "cloth.xml"));
  const draped = cloth.openScene();
  const corners = () => {
    assert.ok(draped.update());
    const { vertices, normals } = draped.skins;
    assert.equal(vertices.length, 3 * cloth.world.model.nskinvert);
    assert.equal(normals.length, vertices.length);
    return [...vertices];
  };
  const height = () => cloth.world.data.xpos.at(-1);
  const [before, top] = [corners(), height()];
  cloth.step(100);
  const after = corners();
  const fallen = height() - top;
  assert.ok(fallen < -0.1);
  const sinks = after.map((z, i) => z - before[i]).filter((_, i) => i % 3 === 2);
  for (const sink of sinks) assert.ok(Math.abs(sink - fallen) < 0.01);
  cloth.free();
  assert.equal(scene.skins.vertices.length, 0);
});

test("a large model is in it to the last geom, with all that is added", () => {
  const balls = `<geom size=".1"/>`.repeat(12000);
  const mjcf = `<mujoco><worldbody>${balls}</worldbody></mujoco>`;
  const large = engine.load("large.xml", { "large.xml": mjcf });
  const crowded = large.openScene();
  assert.ok(crowded.update());
  assert.equal(crowded.geoms.length, 12000);
  assert.equal(crowded.geoms.at(-1).numbers.objid[0], 11999);
  crowded.showOverlay("geom-frames", true);
  assert.ok(crowded.update());
  assert.equal(crowded.geoms.length, 4 * 12000);
  large.free();
});

test("drawing changes no bit of the motion", () => {
  const run = (draw) => {
    simulation.reset();
    for (let i = 0; i < 200; i++) {
      simulation.step();
      if (draw) scene.update();
    }
    return simulation.state;
  };
  assert.deepEqual(run(true), run(false));
});

test("an overlay adds its decoration, and labels have text", () => {
  simulation.reset();
  scene.update();
  const before = scene.geoms.length;
  scene.showOverlay("frames", true);
  scene.showOverlay("geom-labels", true);
  scene.update();
  assert.ok(scene.geoms.length > before);
  assert.ok(scene.geoms.some((geom) => geom.text("label") === "geom 1"));
  scene.showOverlay("frames", false);
  scene.showOverlay("geom-labels", false);
  scene.update();
  assert.equal(scene.geoms.length, before);
  assert.throws(() => scene.showOverlay("framess", true), /there is no overlay framess/);
  assert.ok(scene.overlays.includes("contacts"));
});

test("the scene tells which overlays are drawn", () => {
  assert.deepEqual([...scene.shown], ["tendons"]);
  scene.showOverlay("frames", true);
  scene.showOverlay("tendons", false);
  assert.deepEqual([...scene.shown], ["frames"]);
  scene.showOverlay("geom-frames", true);
  assert.deepEqual([...scene.shown], ["geom-frames"]);
  scene.showOverlay("geom-frames", false);
  scene.showOverlay("tendons", true);
  assert.deepEqual([...scene.shown], ["tendons"]);
});

test("the camera moves and the view follows", () => {
  scene.update();
  const before = [...scene.view.numbers.pos];
  scene.camera.numbers.distance[0] = 10;
  scene.moveCamera("rotateHorizontal", 0.2, 0);
  scene.update();
  assert.notDeepEqual([...scene.view.numbers.pos], before);
  assert.equal(scene.lights[0].numbers.headlight[0], 1);
});

test("the mouse pulls the body that it selects, and lets go", () => {
  simulation.reset();
  const { data } = simulation.world;
  const { camera } = scene;
  camera.numbers.lookat.set([0.05, 0, 0.8]);
  camera.numbers.distance[0] = 2;
  scene.update();
  const sphere = 2;
  assert.equal(scene.select(1.5, 0.5, 0.5), sphere);
  scene.hold("pull");
  scene.drag("moveHorizontal", 0.3, 0);
  scene.update();
  scene.pull();
  const force = () => Math.hypot(...data.xfrc_applied.subarray(6 * sphere, 6 * sphere + 3));
  assert.ok(force() > 0);
  scene.hold("none");
  scene.pull();
  assert.equal(force(), 0);
  assert.equal(scene.select(1.5, 0.01, 0.99), 0);
});

test("a simulation that stopped leaves the scene as it was", () => {
  simulation.world.data.qvel[0] = 1e300;
  assert.throws(() => simulation.step());
  assert.equal(scene.update(), false);
  simulation.reset();
  assert.ok(scene.update());
});
