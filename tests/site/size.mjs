// Prints what the site's pages, styles, scripts and posters weigh, as they are and as a server
// compresses them. No bar yet.

import { globSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, gzipSync } from "node:zlib";

const folder = process.argv[2] ?? "build/release/test-site";
const compressed = new Set(["html", "css", "js", "svg"]); // a picture is already

function kilobytes(bytes) {
  return `${(bytes / 1000).toFixed(1)} KB`.padStart(9);
}

function row(path) {
  const bytes = readFileSync(join(folder, path));
  const sizes = compressed.has(path.split(".").at(-1))
    ? [bytes, gzipSync(bytes, { level: 9 }), brotliCompressSync(bytes)].map(({ length }) => length)
    : Array(3).fill(bytes.length);
  console.log(`${sizes.map(kilobytes).join(" ")}  ${path}`);
}

console.log("    plain      gzip    brotli");
for (const kind of ["html", "css", "js", "svg", "webp"]) {
  for (const path of globSync(`**/*.${kind}`, { cwd: folder }).sort()) row(path);
}
