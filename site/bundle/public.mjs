// The files a reader's browser loads: one stylesheet with its fonts, one small script, the favicon.

import path from "node:path";

import { build } from "esbuild";

import { cutFonts } from "./fonts.mjs";

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
    target: ["chrome123", "firefox121", "safari17.5"],
    loader: { ".woff2": "file", ".svg": "copy" },
    plugins: [cutFonts],
    logLevel: "warning",
  });
  return manifestOf(metafile, site, path.resolve(out));
}

function manifestOf(metafile, site, out) {
  const entries = Object.keys(metafile.outputs).map((output) => {
    const hashed = path.relative(out, path.resolve(site, output)).split(path.sep).join("/");
    const plain = path.basename(hashed).replace(/-[A-Z0-9]{8}(?=\.\w+$)/, "");
    return [plain, hashed];
  });
  return Object.fromEntries(entries.sort(([a], [b]) => (a < b ? -1 : 1)));
}
