// The files a reader's browser loads: one stylesheet with its fonts, one small script, the favicon;
// and what only some pages have of scripts and styles, or have once they are shown or asked for.

import path from "node:path";

import { build } from "esbuild";

import { cutFonts } from "./fonts.mjs";
import { manifestOf, targets } from "./manifest.mjs";

// How esbuild makes them in `out`.
export function pageBuild(site, out) {
  return {
    absWorkingDir: site,
    entryPoints: [
      { in: "styles/site.css", out: "site" },
      { in: "client/site.ts", out: "site" },
      { in: "client/search/dialogs.ts", out: "search" },
      { in: "styles/search.css", out: "search" },
      { in: "client/listing.ts", out: "listing" },
      { in: "client/reading/home.ts", out: "home" },
      { in: "client/reading/reading.ts", out: "reading" },
      { in: "client/progress/progress.ts", out: "progress" },
      { in: "client/review/review.ts", out: "review" },
      { in: "styles/learner.css", out: "learner" },
      { in: "client/moved.ts", out: "moved" },
      { in: "client/offline/offline.ts", out: "offline" },
      { in: "client/offline/kept.ts", out: "kept" },
      { in: "icons/favicon.svg", out: "favicon" },
    ],
    outdir: path.resolve(out),
    entryNames: "assets/[name]-[hash]",
    assetNames: "assets/[name]-[hash]",
    bundle: true,
    minify: true,
    metafile: true,
    format: "iife",
    charset: "utf8",
    target: targets,
    loader: { ".woff2": "file", ".svg": "copy" },
    plugins: [cutFonts],
    logLevel: "warning",
  };
}

// Builds into `out` and returns the manifest: plain name → hashed path below `out`.
export async function buildPublic(site, out) {
  const { metafile } = await build(pageBuild(site, out));
  return manifestOf(metafile, site, out);
}
