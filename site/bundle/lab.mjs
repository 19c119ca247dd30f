// What a lab loads once it comes near the reader: its own code, in pieces (the editor comes only
// where one is opened), its styles, and MuJoCo for the browser where that was built. And what a program
// loads once its reader edits it: it is bundled with the lab, as the editor is the same.

import { createHash } from "node:crypto";
import { copyFile, cp, mkdir, readFile } from "node:fs/promises";
import path from "node:path";

import { build } from "esbuild";

import { computed } from "./computed.mjs";
import { forBrowsers, manifestOf } from "./manifest.mjs";

// Builds into `out` and returns its part of the manifest. `engine` is the folder with engine.mjs and
// engine.wasm; without them the site has no live labs, and the manifest names none of this.
export async function buildLab(site, out, engine) {
  const built = ["engine.mjs", "engine.wasm"];
  const contents = await Promise.all(
    built.map((name) => readFile(path.join(engine, name)).catch(() => undefined)),
  );
  if (contents.includes(undefined)) return {};
  await mkdir(path.join(out, "assets"), { recursive: true });
  const copies = built.map((name, index) => copyHashed(engine, out, name, contents[index]));
  const [code, ...hashed] = await Promise.all([
    buildCode(site, out),
    ...copies,
    cp(path.join(engine, "licenses"), path.join(out, "licenses", "mujoco"), { recursive: true }),
  ]);
  return { ...code, ...Object.fromEntries(built.map((name, index) => [name, hashed[index]])) };
}

async function buildCode(site, out) {
  const { metafile } = await build({
    ...forBrowsers(site, out),
    entryPoints: [
      { in: "browser/lab/lab.ts", out: "lab" },
      { in: "browser/styles/lab-live.css", out: "lab" },
      { in: "browser/program/program.ts", out: "program" },
      { in: "browser/styles/program.css", out: "program" },
    ],
    entryNames: "assets/[name]-[hash]",
    chunkNames: "assets/[name]-[hash]",
    splitting: true,
    metafile: true,
    format: "esm",
    legalComments: "none",
    plugins: [computed(site)],
  });
  const entries = [
    "browser/lab/lab.ts",
    "browser/styles/lab-live.css",
    "browser/program/program.ts",
    "browser/styles/program.css",
  ];
  return manifestOf(metafile, site, out, (output) => entries.includes(output.entryPoint));
}

async function copyHashed(from, out, name, content) {
  const hash = createHash("sha256").update(content).digest("hex").slice(0, 8).toUpperCase();
  const { name: stem, ext } = path.parse(name);
  const hashed = `assets/${stem}-${hash}${ext}`;
  await copyFile(path.join(from, name), path.join(out, hashed));
  return hashed;
}
