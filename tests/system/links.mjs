// Courses whose links, pipes and names lead out of them: nothing of what they lead to is read, shown
// or written, and each ends soon with a message. As we are, and where we are root, as an ordinary
// user as well.
//
//   node tests/system/links.mjs MJCOURSE

import { spawnSync } from "node:child_process";
import {
  chownSync,
  existsSync,
  lchownSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  renameSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";

const mjcourse = resolve(process.argv[2]);
const ordinary = 54321; // a user who has nothing
const secret = "a-token-that-nobody-else-knows";
const passwd = readFileSync("/etc/passwd", "utf8").split("\n")[0];
const mostSeconds = 20;

const failures = [];
const expect = (good, what) => good || failures.push(what);

const outside = "leads out of the course";
const gits = "lies in .git, which is no part of the course";
const noFile = "is not a file";
const circle = "is a link that leads in a circle";
const cures = {
  [outside]:
    "a course is made of its own files: put a copy there, or a link that stays inside of the course",
  [gits]: "put a copy of it into another folder of the course, and name that",
  [noFile]: "put a plain file there: a pipe or a device is never read",
  [circle]: "put the file itself there, or a link to a file of the course",
};

// What is said of a file as a whole, of one that course.yaml lists, and of one that the lesson names
// in its line 5.
const ofFile = (path, why) =>
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

// A course with one lesson, in which `body` is line 5.
class Course {
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
const courses = {
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

let home = "";
let count = 0;

function fresh(user) {
  const folder = join(home, `course-${++count}`);
  mkdirSync(folder);
  return { course: new Course(folder), user };
}

function own(path, user) {
  if (user !== undefined) spawnSync("chown", ["-hR", `${user}:${user}`, path]);
}

function run(words, course, user) {
  const begin = Date.now();
  const place = mkdtempSync(join(home, "own-"));
  own(place, user);
  own(course.folder, user);
  const came = spawnSync(mjcourse, [...words, "--course", course.folder], {
    encoding: "utf8",
    cwd: "/",
    timeout: 1000 * mostSeconds,
    killSignal: "SIGKILL",
    env: {
      PATH: process.env.PATH,
      TMPDIR: place,
      XDG_CACHE_HOME: place,
      TOKEN: secret,
    },
    ...(user === undefined ? {} : { uid: user, gid: user }),
  });
  return { ...came, seconds: (Date.now() - begin) / 1000 };
}

// Is anything of a target in what was said, or in a file that was written?
function leaks({ stdout, stderr }, folder) {
  const tells = (text) => text.includes(secret) || text.includes(passwd);
  if (tells(stdout) || tells(stderr)) return "the output";
  if (!existsSync(folder)) return "";
  const files = readdirSync(folder, { recursive: true, withFileTypes: true });
  const told = files.find(
    (file) =>
      file.isFile() && tells(readFileSync(join(file.parentPath ?? file.path, file.name), "latin1")),
  );
  return told === undefined ? "" : told.name;
}

function isRefused(name, make, said, user) {
  const who = user === undefined ? name : `${name}, as an ordinary user`;
  const { course } = fresh(user);
  make(course);
  const site = join(course.folder, "build");
  const came = run(["build"], course, user);
  expect(came.status === 1, `${who}: exit ${came.status} after ${came.seconds} s`);
  expect(came.stderr.trim() === said.trim(), `${who}: it said\n${came.stderr}and not\n${said}`);
  const told = leaks(came, site);
  expect(told === "", `${who}: the target's text is in ${told}`);
  expect(!existsSync(join(site, "site")), `${who}: a site was written`);
}

// What is inside is followed.
function isFollowed(user) {
  const { course } = fresh(user);
  course.lesson("The lesson.\n\n![A picture](p.svg)\n\n`{m} model.nq`");
  mkdirSync(course.path("shared"));
  renameSync(course.path("content/1-basics"), course.path("shared/level"));
  course.link("../shared/level", "content/1-basics");
  course.write("shared/q.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>');
  course.link("../q.svg", "shared/level/p.svg");
  course.write("shared/models/real.xml", "<mujoco/>");
  course.link("shared/models", "models");
  course.link("real.xml", "models/m.xml");
  const came = run(["build"], course, user);
  expect(came.status === 0, `links inside: exit ${came.status}\n${came.stderr}${came.stdout}`);
}

// Commands that write, each where a link leads out. Nothing comes to lie there.
function isNotWrittenThrough(user) {
  const refused = (name, words, make, said) => {
    const { course } = fresh(user);
    const elsewhere = `${course.folder}-elsewhere`;
    mkdirSync(elsewhere);
    own(elsewhere, user);
    make(course, elsewhere);
    const came = run(words(course), course, user);
    expect(came.status === 1, `${name}: exit ${came.status}\n${came.stderr}`);
    expect(came.stderr === said, `${name}: it said\n${came.stderr}and not\n${said}`);
    expect(readdirSync(elsewhere).length === 0, `${name}: something was written elsewhere`);
  };
  const place = (what, option) =>
    `mjcourse: ${what} ${outside}, so nothing is written there\n  cure: name another place: \`${option}\`\n`;
  refused(
    "a build elsewhere",
    () => ["build"],
    (c, there) => c.link(there, "build"),
    place("build/site", "--out DIR"),
  );
  refused(
    "a site elsewhere",
    () => ["build"],
    (c, there) => c.link(there, "build/site"),
    place("build/site", "--out DIR"),
  );
  refused(
    "a named site in a folder elsewhere",
    (c) => ["build", "--out", c.path("build/mine")],
    (c, there) => c.link(there, "build"),
    place("build/mine", "--out DIR"),
  );
  refused(
    "a named site that is a link",
    (c) => ["build", "--out", c.path("mine")],
    (c, there) => c.link(there, "mine"),
    place("mine", "--out DIR"),
  );
  refused(
    "a report that is a link",
    (c) => ["check", "--report", c.path("report")],
    (c, there) => c.link(there, "report"),
    place("report", "--report DIR"),
  );
  refused(
    "a report elsewhere",
    (c) => ["check", "--report", c.path("build/report")],
    (c, there) => c.link(there, "build"),
    place("build/report", "--report DIR"),
  );
  refused(
    "a trace elsewhere",
    (c) => ["check", "--trace", c.path("trace.json")],
    (c, there) => c.link(join(there, "trace.json"), "trace.json"),
    place("trace.json", "--trace FILE"),
  );
  refused(
    "a store elsewhere",
    (c) => ["check", "--store", c.path(".cache")],
    (c, there) => c.link(there, ".cache"),
    place(".cache", "--store DIR"),
  );
  refused(
    "a new model elsewhere",
    () => ["new", "model", "arm"],
    (c, there) => c.link(there, "models"),
    `mjcourse: models/arm.xml ${outside}, so nothing was written\n` +
      "  cure: move the link away, or put a folder there\n",
  );
  // What the user named may be a link.
  const { course } = fresh(user);
  const mine = `${course.folder}-mine`;
  mkdirSync(join(mine, "site"), { recursive: true });
  symlinkSync(join(mine, "site"), join(mine, "link"));
  own(mine, user);
  const came = run(["build", "--out", join(mine, "link")], course, user);
  expect(came.status === 0, `a link that the user named: exit ${came.status}\n${came.stderr}`);
  expect(existsSync(join(mine, "site/index.html")), "a link that the user named: no site");
}

// What somebody put into the site's folder, or beside it as a killed build leaves it, is named.
function isNamed(user) {
  const { course } = fresh(user);
  course.write("build/site/.mjcourse-site", "index.html\n");
  course.write("build/site/CNAME", "example.org\n");
  course.write("build/.site.building/.mjcourse-site", "index.html\n");
  course.write("build/.site.building/page.html", "<script></script>\n");
  own(course.folder, user);
  const came = run(["build"], course, user);
  expect(
    came.stdout.includes("\nkept in the site, though no build wrote it: CNAME, page.html\nsite: "),
    `what stays in a site: it said\n${came.stderr}${came.stdout}`,
  );
}

// A program's text is not accepted into a file elsewhere.
function isNotAccepted(user) {
  const { course } = fresh(user);
  const file = `${course.folder}-file`;
  writeFileSync(file, "as it was\n");
  if (user !== undefined) lchownSync(file, user, user);
  course.lesson("```cpp file=examples/a.cpp\nint main() {}\n```");
  course.link(file, "examples/a.cpp");
  const came = run(["accept"], course, user);
  expect(came.stdout === "nothing to accept; 1 error to fix by hand\n", `accept: ${came.stdout}`);
  expect(readFileSync(file, "utf8") === "as it was\n", "accept wrote through a link");
}

// To the program that a lesson runs, its models are open; not so what a link there leads to.
function isNotOpenToPrograms(user) {
  const { course } = fresh(user);
  const models = `${course.folder}-models`;
  mkdirSync(models);
  writeFileSync(join(models, "told"), secret);
  own(models, user);
  course.link(models, "models");
  const code = [
    "#include <cstdlib>",
    "#include <fstream>",
    "#include <iostream>",
    "int main() {",
    '  std::ifstream file(std::getenv("MJCOURSE_MODELS") + std::string("/told"));',
    "  std::cout << file.rdbuf();",
    "}",
    "",
  ].join("\n");
  course.lesson("```cpp file=examples/a.cpp\n```");
  course.write("examples/a.cpp", code);
  const came = run(["check"], course, user);
  expect(came.status === 1, `a program with models elsewhere: exit ${came.status}`);
  expect(came.stderr.includes(ofFile("models", outside)), `programs: it said\n${came.stderr}`);
  expect(came.stderr.includes("the program tried to read "), `programs: it said\n${came.stderr}`);
  expect(leaks(came, course.path("build")) === "", "a program read what a link leads to");
}

function all(user) {
  for (const [name, [make, said]] of Object.entries(courses)) isRefused(name, make, said, user);
  isFollowed(user);
  isNotWrittenThrough(user);
  isNamed(user);
  isNotAccepted(user);
  isNotOpenToPrograms(user);
}

// Can somebody else run the generator? Not where the repository lies in a closed folder.
function isOpen(user) {
  return spawnSync(mjcourse, ["--version"], { uid: user, gid: user, cwd: "/" }).error === undefined;
}

home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
try {
  spawnSync("chmod", ["755", home]);
  all(undefined);
  if (process.getuid() !== 0) console.log("not as another user: we are an ordinary one");
  else if (!isOpen(ordinary)) console.log("not as an ordinary user: nobody else can read this");
  else {
    chownSync(home, ordinary, ordinary);
    all(ordinary);
  }
} finally {
  rmSync(home, { recursive: true });
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length > 0 ? 1 : 0;
