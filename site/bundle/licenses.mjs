// The licences of what the site ships that others made.

import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";
import path from "node:path";

const shipped = {
  "katex.txt": "katex/LICENSE",
  "three.txt": "three/LICENSE",
  "minisearch.txt": "minisearch/LICENSE.txt",
  "uplot.txt": "uplot/LICENSE",
  "vega.txt": "vega/LICENSE",
  "vega-interpreter.txt": "vega-interpreter/LICENSE",
  "vega-lite.txt": "vega-lite/LICENSE",
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

// LLVM's, and that of its C++ library, is Apache's with an exception that emscripten's file has; the C
// library is musl with WASI's calls.
const ofCompiler = {
  "llvm.txt": "/usr/share/doc/emscripten/copyright",
  "apache-2.0.txt": "/usr/share/common-licenses/Apache-2.0",
  "musl.txt": "/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT",
  "eigen.txt": "/usr/share/doc/libeigen3-dev/copyright",
};

// Of the compiler of programs in the page. Two of its packages name their licence only.
export async function copyCompilerLicenses(site, out) {
  await mkdir(out, { recursive: true });
  const lines = ["@yowasp/clang", "xz-decompress"].map(async (name) => {
    const file = path.join(site, "node_modules", name, "package.json");
    const { version, license, author, homepage } = JSON.parse(await readFile(file, "utf8"));
    return `${name} ${version}: ${license}, ${author}, ${homepage}\n`;
  });
  const changed = "In llvm.core.wasm, mjcourse changed how much memory is taken at a time.\n";
  await writeFile(path.join(out, "packages.txt"), (await Promise.all(lines)).join("") + changed);
  const copies = Object.entries(ofCompiler).map(([name, source]) =>
    copyFile(source, path.join(out, name)),
  );
  await Promise.all(copies);
}
