// What a page has beside its own scripts and styles while it is being written.

import path from "node:path";

import { build } from "esbuild";

import { targets } from "./manifest.mjs";

export async function buildPreview(site, out) {
  await build({
    absWorkingDir: site,
    entryPoints: ["preview/preview.ts", "preview/worker.ts", "preview/preview.css"],
    outdir: path.resolve(out),
    bundle: true,
    minify: true,
    format: "iife",
    charset: "utf8",
    target: targets,
    logLevel: "warning",
  });
}
