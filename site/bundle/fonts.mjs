// An esbuild plugin that cuts the fonts down to what pages use: a page of Latin text would load
// 250 KB of them, and needs 100.
//
// It rewrites the @font-face rules of the packages that bring the fonts. Each rule becomes several,
// for the weights and the pieces that font-cuts.mjs names; their files are made here, from the
// package's, when esbuild asks for them. What is not cut keeps its file.
//
// The SIL Open Font License allows this, but reserves the names "Source" and "KaTeX": a changed file
// may not present itself by them. So the names inside of the pieces are others; the family names in
// the stylesheet are handles that no reader is shown. The copyright inside stays as it is.

import { readFile } from "node:fs/promises";
import path from "node:path";

import { FontCutterPool } from "./font-cutter.mjs";
import { pieces, weights } from "./font-cuts.mjs";
import { common, everything, formatRanges, parseRanges, without } from "./unicode-range.mjs";

export const cutFonts = {
  name: "cut-fonts",
  setup(hooks) {
    const cuts = new Map(); // a piece's file name → how it is made
    const pool = new FontCutterPool();

    hooks.onLoad({ filter: /(@fontsource-variable.*|katex(\.min)?)\.css$/ }, async (args) => {
      const css = await readFile(args.path, "utf8");
      const folder = path.dirname(args.path);
      const contents = css.replace(/@font-face\s*{([^}]*)}/g, (_, body) =>
        facesOf(body, folder, cuts).join("\n"),
      );
      return { contents, loader: "css" };
    });
    hooks.onResolve({ filter: /^cut:/ }, (args) => {
      return { path: args.path.slice("cut:".length), namespace: "cut" };
    });
    hooks.onLoad({ filter: /.*/, namespace: "cut" }, async (args) => {
      return { contents: await pool.cut(cuts.get(args.path)), loader: "file" };
    });
    hooks.onEnd(() => pool.close());
  },
};

// The rules that the rule with this body becomes; `cuts` gets the files that they name.
function facesOf(body, folder, cuts) {
  const face = Object.fromEntries(
    [...body.matchAll(/([a-z-]+)\s*:\s*([^;]+)/g)].map(([, name, value]) => [name, value.trim()]),
  );
  const url = face.src.match(/url\(["']?([^"')]*\.woff2)["']?\)/)[1];
  const variable = face.src.includes("variations");
  face["font-family"] = face["font-family"].replace(" Variable", "");
  const name = path.basename(url, ".woff2");
  const whole = face["unicode-range"] ? parseRanges(face["unicode-range"]) : everything;
  const parts = split(whole, pieces[name] ?? []);

  return (variable ? weights[face["font-style"]] : [face["font-weight"]]).flatMap((weight) =>
    parts.map((ranges, index) => {
      let src = url;
      if (parts.length > 1) {
        const piece = `${name}-${weight.replace(" ", "-")}-${index + 1}.woff2`;
        const axis = variable ? axisOf(weight) : undefined;
        cuts.set(piece, { file: path.join(folder, url), ranges, axis });
        src = `cut:${piece}`;
      }
      return rule({ ...face, "font-weight": weight, src, "unicode-range": rangeOf(ranges) });
    }),
  );
}

// The pieces of `whole`, and what they leave of it.
function split(whole, wanted) {
  let rest = whole;
  const parts = wanted.map((ranges) => {
    const part = common(rest, ranges);
    rest = without(rest, ranges);
    return part;
  });
  return [...parts, rest];
}

function axisOf(weight) {
  const [min, max] = weight.split(" ").map(Number);
  return max === undefined ? min : { min, max };
}

const rangeOf = (ranges) => (ranges === everything ? undefined : formatRanges(ranges));

function rule({ src, "unicode-range": ranges, ...face }) {
  const lines = Object.entries(face).map(([name, value]) => `${name}:${value};`);
  if (ranges) lines.push(`unicode-range:${ranges};`);
  return `@font-face{${lines.join("")}src:url("${src}") format("woff2")}`;
}
