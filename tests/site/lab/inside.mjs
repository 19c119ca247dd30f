// A lab's script does not leave the lab: in the page it is code of the site's own, and reaches nothing
// of the page. Each attack does what it says where it is run as it stands, and is then run as the
// generator writes it: refused by its text, or stopped by its guards, with the page as it was.
//
//   node tests/site/lab/inside.mjs

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import path from "node:path";

import { build } from "../../../site/node_modules/esbuild/lib/main.js";
import { launch } from "../chromium.mjs";

const site = path.resolve(import.meta.dirname, "../../../site");

// Each sets `attacked` of the page, as whatever has its `window` can do.
const attacks = {
  // by a name of the page
  "a global": "window.attacked = true",
  "the global object": "globalThis.attacked = true",
  "an alias": "self.attacked = true",
  "the document": "document.defaultView.attacked = true",
  "a frame's name": "(frames[0] ?? top).attacked = true",
  "a name in disguise": "w\\u0069ndow.attacked = true",
  "a name out of its block": "{ const window = {}; } window.attacked = true",
  "a name in a default": "const f = (a = window) => { var window; a.attacked = true; }; f();",
  "a timer": "setTimeout; parent.attacked = true",
  "an assignment": "attacked = true",
  // by what all scripts of a page share
  "a function of arrays":
    "[].map.attacked = true; if ([].map.attacked) [].map.real = 1; window.attacked = true",
  "a shared constructor": "Array.from = (x) => { x.attacked = true; return []; }",
  "a shared constructor, by a name": "const A = Array; A['fr' + 'om'] = (x) => (x.attacked = true)",
  "a shared constructor, in a pattern": "[Array.from] = [(x) => { x.attacked = true; return []; }]",
  "a shared constructor, in a loop":
    "for (Array.from of [(x) => { x.attacked = true; return []; }]);",
  "the name of a constructor": "Array = { from: (x) => { x.attacked = true; return []; } }",
  JSON: "JSON.stringify = (x) => { x.attacked = true; }",
  Object: "Object.keys = (x) => { x.attacked = true; return []; }",
  "a prototype": "Array.prototype.at = function () { this[0].attacked = true; }",
  "a prototype, by a name put together": "Array['proto' + 'type'].at = () => 1",
  "a prototype, by an object that is asked twice": `
    let asked = 0;
    const key = { toString: () => (asked++ === 0 ? 'at' : 'proto' + 'type') };
    const found = Array[key] ?? Array[key];
    if (found) found.at = () => 1;`,
  "the prototype's prototype": "[].__proto__.at = function () { this[0].attacked = true; }",
  "the prototype in a pattern":
    "const { prototype } = Array; prototype.at = function () { this[0].attacked = true; }",
  "the prototype by a computed pattern":
    "const k = 'proto' + 'type'; const { [k]: p } = Array; p.at = () => 1",
  "the constructor's prototype": "[]['con' + 'structor']['proto' + 'type'].at = () => 1",
  "Object's own reflection":
    "Object.getPrototypeOf([]).at = function () { this[0].attacked = true; }",
  "a setter for all objects":
    "({}).__defineGetter__.call([].constructor.prototype, 'at', () => function () { this[0].attacked = true; })",
  "a stack's frames":
    "Error.prepareStackTrace = (e, frames) => { frames[0].getFunction; window.attacked = true; }; new Error().stack",
  "a module": "import('data:text/javascript,window.attacked=true')",
  // and what closes the function that the script is in
  "a closing bracket": "} window.attacked = true; {",
  "a function that has a guard's name": `(function key$ (k) {
      if (typeof k === "string") return k;
      const found = Array[["proto" + "type"][0]];
      found.at = () => 1;
    })(1);`,
  "a guard of its own": "const key$ = (k) => k; window.attacked = true",
};

// What the browser holds by itself.
const held = new Set(["an assignment", "a module"]);

// What must go on as before.
const honest = {
  "data.qpos[1] = 2; data.qpos[1] + data.qpos[0]": 2,
  "let sum = 0; for (let i = 0; i < 2; i++) sum += data.qpos[i] ** 2; data.qpos[0] = sum;": 4,
  "const { a, ...rest } = { a: 1, b: 2 }; const o = { ...rest }; o['c' + a] = 3; data.qpos[0] = o.c1;": 3,
  "data.qpos.map((x, i, all) => all[i]).forEach((x) => x); data.qpos[0] = Object.keys({ a: 1 }).length": 1,
  "const f = function fact(n) { return n < 2 ? 1 : n * fact(n - 1); }; data.qpos[0] = f(4)": 24,
  "try { null.x; } catch (e) { data.qpos[0] = e.message.length > 0 ? 7 : 8; }": 7,
};

const bundled = async (contents, globalName) => {
  const options = { bundle: true, format: "iife", globalName, target: "es2022", write: false };
  const stdin = { contents, resolveDir: site, loader: "ts" };
  return (await build({ stdin, ...options })).outputFiles[0].text;
};
const guard = new Function(
  `${await bundled('import "./press/script/entries/guard.ts";', "none")}; return globalThis.guard;`,
)();
const world = await bundled('export * from "./press/script/world.ts";', "site");

const names = "body\nctrl\ndata\nforward\nkey$\nMath\nmodel\nown$\nstep";
const scope = "{ data, forward, key$, model, own$ }";
const moduleOf = (text) => `export const script = (${scope}) => { {\n${text}\n} };`;

// A page as the site's are.
const head = (await readFile(path.join(site, "press/templates/page.hbs"), "utf8")).match(
  /<meta http-equiv=.*>/,
);
const files = {
  "/": ["text/html", `<!DOCTYPE html>${head[0]}<title>Lab</title><script src="world.js"></script>`],
  "/world.js": ["text/javascript", world],
};
const server = createServer((request, response) => {
  const [type, body] = files[request.url] ?? ["text/plain", ""];
  response.writeHead(200, { "content-type": type }).end(body);
});
await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
const address = `http://127.0.0.1:${server.address().port}/`;

// Runs the script at `url` as a lab does; then does what the page's own code does all the time.
async function play(url) {
  const view = Float64Array.of(0, 2);
  const field = {
    owner: "",
    name: "qpos",
    view,
    rows: 2,
    columns: 1,
    scalar: false,
    integer: false,
  };
  const nothing = () => undefined;
  const functions = new Proxy({}, { get: () => nothing });
  const native = { modelFields: [], dataFields: [field], names: {}, functions };
  const scope = site.openWorld({ ...native, step: nothing, forward: nothing, reset: nothing });
  let trouble = "";
  try {
    const { script } = await import(url);
    script(scope);
  } catch (error) {
    trouble = String(error.message);
  }
  const quietly = (work) => {
    try {
      work();
    } catch {
      // what is left of the page is looked at below
    }
  };
  quietly(() => Array.from(window));
  quietly(() => JSON.stringify(window.document && window));
  quietly(() => Object.keys(window));
  quietly(() => [window].at(0));
  await new Promise((resolve) => setTimeout(resolve, 20));
  const shared = [[].map, Array, Error, JSON, Object].some((one) =>
    Object.getOwnPropertyNames(one).some((name) =>
      ["attacked", "prepareStackTrace"].includes(name),
    ),
  );
  const own = !String([].at).includes("native code");
  return { attacked: window.attacked === true || shared || own, trouble, value: view[0] };
}

const browser = await launch();
const page = await browser.newPage();
let number = 0;
async function run(text) {
  const url = `/${++number}.js`;
  files[url] = ["text/javascript", moduleOf(text)];
  await page.goto(address);
  return page.evaluate(play, url);
}

try {
  for (const [what, text] of Object.entries(attacks)) {
    // One that changes what all of the page shares leaves nothing that could answer.
    const found = await run(text).catch(() => undefined);
    assert.equal(found?.attacked !== false, !held.has(what), `${what} is no attack`);
    const before = found?.attacked !== false ? "got out" : "stayed inside by itself";
    const guarded = JSON.parse(guard(text, "script", names));
    if (guarded.text === undefined) {
      console.log(`${what}: ${before}; refused, ${guarded.message}`);
      assert.match(guarded.id, /^E-script-/);
      continue;
    }
    const after = await run(guarded.text);
    console.log(`${what}: ${before}; stopped, ${after.trouble}`);
    assert.ok(!after.attacked, `${what} gets out of the lab`);
    assert.match(after.trouble, /^a lab's script cannot /, what);
  }
  for (const [text, value] of Object.entries(honest)) {
    const guarded = JSON.parse(guard(text, "script", names));
    assert.ok(guarded.text, `${text}: ${guarded.message}`);
    const found = await run(guarded.text);
    assert.equal(found.trouble, "", text);
    if (text.includes("data.qpos[0] =")) assert.equal(found.value, value, text);
  }
} finally {
  await browser.close();
  server.close();
}
