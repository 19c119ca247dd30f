// Courses whose links, pipes and names lead out of them, and what is said of each. links.mjs runs
// them.

import { spawnSync } from "node:child_process";
import { mkdirSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

/** What no course may come to know: it stands in its `.git`. */
export const secret = "a-token-that-nobody-else-knows";

export const outside = "leads out of the course";
const gits = "lies in .git, which is no part of the course";
const noFile = "is neither a file nor a folder";
const circle = "is a link that leads in a circle";
const cures = {
  [outside]:
    "a course is made of its own files: put a copy there, or a link that stays inside of the course",
  [gits]: "put a copy of it into another folder of the course, and name that",
  [noFile]: "replace it: a pipe or a device is never read",
  [circle]: "put the file itself there, or a link to a file of the course",
};

// What is said of a file as a whole, of one that course.yaml lists, and of one that the lesson names
// in its line 5.
export const ofFile = (path, why) =>
  `${path}: error: ${path} ${why} [E-file-refused]\n  cure: ${cures[why]}\n`;
const listed = "  - {folder: 1-basics, title: Basics, lessons: [1.1-one]}";
const marked = (where, number, line, word, path, why) =>
  `${where}:${number}:${line.indexOf(word) + 1}: error: ${path} ${why} [E-file-refused]\n` +
  `  ${number} | ${line}\n    | ${" ".repeat(line.indexOf(word))}^${"~".repeat(word.length - 1)}\n  cure: ${cures[why]}\n`;
const ofListed = (why) =>
  marked("content/course.yaml", 3, listed, "1.1-one", "content/1-basics/1.1-one.md", why);
const ofNamed = (line, word, path, why) =>
  marked("content/1-basics/1.1-one.md", 5, line, word, path, why);
const ofModel = (path, line, what, code, advice) =>
  `${path}${line > 0 ? `:${line}:1` : ""}: error: ${what} [E-model-mjcf]\n` +
  (line > 0 ? `  ${line} | ${code}\n    | ^${"~".repeat(code.length - 1)}\n` : "") +
  "  note: content/1-basics/1.1-one.md:5:3: lesson content/1-basics/1.1-one.md uses this model\n" +
  "  5 | `{m} model.nq`\n    |   ^\n" +
  `  cure: ${advice}\n`;
const beside = "put it beside the model, or into a folder there";

// Folders of a level from which a page would come to lie elsewhere, or nowhere, and why they are none.
const levels = {
  "..": "is the folder above",
  ".": "is the folder itself",
  "a/..": "has a `/` in it, where the name of a folder ends",
  "..//": "has a `/` in it, where the name of a folder ends",
  "/etc": "has a `/` in it, where the name of a folder ends",
  ".git": "is where git keeps what is its own",
  "..\\..": "has a `\\` in it, which is a `/` on Windows",
  "index.html.gz": "ends as a file of the site does",
};

// Each with what it makes of a course, and what is said then.
export const coursesOfLevels = Object.entries(levels).map(([folder, why]) => {
  const line = `  - {folder: '${folder}', title: Basics, lessons: [1.1-one]}`;
  const make = (course) => {
    course.write("content/course.yaml", `title: Levels\nlevels:\n${line}\n`);
    const text = "---\ntitle: One\n---\n\nThe lesson.\n";
    if (!folder.startsWith("/")) course.write(`content/${folder}/1.1-one.md`, text);
  };
  const said =
    `content/course.yaml:3:15: error: a level lies in a folder of \`content/\`, and \`${folder}\` ${why} ` +
    `[E-level-folder]\n  3 | ${line}\n    |               ^${"~".repeat(folder.length - 1)}\n` +
    "  cure: give the folder one plain name, as `1-first-steps`, and write that here\n";
  return [folder, make, said];
});

// A course with one lesson, in which `body` is line 5.
export class Course {
  constructor(folder) {
    this.folder = folder;
    this.write("content/course.yaml", `title: Links\nlevels:\n${listed}\n`);
    this.lesson("Nothing.");
    this.write(".git/config", `[http]\n  extraheader = ${secret}\n`);
  }
  path(name) {
    return join(this.folder, name);
  }
  write(name, text) {
    mkdirSync(dirname(this.path(name)), { recursive: true });
    writeFileSync(this.path(name), text);
  }
  lesson(body) {
    this.write("content/1-basics/1.1-one.md", `---\ntitle: One\n---\n\n${body}\n`);
  }
  link(target, name) {
    mkdirSync(dirname(this.path(name)), { recursive: true });
    rmSync(this.path(name), { force: true, recursive: true });
    symlinkSync(target, this.path(name));
  }
  pipe(name) {
    mkdirSync(dirname(this.path(name)), { recursive: true });
    rmSync(this.path(name), { force: true });
    spawnSync("mkfifo", [this.path(name)]);
  }
  image(target) {
    this.lesson("![A picture](p.svg)");
    this.link(target, "content/1-basics/p.svg");
  }
  commands(file) {
    this.lesson(`\`\`\`sh run files="${file}"\ncat -r ${file}\n\`\`\``);
  }
  model(make) {
    this.lesson("`{m} model.nq`");
    make();
  }
}
const lesson = "content/1-basics/1.1-one.md";
const named = (file) => `\`\`\`sh run files="${file}"`;

// Each with what it makes of a course, and what is said then.
export const courses = {
  "a lesson that is /etc/passwd": [(c) => c.link("/etc/passwd", lesson), ofListed(outside)],
  "a lesson that is the environment": [
    (c) => c.link("/proc/self/environ", lesson),
    ofListed(outside),
  ],
  "a lesson that is the kernel's log": [(c) => c.link("/proc/kmsg", lesson), ofListed(outside)],
  "a lesson that is a pipe": [(c) => c.pipe(lesson), ofListed(noFile)],
  "a lesson that is a device": [(c) => c.link("/dev/zero", lesson), ofListed(outside)],
  "a lesson that is git's": [(c) => c.link("../../.git/config", lesson), ofListed(gits)],
  "a lesson by a chain of links": [
    (c) => {
      c.link("../two", lesson);
      c.link("three", "content/two");
      c.link("/etc/passwd", "content/three");
    },
    ofListed(outside),
  ],
  "a lesson in a circle of links": [
    (c) => {
      c.link("two.md", lesson);
      c.link("1.1-one.md", "content/1-basics/two.md");
    },
    ofListed(circle),
  ],
  "a level's folder elsewhere": [(c) => c.link("/etc", "content/1-basics"), ofListed(outside)],
  "a course.yaml that is /etc/passwd": [
    (c) => c.link("/etc/passwd", "content/course.yaml"),
    ofFile("content/course.yaml", outside),
  ],
  "a glossary that is /etc/passwd": [
    (c) => c.link("/etc/passwd", "content/glossary.md"),
    ofFile("content/glossary.md", outside),
  ],
  "a picture that is git's": [
    (c) => c.image("../../.git/config"),
    ofNamed("![A picture](p.svg)", "p.svg", "content/1-basics/p.svg", gits),
  ],
  "a picture that climbs": [
    (c) => c.lesson("![A picture](../../../../etc/passwd.svg)"),
    "content/1-basics/1.1-one.md:5:14: error: a picture lies in the folder of its lesson, or below it " +
      "[E-image-place]\n  5 | ![A picture](../../../../etc/passwd.svg)\n" +
      "    |              ^~~~~~~~~~~~~~~~~~~~~~~~~~\n  cure: put the file there\n",
  ],
  "models that are the whole disk": [(c) => c.link("/", "models"), ofFile("models", outside)],
  "a model that is /etc/passwd": [
    (c) => c.model(() => c.link("/etc/passwd", "models/m.xml")),
    ofModel("models/m.xml", 0, `the model's file ${outside}`, "", cures[outside]),
  ],
  "a model that is a pipe": [
    (c) => c.model(() => c.pipe("models/m.xml")),
    ofModel("models/m.xml", 0, `the model's file ${noFile}`, "", cures[noFile]),
  ],
  "a model that includes the kernel's log": [
    (c) =>
      c.model(() => {
        c.link("/proc/kmsg", "models/part.xml");
        c.write("models/m.xml", '<mujoco>\n<include file="part.xml"/>\n</mujoco>\n');
      }),
    ofModel(
      "models/m.xml",
      2,
      "the file 'part.xml' lies outside of the folder of the model",
      '<include file="part.xml"/>',
      beside,
    ),
  ],
  "commands that see git's": [
    (c) => c.commands(".git/config"),
    ofNamed(named(".git/config"), ".git/config", ".git/config", gits),
  ],
  "commands that see a link out": [
    (c) => {
      c.commands("examples/data");
      c.link("/proc/self/environ", "examples/data");
    },
    ofNamed(named("examples/data"), "examples/data", "examples/data", outside),
  ],
  "commands that see a folder with a link out": [
    (c) => {
      c.commands("examples");
      c.write("examples/fine.txt", "fine");
      c.link("/etc/passwd", "examples/deep/data");
    },
    ofNamed(named("examples"), "examples", "examples/deep/data", outside),
  ],
  "examples that are the whole disk": [(c) => c.link("/", "examples"), ofFile("examples", outside)],
  "a header that is /etc/passwd": [
    (c) => c.link("/etc/passwd", "examples/include/a.hpp"),
    ofFile("examples/include/a.hpp", outside),
  ],
  "a header that is a pipe in a folder": [
    (c) => c.pipe("examples/include/deep/a.hpp"),
    ofFile("examples/include/deep/a.hpp", noFile),
  ],
  "a program that is /etc/passwd": [
    (c) => {
      c.lesson("```cpp file=examples/a.cpp\nint main() {}\n```");
      c.link("/etc/passwd", "examples/a.cpp");
    },
    ofNamed("```cpp file=examples/a.cpp", "examples/a.cpp", "examples/a.cpp", outside),
  ],
  "a pipe among the headers beside a program": [
    (c) => {
      const code = '#include "deep/fine.h"\nint main() {}';
      c.lesson(`\`\`\`cpp file=examples/a.cpp\n${code}\n\`\`\``);
      c.write("examples/a.cpp", `${code}\n`);
      c.write("examples/deep/fine.h", '#include "other.h"\n');
      c.pipe("examples/deep/other.h");
    },
    ofNamed(
      "```cpp file=examples/a.cpp",
      "```cpp file=examples/a.cpp",
      "examples/deep/other.h",
      noFile,
    ),
  ],
  "a theme's style that is /etc/passwd": [
    (c) => c.link("/etc/passwd", "theme/style.css"),
    ofFile("theme/style.css", outside),
  ],
  "a theme's template that is git's": [
    (c) => c.link("../../.git/config", "theme/templates/page.hbs"),
    ofFile("theme/templates/page.hbs", gits),
  ],
  "a theme elsewhere": [(c) => c.link("/etc", "theme"), ofFile("theme", outside)],
};
