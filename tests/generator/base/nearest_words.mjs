// Which name was meant? The generator's answer, held against that of the scripts in the page.
//
//   node tests/generator/base/nearest_words.mjs build/release/tests/nearest_words

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";

import { nearest } from "../../../site/press/script/suggest.ts";

const known = [
  ..."qpos qvel qacc act ctrl time xpos xquat xmat xfrc_applied sensordata".split(" "),
  ..."body_mass body_inertia geom_size geom_friction actuator_gear jnt_range".split(" "),
  ..."nq nv nu a ab cat hat bat Math Math.sin Öffnung Offnung größe 一二 二一 ⟂ 𝄞𝄢".split(" "),
  "x".repeat(80),
  "ä".repeat(80),
];

// mulberry32: the same names in every run.
let state = 7;
function random(below) {
  state = (state + 0x6d2b79f5) | 0;
  let t = Math.imul(state ^ (state >>> 15), 1 | state);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) % below;
}
const oneOf = (list) => list[random(list.length)];

// A name with some slips of the fingers.
function mistyped(name) {
  const letters = Array.from(name);
  for (let slips = random(6); slips > 0; slips--) {
    const place = random(letters.length + 1);
    letters.splice(place, random(2), ...(random(2) ? [oneOf("aqpos_xäö一𝄞".split(/(?:)/u))] : []));
  }
  return letters.join("");
}

const some = () => known.filter(() => random(3) > 0);
const cases = ["", ...Array.from({ length: 20_000 }, () => mistyped(oneOf(known)))].map((name) => [
  name,
  ...some(),
]);
const input = cases.map((words) => `${words.join("\t")}\n`).join("");
const answers = execFileSync(process.argv[2], { input, maxBuffer: 1 << 24 })
  .toString()
  .split("\n");
assert.equal(answers.pop(), "");
assert.equal(answers.length, cases.length);

let found = 0;
cases.forEach(([name, ...words], i) => {
  found += answers[i] === "" ? 0 : 1;
  assert.equal(nearest(name, words), answers[i], `of \`${name}\` among ${words.join(", ")}`);
});
// Neither answer is rare, so each of them was tried.
assert.ok(found > cases.length / 8 && found < (7 * cases.length) / 8, `${found} were found`);
