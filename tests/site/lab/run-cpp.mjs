// The state as C++.
//
//   node --test tests/site/lab/run-cpp.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { lab, mjcfOf, newEngine, openPlain } from "./run-harness.mjs";

const engine = await newEngine();
const open = (mjcf) => openPlain(engine, mjcf);

test("a small state is set number by number", () => {
  const simulation = open(mjcfOf("slide"));
  const { data } = simulation.world;
  data.qvel[0] = -0.1;
  data.qpos[0] = 5;
  data.ctrl[0] = 1e21;
  assert.equal(
    lab.cppState(simulation),
    `// for a model with nq = 1 and nv = 1
mj_resetData(model, data);
data->time = 0.0;
data->qpos[0] = 5.0;
data->qvel[0] = -0.1;
data->ctrl[0] = 1e+21;
mj_forward(model, data);
`,
  );
  simulation.free();
});

test("a long one is copied, every double exactly", () => {
  const simulation = open(mjcfOf("pick_place"));
  simulation.resetToKeyframe(1);
  simulation.step(100);
  const { data } = simulation.world;
  data.qvel[3] = -0;
  const text = lab.cppState(simulation);
  assert.ok(text.split("\n").every((line) => line.length <= 80));
  const arrays = [...text.matchAll(/const double (\w+)\[\] = \{([^}]*),\s*\};\n(.*)\n/g)];
  assert.deepEqual(
    arrays.map(([, name, , copied]) => [name, copied]),
    [
      ["qpos", "mju_copy(data->qpos, qpos, model->nq);"],
      ["qvel", "mju_copy(data->qvel, qvel, model->nv);"],
      ["ctrl", "mju_copy(data->ctrl, ctrl, model->nu);"],
    ],
  );
  for (const [, name, numbers] of arrays) {
    const literals = numbers.split(",").map((literal) => literal.trim());
    assert.ok(literals.every((literal) => /^-?\d+(\.\d+)?(e[-+]\d+)?$/.test(literal)));
    assert.ok(literals.every((literal) => /[.e]/.test(literal)));
    assert.deepEqual(literals.map(Number), Array.from(data[name]));
  }
  simulation.free();
});

test("mocap bodies and forces are there where there are some", () => {
  const mjcf = `<mujoco><worldbody><body mocap="true"><geom size=".1"/></body>
    <body pos="0 0 1"><freejoint/><geom size=".1"/></body></worldbody></mujoco>`;
  const simulation = open(mjcf);
  assert.match(
    lab.cppState(simulation),
    /mocap_pos\[2\] = 0\.0;[^]*mocap_quat, 4 \* model->nmocap/,
  );
  assert.doesNotMatch(lab.cppState(simulation), /applied|act|ctrl/);
  simulation.world.data.xfrc_applied[14] = 2;
  assert.match(lab.cppState(simulation), /data->xfrc_applied, xfrc_applied, 6 \* model->nbody/);
  simulation.free();
});
