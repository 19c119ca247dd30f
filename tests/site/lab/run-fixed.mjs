// Numbers are printed as C prints them.
//
//   node --test tests/site/lab/run-fixed.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { lab } from "./run-harness.mjs";

const { fixed } = lab;

// What glibc's printf("%.*f") gave, without the sign of a zero.
const printed = [
  [0.5, 0, "0"],
  [1.5, 0, "2"],
  [2.5, 0, "2"],
  [-0.5, 0, "0"],
  [-1.5, 0, "-2"],
  [0.125, 2, "0.12"],
  [0.375, 2, "0.38"],
  [-0.125, 2, "-0.12"],
  [1.005, 2, "1.00"],
  [0.045, 2, "0.04"],
  [2.675, 2, "2.67"],
  [1e21, 0, "1000000000000000000000"],
  [1e22, 1, "10000000000000000000000.0"],
  [123456789012345680000, 3, "123456789012345683968.000"],
  [5e-324, 3, "0.000"],
  [-5e-324, 3, "0.000"],
  [0, 3, "0.000"],
  [-0, 3, "0.000"],
  [-0.0004, 3, "0.000"],
  [-0.0005, 3, "-0.001"],
  [0.0005, 3, "0.001"],
  [0.00048828125, 10, "0.0004882812"],
  [1e-7, 7, "0.0000001"],
  [0.1, 20, "0.10000000000000000555"],
  [0.3, 17, "0.29999999999999999"],
  [999.9995, 3, "1000.000"],
  [-9.9999999, 6, "-10.000000"],
  [4503599627370496.5, 0, "4503599627370496"],
  [1073741824.0000002, 7, "1073741824.0000002"],
  [0.9999999999999999, 15, "1.000000000000000"],
];

test("as printf prints it", () => {
  for (const [value, digits, text] of printed) {
    assert.equal(fixed(value, digits), text, `${value} with ${digits} digits`);
  }
  assert.equal(fixed(Number.MAX_VALUE, 0), BigInt(Number.MAX_VALUE).toString());
});

test("where there is no tie, toFixed() agrees", () => {
  for (let i = 1; i < 2000; i++) {
    const value = Math.sin(i * i) * 10 ** ((i % 12) - 6);
    const digits = i % 13;
    assert.equal(fixed(value, digits), value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1"));
  }
});
