// A test of X lies where X lies: each generator/**/X.cpp has tests/generator/**/X_test.cpp, or says at
// its head (of X.h, where there is one) which test covers it, in a line `// Tested by PATH.`, from the
// root on. And each such test has its source.
//
//   node tests/lint/test_mirror.mjs ROOT

import { existsSync, globSync, readFileSync } from "node:fs";
import { join } from "node:path";

const [root] = process.argv.slice(2);
const generator = join(root, "generator");
const problems = [];
const named = new Set();

// What the comment says with which a file begins.
function opening(file) {
  const text = readFileSync(join(generator, file), "utf8");
  return text.match(/^(\/\/.*\n)*/)[0];
}

const sources = globSync("**/*.{h,cpp,c}", { cwd: generator, exclude: ["cli/skeleton/**"] }).sort();
for (const file of sources) {
  for (const [, path] of opening(file).matchAll(/^\/\/ Tested by (.*)\.$/gm)) {
    named.add(path);
    if (path.startsWith("tests/") && existsSync(join(root, path))) continue;
    problems.push(`generator/${file}: there is no test ${path}`);
  }
}

const units = sources.filter((file) => file.endsWith(".cpp"));
for (const file of units) {
  const unit = file.replace(/\.cpp$/, "");
  const test = `tests/generator/${unit}_test.cpp`;
  if (existsSync(join(root, test))) continue;
  const head = existsSync(join(generator, `${unit}.h`)) ? `${unit}.h` : file;
  if (/^\/\/ Tested by /m.test(opening(head))) continue;
  problems.push(
    `generator/${head}: there is no ${test}, and no line at its head, ` +
      "`// Tested by PATH.`, names another test",
  );
}

const tests = globSync("**/*_test.cpp", { cwd: join(root, "tests/generator") }).sort();
for (const test of tests) {
  const unit = test.replace(/_test\.cpp$/, "");
  const path = `tests/generator/${test}`;
  const found = ["h", "cpp", "c"].some((ending) => sources.includes(`${unit}.${ending}`));
  if (found || named.has(path)) continue;
  problems.push(`${path}: there is no generator/${unit}.cpp, and no file there names this test`);
}
if (units.length === 0) problems.push(`no sources were found below ${generator}`);

for (const problem of problems) console.error(problem);
console.log(`${units.length} sources, ${tests.length} tests, ${problems.length} without the other`);
process.exitCode = problems.length > 0 ? 1 : 0;
