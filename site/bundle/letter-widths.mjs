// How wide the letters of the site's sans are, for plots, which are laid out where there is no
// browser to ask. In thousandths of an em, at the two weights in which a plot is set.

import { readFile } from "node:fs/promises";
import path from "node:path";

import { Font } from "./sfnt.mjs";

const files = ["latin", "greek"];
const beyond = 0x2300; // letters and signs; what comes after them has no place in a plot's labels

export async function letterWidths(site) {
  const folder = path.join(site, "node_modules/@fontsource-variable/source-sans-3/files");
  const widthsAt = async (weight) => {
    const widths = new Map();
    for (const file of files) {
      const woff2 = await readFile(path.join(folder, `source-sans-3-${file}-wght-normal.woff2`));
      for (const [code, width] of (await Font.of(woff2, weight)).widths) {
        if (code >= 0x20 && code < beyond) widths.set(code, Math.round(1000 * width));
      }
    }
    const sorted = [...widths].sort(([a], [b]) => a - b);
    return Object.fromEntries(sorted.map(([code, width]) => [String.fromCodePoint(code), width]));
  };
  return { regular: await widthsAt(400), bold: await widthsAt(600) };
}
