// The site's service worker, and the one by which the preview ends what an earlier site left.

import path from "node:path";

import { build } from "esbuild";

import { targets } from "./manifest.mjs";

export async function buildWorker(site, out) {
  await build({
    absWorkingDir: site,
    entryPoints: [
      { in: "worker/worker.ts", out: "worker/sw" },
      { in: "worker/farewell.ts", out: "preview/sw" },
    ],
    outdir: path.resolve(out),
    bundle: true,
    minify: true,
    format: "iife",
    charset: "utf8",
    target: targets,
    logLevel: "warning",
  });
}
