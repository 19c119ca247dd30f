// The licences of what the site ships that others made.

import { copyFile, mkdir } from "node:fs/promises";
import path from "node:path";

const shipped = {
  "katex.txt": "katex/LICENSE",
  "three.txt": "three/LICENSE",
  "minisearch.txt": "minisearch/LICENSE.txt",
  "uplot.txt": "uplot/LICENSE",
  "codemirror.txt": "@codemirror/view/LICENSE",
  "lezer.txt": "@lezer/common/LICENSE",
  "source-serif-4.txt": "@fontsource-variable/source-serif-4/LICENSE",
  "source-sans-3.txt": "@fontsource-variable/source-sans-3/LICENSE",
  "source-code-pro.txt": "@fontsource-variable/source-code-pro/LICENSE",
};

export async function copyLicenses(site, out) {
  await mkdir(out, { recursive: true });
  const copies = Object.entries(shipped).map(([name, source]) =>
    copyFile(path.join(site, "node_modules", source), path.join(out, name)),
  );
  await Promise.all(copies);
}
