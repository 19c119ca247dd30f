// The source of a script together with those of ours that it imports: while they are the same, and the
// packages of site/package-lock.json are, so is what the script does.

import { readFileSync } from "node:fs";
import { dirname, join, sep } from "node:path";

/** The paths of the script at `path` and of what it imports, in a fixed order. */
export function sourcesOf(path, known = new Set()) {
  if (known.has(path)) return [...known];
  known.add(path);
  const imports = readFileSync(path, "utf8").matchAll(/(?:from|import)\s*\(?"(\.[^"]+)"/g);
  for (const [, address] of imports) {
    const imported = join(dirname(path), address);
    if (!imported.split(sep).includes("node_modules")) sourcesOf(imported, known);
  }
  return [...known];
}
