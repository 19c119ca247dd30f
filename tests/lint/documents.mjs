// The documents name what is there: each source and each folder in backticks, and each link. A path counts
// from the document's own folder, from generator/, or from the top of the repository.
//
//   node tests/lint/documents.mjs [ROOT]

import { existsSync, globSync, readFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";

const root = resolve(process.argv[2] ?? join(import.meta.dirname, "../.."));
const documents = globSync(["{README,CONTRIBUTING}.md", "{generator,site,tests}/**/README.md"], {
  cwd: root,
  exclude: ["**/node_modules", "generator/cli/skeleton"],
});
const source = /`([\w./-]+\.(?:h|hpp|cpp|c|ts|mjs|hbs|cmake))`/g;
const folder = /`((?:generator|site|tests|content)\/[\w./-]*\/)`/g;
const link = /\]\((?!https?:)([^)#\s]*)(#[^)\s]+)?\)/g;

const anchorsIn = (file) =>
  [...readFileSync(file, "utf8").matchAll(/^#+ (.*)$/gm)].map(([, words]) =>
    words
      .toLowerCase()
      .replace(/[^\w -]/g, "")
      .replaceAll(" ", "-"),
  );

const problems = documents.flatMap((document) => {
  const text = readFileSync(join(root, document), "utf8");
  const places = [dirname(document), "generator", "."].map((place) => join(root, place));
  const named = [...text.matchAll(source), ...text.matchAll(folder)].map(([, path]) => path);
  const lost = named.filter((path) => !places.some((place) => existsSync(join(place, path))));
  for (const [whole, path, anchor] of text.matchAll(link)) {
    const file = path === "" ? join(root, document) : join(places[0], path);
    const good = existsSync(file) && (!anchor || anchorsIn(file).includes(anchor.slice(1)));
    if (!good) lost.push(whole);
  }
  // NAME stands for any.
  return lost.filter((path) => !path.includes("NAME")).map((path) => `${document}: no ${path}`);
});
for (const problem of problems) console.error(problem);
console.log(`${documents.length} documents, ${problems.length} names of what is not there`);
process.exitCode = problems.length > 0 || documents.length === 0 ? 1 : 0;
