// What the fuzzers begin with, beside seeds/NAME: the lessons, glossaries, course files and models that
// the project has.

import { createHash } from "node:crypto";
import { existsSync, globSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";

const root = resolve(import.meta.dirname, "../..");

// The course, and the tiny ones of the tests.
function courses() {
  const files = globSync("tests/{courses,accept,site}/**/content/course.yaml", { cwd: root });
  return ["content/course.yaml", ...files].sort().map((file) => dirname(join(root, file)));
}

function lessonsOf(content) {
  return globSync("*/*.md", { cwd: content })
    .sort()
    .map((file) => join(content, file))
    .filter((file) => statSync(file).isFile())
    .map((file) => readFileSync(file, "utf8"));
}

const lessons = () => courses().flatMap(lessonsOf);

function textOf(file) {
  return existsSync(file) ? [readFileSync(file, "utf8")] : [];
}

// Code spans such as `{joint_zoo} model.nq`.
const values = (text) => [...text.matchAll(/`(\{[^`\n]+)`/g)].map(([, code]) => code);

const seedsOf = {
  lesson: lessons,
  front_matter: () => lessons().flatMap((text) => /^---\n(.*?)\n---\n/s.exec(text)?.[1] ?? []),
  json: () =>
    lessons().flatMap((text) =>
      [...text.matchAll(/^`{3,}((?:lab simlab|quiz|figure|plot)\n.*?)^`{3,}$/gms)].map(
        ([, fence]) => fence,
      ),
    ),
  glossary: () => courses().flatMap((content) => textOf(join(content, "glossary.md"))),
  course: () =>
    courses().map((content) => {
      const listed = (text) => text.replace(/lessons: .*/, "lessons: [1.1-x]");
      const parts = [
        listed(readFileSync(join(content, "course.yaml"), "utf8")).replace(
          /folder: \S+?([,}\n])/,
          "folder: 1-a$1",
        ),
        lessonsOf(content)[0] ?? "",
        ...textOf(join(content, "glossary.md")),
      ];
      return parts.join("%%%\n");
    }),
  value: () => lessons().flatMap(values),
  model: () =>
    globSync("{models,tests/**/models}/*.xml", { cwd: root })
      .sort()
      .flatMap((file) => textOf(join(root, file))),
  output: () =>
    lessons().flatMap((text) =>
      [...text.matchAll(/^`{3,}text[^\n]*\n(.*?)^`{3,}$/gms)].map(
        ([, stated]) => `\n${stated}=====\n${stated.replaceAll("1", "2")}`,
      ),
    ),
};

// Writes the seeds of fuzzer `name` into `folder`; gives how many there are.
export function writeSeeds(name, folder) {
  const seeds = new Set(seedsOf[name]?.());
  for (const seed of seeds) {
    writeFileSync(join(folder, createHash("sha1").update(seed).digest("hex")), seed);
  }
  return seeds.size;
}
