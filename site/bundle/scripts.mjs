// The bundles that run inside the generator: one for each of press/script/entries/, self-contained.

import { readdir } from "node:fs/promises";
import path from "node:path";

import { build } from "esbuild";

import { computed } from "./computed.mjs";

export async function buildScripts(site, out) {
  const folder = path.join(site, "press/script/entries");
  const names = (await readdir(folder)).filter((name) => name.endsWith(".ts")).sort();
  await build({
    absWorkingDir: site,
    entryPoints: names.map((name) => `press/script/entries/${name}`),
    outdir: path.resolve(out),
    entryNames: "[name]",
    bundle: true,
    minifyWhitespace: true,
    minifySyntax: true,
    format: "iife",
    platform: "browser",
    charset: "utf8",
    target: "es2022",
    legalComments: "none",
    plugins: [computed(site)],
    logLevel: "warning",
  });
}
