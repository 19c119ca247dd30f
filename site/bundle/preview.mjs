// What a page has beside its own scripts and styles while it is being written.

import { build } from "esbuild";

import { forBrowsers } from "./manifest.mjs";

export async function buildPreview(site, out) {
  await build({
    ...forBrowsers(site, out),
    entryPoints: ["preview/preview.ts", "preview/worker.ts", "preview/preview.css"],
    format: "iife",
  });
}
