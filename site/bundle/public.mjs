// The files a reader's browser loads: one stylesheet with its fonts, one small script, the favicon.

import { readFile } from "node:fs/promises";
import path from "node:path";

import { build } from "esbuild";

import { manifestOf, targets } from "./manifest.mjs";

// KaTeX's stylesheet names each font in three formats; every browser that runs this site reads WOFF2.
const katexWoff2Only = {
  name: "katex-woff2-only",
  setup(hooks) {
    hooks.onLoad({ filter: /katex(\.min)?\.css$/ }, async ({ path: file }) => {
      const css = await readFile(file, "utf8");
      const older = /,\s*url\([^)]*\.(?:woff|ttf)\)\s*format\(["'](?:woff|truetype)["']\)/g;
      return { contents: css.replace(older, ""), loader: "css" };
    });
  },
};

// Builds into `out` and returns the manifest: plain name → hashed path below `out`.
export async function buildPublic(site, out) {
  const { metafile } = await build({
    absWorkingDir: site,
    entryPoints: [
      { in: "styles/site.css", out: "site" },
      { in: "client/site.ts", out: "site" },
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
    plugins: [katexWoff2Only],
    logLevel: "warning",
  });
  return manifestOf(metafile, site, out);
}
