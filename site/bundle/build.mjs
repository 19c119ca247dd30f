// Bundles what the generator needs of site/: node site/bundle/build.mjs OUTDIR ENGINE
//
//   OUTDIR/public/         files of the site, their names bearing a hash of their content
//   OUTDIR/manifest.json   {"site.css": "assets/site-1A2B3C4D.css", …}, the way from plain names
//   OUTDIR/versions.json   {"katex": "0.19.1"}, of what runs in the generator
//   OUTDIR/plot-vocabulary.json   what a plot may say where (plot-vocabulary.mjs)
//   OUTDIR/templates/      the Handlebars templates, as they are
//   OUTDIR/preview/        what `mjcourse preview` adds to pages
//   OUTDIR/worker/         the service worker, without its edition
//   OUTDIR/cpp/            what the build runs programs with as the page does
//   OUTDIR/script/         what runs in the generator's script engine: no DOM, no Node
//
// ENGINE is the folder with MuJoCo for the browser; where that was not built, labs stay pictures and
// programs text.
//
// The same sources give the same bytes, wherever they lie and wherever OUTDIR is.

import { cp, mkdir, rm, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import path from "node:path";

import { buildScripts } from "./scripts.mjs";
import { buildLab } from "./lab.mjs";
import { buildCpp } from "./cpp.mjs";
import { copyLicenses } from "./licenses.mjs";
import { plotVocabulary } from "./plot-vocabulary.mjs";
import { buildPreview } from "./preview.mjs";
import { buildPublic } from "./public.mjs";
import { buildWorker } from "./worker.mjs";

const site = path.resolve(import.meta.dirname, "..");
const [out, engine] = process.argv.slice(2);
if (!out || !engine) {
  console.error("usage: node site/bundle/build.mjs OUTDIR ENGINE");
  process.exit(2);
}

// What an earlier run left is removed, since its hashed names may be others.
const produced = [
  "cpp",
  "preview",
  "public",
  "worker",
  "templates",
  "script",
  "manifest.json",
  "versions.json",
  "plot-vocabulary.json",
];
await Promise.all(
  produced.map((name) => rm(path.join(out, name), { recursive: true, force: true })),
);
await mkdir(path.join(out, "script"), { recursive: true });

const [page, lab, cpp] = await Promise.all([
  buildPublic(site, path.join(out, "public")),
  buildLab(site, path.join(out, "public"), engine),
  buildCpp(site, out, engine),
  buildPreview(site, path.join(out, "preview")),
  buildWorker(site, out),
  buildScripts(site, path.join(out, "script")),
  copyLicenses(site, path.join(out, "public", "licenses")),
  cp(path.join(site, "press/templates"), path.join(out, "templates"), { recursive: true }),
]);
await writeFile(
  path.join(out, "manifest.json"),
  JSON.stringify({ ...page, ...lab, ...cpp }, null, 2) + "\n",
);
const { version: katex } = createRequire(import.meta.url)("katex/package.json");
await writeFile(path.join(out, "versions.json"), JSON.stringify({ katex }) + "\n");
await writeFile(
  path.join(out, "plot-vocabulary.json"),
  JSON.stringify(await plotVocabulary(site)) + "\n",
);
