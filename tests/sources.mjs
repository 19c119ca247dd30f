// The source files of a script: its own and those of ours that it imports. A script does the same as
// before as long as none of them changes, nor a package of site/package-lock.json.

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
