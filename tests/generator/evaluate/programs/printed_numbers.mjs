// When do two printed words agree? The generator's answer for many random pairs, held against an oracle that
// computes with whole numbers of any length.
//
//   node tests/generator/evaluate/programs/printed_numbers.mjs build/release/tests/printed_numbers

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";

const count = 100_000;

// mulberry32: the same pairs in every run.
let state = 31;
function random(below) {
  state = (state + 0x6d2b79f5) | 0;
  let t = Math.imul(state ^ (state >>> 15), 1 | state);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) % below;
}
const oneOf = (list) => list[random(list.length)];
const repeat = (most, make) => Array.from({ length: random(most + 1) }, make).join("");
const digits = (most) => repeat(most, () => random(10)) + random(10);
const hex = (length) => Array.from({ length }, () => random(16).toString(16)).join("");
const two = () => `${random(6)}${random(10)}`;

// ---- the oracle -----------------------------------------------------------------------------------------

// Sign, digits, digits behind the point, exponent, unit.
const form = /^([-+−]?)(\d*)(?:\.(\d+)|\.(?=e[-+]?\d))?(?:e([-+]?\d{1,3})(?!\d))?([a-z]*)$/i;

/** What a word is: a number with its unit, or text. */
function read(word) {
  const [, sign, whole, fraction = "", exponent = "", unit] = form.exec(word) ?? [];
  if (!whole && !fraction) return { text: word };
  const negative = sign === "-" || sign === "−";
  return {
    unit,
    negative,
    written: `${whole}e${exponent}`,
    digits: BigInt(whole + fraction) * (negative ? -1n : 1n),
    last: Number(exponent) - fraction.length,
    measured: fraction !== "" || /^[-+]/.test(exponent),
  };
}

const distance = (a, b) => (a > b ? a - b : b - a);

function agree(stated, printed, tolerance) {
  const a = read(stated);
  const b = read(printed);
  if (a.text !== undefined || b.text !== undefined) return stated === printed;
  if (a.unit !== b.unit) return false;
  if (!tolerance && !a.measured && !b.measured) {
    return a.written === b.written && (a.negative === b.negative || a.digits === 0n);
  }
  const most = tolerance ? read(tolerance) : { digits: a.measured ? 1n : 0n, last: a.last };
  const last = Math.min(a.last, b.last, most.last);
  const scaled = (x) => x.digits * 10n ** BigInt(x.last - last);
  return distance(scaled(a), scaled(b)) <= scaled(most);
}

// ---- the words ------------------------------------------------------------------------------------------

function number() {
  const whole = oneOf([
    () => "",
    () => "0",
    () => `${1 + random(9)}`,
    () => digits(3),
    () => digits(24),
  ])();
  const fraction = whole === "" || random(4) > 0 ? `.${digits(oneOf([1, 3, 20]))}` : "";
  const exponent = oneOf([
    "",
    "",
    "",
    `e-0${random(10)}`,
    `E+${two()}`,
    `e${random(9)}`,
    "e+300",
    "e-310",
  ]);
  const point = fraction === "" && exponent.length > 2 && random(4) === 0 ? "." : "";
  return oneOf(["", "", "", "-", "+", "−"]) + whole + fraction + point + exponent;
}

// Some units of the last place more or less, and perhaps written otherwise.
function neighbour(word) {
  const [, sign, whole, fraction = "", exponent = ""] = form.exec(word);
  const step = BigInt(random(5) - 2);
  const finer = random(3) === 0 ? digits(2) : "";
  const value = BigInt((sign === "-" || sign === "−" ? "-" : "") + whole + fraction) + step;
  const shown =
    String(value < 0n ? -value : value).padStart(fraction.length + (whole ? 1 : 0), "0") + finer;
  const places = fraction === "" && finer === "" ? 0 : fraction.length + finer.length;
  const written = places === 0 ? shown : `${shown.slice(0, -places)}.${shown.slice(-places)}`;
  return (
    (value < 0n ? oneOf(["-", "−"]) : oneOf(["", "", "+"])) + written + (exponent && `e${exponent}`)
  );
}

const names = [
  () => `${random(9)}.${random(30)}.${random(30)}`,
  () => `v${random(9)}.${random(30)}`,
  () => `gcc-${random(20)}.${random(9)}`,
  () => `${random(20)}.${random(9)}-${random(20)}`,
  () => `${random(9)}.${random(9)}rc${random(9)}`,
  () => Array.from({ length: 4 }, () => random(256)).join("."),
  () => `0x${hex(4)}`,
  () => `0x1.${hex(4)}p+${random(9)}`,
  () => [hex(8), hex(4), hex(4), hex(4), hex(12)].join("-"),
  () => `20${two()}-0${random(9)}-1${random(9)}`,
  () => `1${random(9)}:${two()}:${two()}.${two()}`,
  () => `${two()}:${two()}`,
  () => `x_${random(9)}.${random(9)}`,
  () => oneOf(["nan", "-nan", "inf", "-inf"]),
];

// Another of the same kind, or the same with another digit.
function otherDigit(word) {
  const at = random(word.length);
  return /\d/.test(word[at]) ? word.slice(0, at) + random(10) + word.slice(at + 1) : word;
}

function pair() {
  if (random(4) === 0) {
    const name = oneOf(names)();
    return [name, otherDigit(name)];
  }
  const stated = number();
  const unit = oneOf(["", "", "", "m", "rad"]);
  const printed = oneOf([neighbour, neighbour, neighbour, otherDigit, number])(stated);
  return [stated + unit, printed + unit];
}

// ---- held against each other ----------------------------------------------------------------------------

const pairs = Array.from({ length: count }, () => {
  const words = Array.from({ length: 1 + random(2) }, pair);
  const tolerance = random(6) === 0 ? oneOf(["0.1", "0.5", "2", "1e-3", "0"]) : "";
  return { words, tolerance };
});
const input = pairs.map(({ words, tolerance }) => {
  const line = (which) => words.map((word) => word[which]).join("  ");
  return `${line(0)}\n${line(1)}\n${tolerance}\n`;
});
const answers = execFileSync(process.argv[2], { input: input.join(""), maxBuffer: 1 << 24 })
  .toString()
  .trimEnd()
  .split("\n");
assert.equal(answers.length, count);

let agreeing = 0;
pairs.forEach(({ words, tolerance }, i) => {
  const expected = words.every(([stated, printed]) => agree(stated, printed, tolerance));
  agreeing += expected ? 1 : 0;
  assert.equal(answers[i], expected ? "1" : "0", `of\n${input[i]}the oracle says ${expected}`);
});
// Neither answer is rare, so each of them was tried.
assert.ok(agreeing > count / 4 && agreeing < (3 * count) / 4, `${agreeing} of ${count} agree`);
