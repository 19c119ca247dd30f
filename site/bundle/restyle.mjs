// Bundles the stylesheet while it is being edited: node site/bundle/restyle.mjs OUTDIR
//
// For each line that comes on stdin, OUTDIR gets the same stylesheet that build.mjs makes, and a line of
// JSON on stdout says how that went:
//
//   {"css": "assets/site-1A2B3C4D.css", "mistakes": []}
//   {"css": "", "mistakes": [{"file": "site/browser/styles/x.css", "line": 3, "column": 5, "width": 4,
//                             "message": "Expected …", "excerpt": "  colour red"}]}
//
// The fonts, which it names, are those of the last build.

import { createHash } from "node:crypto";
import { mkdir, writeFile } from "node:fs/promises";
import path from "node:path";
import { createInterface } from "node:readline";

import { build, context } from "esbuild";

import { pageBuild } from "./public.mjs";

const site = path.resolve(import.meta.dirname, "..");
const [out] = process.argv.slice(2);
if (!out) {
  console.error("usage: node site/bundle/restyle.mjs OUTDIR");
  process.exit(2);
}

const options = {
  ...pageBuild(site, out),
  entryPoints: [{ in: "browser/styles/site.css", out: "site" }],
  logLevel: "silent",
  write: false,
};
const fonts = ["woff2", "woff", "ttf"].map((kind) => `*.${kind}`);

// Cutting fonts takes longer than all else, and nobody edits them: of the stylesheets that name
// some, esbuild gets what became of them.
async function sheetsWithFonts() {
  const { metafile } = await build({ ...options, plugins: [], external: fonts });
  const isFont = ({ path: file }) => fonts.some((kind) => file.endsWith(kind.slice(1)));
  const sheets = Object.keys(metafile.inputs).filter((sheet) =>
    metafile.inputs[sheet].imports.some(isFont),
  );
  const entryPoints = sheets.map((sheet, index) => ({ in: sheet, out: `sheet-${index}` }));
  const { outputFiles } = await build({ ...options, entryPoints, entryNames: "assets/[name]" });
  return new Map(
    sheets.map((sheet, index) => [
      path.join(site, sheet),
      outputFiles.find((file) => path.basename(file.path) === `sheet-${index}.css`).text,
    ]),
  );
}

const known = await sheetsWithFonts();
const takeSheets = {
  name: "take-sheets",
  setup(hooks) {
    hooks.onLoad({ filter: /node_modules.*\.css$/ }, ({ path: sheet }) =>
      known.has(sheet) ? { contents: known.get(sheet), loader: "css" } : undefined,
    );
  },
};
const bundler = await context({ ...options, plugins: [takeSheets], external: fonts });

const mistake = ({ text, location }) => ({
  file: location ? path.posix.join("site", location.file) : "",
  line: location?.line ?? 0,
  column: (location?.column ?? -1) + 1,
  width: location?.length || 1,
  message: text,
  excerpt: location?.lineText ?? "",
});

async function bundle() {
  try {
    const { outputFiles, warnings } = await bundler.rebuild();
    if (warnings.length > 0) return { css: "", mistakes: warnings.map(mistake) };
    const [{ contents }] = outputFiles.filter((file) => file.path.endsWith(".css"));
    const hash = createHash("sha256").update(contents).digest("hex").slice(0, 8).toUpperCase();
    const css = `assets/site-${hash}.css`;
    await mkdir(path.join(out, "assets"), { recursive: true });
    await writeFile(path.join(out, css), contents);
    return { css, mistakes: [] };
  } catch (error) {
    if (!Array.isArray(error.errors)) throw error;
    return { css: "", mistakes: error.errors.map(mistake) };
  }
}

// Each line is asked for once the one before was answered.
const lines = createInterface({ input: process.stdin });
lines.on("line", async () => process.stdout.write(`${JSON.stringify(await bundle())}\n`));
lines.on("close", () => bundler.dispose());
