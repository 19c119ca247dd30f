// The site's service worker, and the one by which the preview ends what an earlier site left.

import { build } from "esbuild";

import { forBrowsers } from "./manifest.mjs";

export async function buildWorker(site, out) {
  await build({
    ...forBrowsers(site, out),
    entryPoints: [
      { in: "browser/worker/worker.ts", out: "worker/sw" },
      { in: "browser/worker/farewell.ts", out: "preview/sw" },
    ],
    format: "iife",
  });
}
