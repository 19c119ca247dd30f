// The files a reader's browser loads: a stylesheet with its fonts, one small script, the favicon;
// and what only some pages have of scripts and styles, or have once they are shown or asked for.

import { build } from "esbuild";

import { cutFonts } from "./fonts.mjs";
import { forBrowsers, manifestOf } from "./manifest.mjs";

// How esbuild makes them in `out`.
export function pageBuild(site, out) {
  return {
    ...forBrowsers(site, out),
    entryPoints: [
      { in: "browser/styles/site.css", out: "site" },
      { in: "browser/client/site.ts", out: "site" },
      { in: "browser/client/search/dialogs.ts", out: "search" },
      { in: "browser/styles/search.css", out: "search" },
      { in: "browser/client/listing.ts", out: "listing" },
      { in: "browser/client/reading/home.ts", out: "home" },
      { in: "browser/client/reading/reading.ts", out: "reading" },
      { in: "browser/client/progress/progress.ts", out: "progress" },
      { in: "browser/client/review/review.ts", out: "review" },
      { in: "browser/styles/learner.css", out: "learner" },
      { in: "browser/client/moved.ts", out: "moved" },
      { in: "browser/client/offline/offline.ts", out: "offline" },
      { in: "browser/client/offline/kept.ts", out: "kept" },
      { in: "browser/icons/favicon.svg", out: "favicon" },
    ],
    entryNames: "assets/[name]-[hash]",
    assetNames: "assets/[name]-[hash]",
    metafile: true,
    format: "iife",
    loader: { ".woff2": "file", ".svg": "copy" },
    plugins: [cutFonts],
  };
}

// The pieces of fonts that many pages are set in, under names for the generator (page/html/page_fonts.cpp):
// a page asks for its own before any line is laid out.
const namedFonts = {
  "serif.woff2": "source-serif-4-latin-wght-normal-400-650-1.woff2",
  "italic.woff2": "source-serif-4-latin-wght-italic-400-1.woff2",
  "sans.woff2": "source-sans-3-latin-wght-normal-400-650-1.woff2",
  "sans-italic.woff2": "source-sans-3-latin-wght-italic-400-1.woff2",
  "mono.woff2": "source-code-pro-latin-wght-normal-400-650-1.woff2",
  "formula.woff2": "KaTeX_Main-Regular-400-1.woff2",
  "letters.woff2": "KaTeX_Math-Italic-400-1.woff2",
  "greek.woff2": "KaTeX_Math-Italic-400-2.woff2",
  "upright-bold.woff2": "KaTeX_Main-Bold-700-1.woff2",
  "bold-letters.woff2": "KaTeX_Math-BoldItalic-700-1.woff2",
  "bold-greek.woff2": "KaTeX_Math-BoldItalic-700-2.woff2",
  "large.woff2": "KaTeX_Size1-Regular-400-1.woff2",
  "larger.woff2": "KaTeX_Size2-Regular-400-1.woff2",
};

// Builds into `out` and returns the manifest: plain name → hashed path below `out`.
export async function buildPublic(site, out) {
  const { metafile } = await build(pageBuild(site, out));
  const manifest = manifestOf(metafile, site, out);
  for (const [name, piece] of Object.entries(namedFonts)) {
    if (!manifest[piece])
      throw new Error(`the fonts have no piece ${piece} (site/bundle/font-cuts.mjs)`);
    manifest[name] = manifest[piece];
  }
  return manifest;
}
