// Whether JSON that the generator writes has the shape that TypeScript of the site gives it.

import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import ts from "../../site/node_modules/typescript/lib/typescript.js";

const options = {
  strict: true,
  noEmit: true,
  types: [],
  target: ts.ScriptTarget.ES2022,
  module: ts.ModuleKind.ESNext,
  moduleResolution: ts.ModuleResolutionKind.Bundler,
};

/** The compiler's complaints when `text` is taken for the `type`, of the source `types` or a list
 * of such: keys that are missing, too many, or of another kind. */
export function misfits(text, type, types) {
  const here = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
  const file = join(here, "it.ts");
  const module = resolve(types).replace(/\.ts$/, ".js");
  writeFileSync(
    file,
    `import type * as types from "${module}";\nexport const it: types.${type} = ${text};`,
  );
  const found = ts.getPreEmitDiagnostics(ts.createProgram([file], options));
  rmSync(here, { recursive: true });
  return found.map(({ messageText, start }) => {
    const line = start === undefined ? 0 : text.slice(0, start).split("\n").length - 1;
    return `${type}, line ${line}: ${ts.flattenDiagnosticMessageText(messageText, "\n")}`;
  });
}
