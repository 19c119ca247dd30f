// Every source is formatted, as clang-format and Prettier have it, and ESLint finds nothing in the scripts.
//
//   node tests/lint/format.mjs
//
// A file that was found formatted is not looked at again before it, the tool or what the tool is told
// changes. What ESLint says of a file depends on others that it imports, so it looks at all or at none.

import { execFileSync } from "node:child_process";
import { globSync, readFileSync } from "node:fs";
import { resolve } from "node:path";

import { Stamps } from "../stamps.mjs";
import { complaintsOf, lookAt } from "./look.mjs";

process.chdir(resolve(import.meta.dirname, "../.."));
const modules = resolve("site/node_modules");

// The files that match, without what others wrote, and without the programs in tests/accept, which are
// cases to the byte.
function filesLike(...patterns) {
  const exclude = ["site/node_modules", "tests/accept/**/*.{cpp,hpp,h,c}"];
  const found = globSync(patterns, { exclude, withFileTypes: true });
  return found
    .filter((entry) => entry.isFile())
    .map((entry) => `${entry.parentPath}/${entry.name}`)
    .sort();
}

// A task for one file; `tool` is the version of what looks at it, and `settings` the files that tell it how.
const taskOf = (tool, settings, look) => (file) => ({
  name: file,
  stamp: Stamps.of(tool, ...settings, file, readFileSync(file)),
  look: () => look(file),
});
const textsOf = (files) => files.map((file) => readFileSync(file));

const clangFormat = taskOf(
  execFileSync("clang-format-16", ["--version"]),
  textsOf(filesLike(".clang-format", "{generator,tests,examples}/**/.clang-format")),
  (file) => complaintsOf("clang-format-16", ["--dry-run", "-Werror", file]),
);

const ignorePath = "site/.prettierignore";
const config = "site/.prettierrc.json";
const prettier = taskOf(
  readFileSync(`${modules}/prettier/package.json`),
  textsOf([ignorePath, config, ".editorconfig"]),
  async (file) => {
    const { check, getFileInfo, resolveConfig } = await import(`${modules}/prettier/index.mjs`);
    const options = await resolveConfig(file, { config, editorconfig: true });
    const { ignored, inferredParser } = await getFileInfo(file, { ignorePath });
    if (ignored || !inferredParser) return "";
    try {
      const good = await check(readFileSync(file, "utf8"), { ...options, filepath: file });
      return good ? "" : `${file}: Prettier would format it otherwise\n`;
    } catch (error) {
      return `${file}: ${error.message}\n`;
    }
  },
);

const inSite = filesLike("site/**", "site/.*");
const scripts = filesLike("tests/**/*.mjs");
const linted = [...inSite.filter((file) => /\.(ts|mjs|js|json)$/.test(file)), ...scripts];
const eslint = {
  name: "ESLint",
  stamp: Stamps.of("eslint", ...linted.flatMap((file) => [file, readFileSync(file)])),
  look: () =>
    complaintsOf(process.execPath, [
      `${modules}/eslint/bin/eslint.js`,
      "--config",
      "site/eslint.config.mjs",
      "site",
      "tests",
    ]),
};

await lookAt(new Stamps("format"), [
  eslint,
  ...[...inSite, ...scripts].map(prettier),
  ...filesLike("{generator,tests,examples}/**/*.{cpp,hpp,h,c}").map(clangFormat),
]);
