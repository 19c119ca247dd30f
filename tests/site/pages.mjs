// Every page of a site, opened once for each view, and looked at by all checks that want it so. A look that
// found nothing wrong is not done again before something changes (page-stamps.mjs).
//
//   node tests/site/pages.mjs SITE CHECK...
//
// A check is a module of tests/site/checks/:
//
//   looks      a function for each view (page-walk.mjs) that it wants a page in, of Playwright's page and
//              the Visit; it gives facts, which are JSON
//   kinds      of files that it wants (page-walk.mjs); without this, pages
//   concerns   whether it wants one with that HTML; without this, it wants each
//   conclude   what can be said only of the whole site: of the facts of its views, each a Map by paths
//   settings   files that decide beside the module and what it imports
//
// Between looks the page's size, scheme and medium are set back. All else a check takes back itself, or
// it stands at the end of this list, in whose order they look: pictures and fonts are to come for the
// first time, and what accessibility unfolds stays so.

import { join } from "node:path";

import { Walk } from "./page-walk.mjs";
import { folder } from "./browser.mjs";

const order = ["markup", "references", "fonts", "links", "layout", "math", "questions", "quiz"];
order.push("demo", "accessibility");

async function checkOf(name) {
  if (!order.includes(name)) throw new Error(`there is no check ${name}, but ${order.join(", ")}`);
  const script = join(import.meta.dirname, "checks", `${name}.mjs`);
  return { kinds: ["page"], concerns: () => true, ...(await import(script)), name, script };
}

const names = process.argv.slice(3);
const wanted = order.filter((name) => names.includes(name));
const strange = names.filter((name) => !order.includes(name));
const checks = await Promise.all([...wanted, ...strange].map(checkOf));
const walk = new Walk(folder, checks);
await walk.run();
for (const check of checks) walk.conclude(check);

// By check and page: which page was looked at first, is chance.
for (const problem of walk.problems.toSorted()) console.error(problem);
for (const { name } of checks) {
  const { looks, anew } = walk.countsOf(name);
  const problems = walk.problems.filter((problem) => problem.startsWith(`${name}: `)).length;
  console.log(`${name}: ${looks} looks, ${anew} done anew, ${problems} problems`);
}
const empty = checks.length === 0 || checks.some(({ name }) => walk.countsOf(name).looks === 0);
if (empty) console.error("a check had nothing to look at");
process.exitCode = walk.problems.length > 0 || empty ? 1 : 0;
