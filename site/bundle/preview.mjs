// What a page has beside its own scripts and styles while it is being written.

import { build } from "esbuild";

import { forBrowsers } from "./manifest.mjs";

export async function buildPreview(site, out) {
  await build({
    ...forBrowsers(site, out),
    entryPoints: [
      "browser/preview/preview.ts",
      "browser/preview/worker.ts",
      "browser/preview/preview.css",
    ],
    format: "iife",
  });
}
