// Of courses whose links, pipes and names lead out of them (linked-courses.mjs), nothing of what they
// lead to is read, shown or written, and each ends soon with a message. As we are, and where we are
// root, as an ordinary user as well.
//
//   node tests/system/links.mjs MJCOURSE

import { spawnSync } from "node:child_process";
import {
  chownSync,
  existsSync,
  lchownSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  renameSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { join, resolve } from "node:path";

import { courses, coursesOfLevels, ofFile, outside, secret } from "./linked-courses.mjs";
import { differences, everythingIn, fresh, home, own, preview, run } from "./linked-runs.mjs";

const mjcourse = resolve(process.argv[2]);
const ordinary = 54321; // a user who has nothing
const passwd = readFileSync("/etc/passwd", "utf8").split("\n")[0];

const failures = [];
const expect = (good, what) => good || failures.push(what);

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

// A level's folder that is not one plain name places no page anywhere: not over what the course's
// links lead to, nor beside the site.
async function placesNoPage(folder, make, said, user) {
  const { course } = fresh(user);
  make(course);
  const elsewhere = `${course.folder}-elsewhere`;
  mkdirSync(join(elsewhere, "out"), { recursive: true });
  const victim = join(elsewhere, "victim");
  writeFileSync(victim, "as it was\n");
  for (const page of ["build/1.1-one.html", "build/1.1-one", "1.1-one.html"]) {
    course.link(victim, page);
  }
  symlinkSync(victim, join(elsewhere, "out/1.1-one.html"));
  own(elsewhere, user);
  const before = everythingIn(course.folder, elsewhere);
  const who = `the level ${folder}${user === undefined ? "" : ", as an ordinary user"}`;
  const expectAsItWas = (command, stderr) => {
    expect(
      stderr.replace("1 error\n", "").trim() === said.trim(),
      `${who}, ${command}: it said\n${stderr}and not\n${said}`,
    );
    const written = differences(before, everythingIn(course.folder, elsewhere));
    expect(written.length === 0, `${who}, ${command}: it wrote ${written.slice(0, 9).join(", ")}`);
  };
  for (const words of [["build"], ["build", "--out", join(elsewhere, "out/site")], ["accept"]]) {
    const came = run(words, course, user);
    expect(came.status === 1, `${who}, ${words[0]}: exit ${came.status}\n${came.stdout}`);
    expectAsItWas(words.join(" "), came.stderr);
  }
  const came = await preview(
    course,
    ["/1.1-one.html", "/../1.1-one.html", "/%2e%2e/1.1-one.html"],
    user,
  );
  expectAsItWas("preview", came.stderr);
  expect(came.statuses.join() === "404,404,404", `${who}, preview: its pages are ${came.statuses}`);
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
    const whole = typeof said === "string" ? said : said(course);
    expect(came.status === 1, `${name}: exit ${came.status}\n${came.stderr}`);
    expect(came.stderr === whole, `${name}: it said\n${came.stderr}and not\n${whole}`);
    expect(readdirSync(elsewhere).length === 0, `${name}: something was written elsewhere`);
  };
  const place = (what, option) =>
    `mjcourse: ${what} is a link, so nothing is written there\n  cure: name another place: \`${option}\`\n`;
  refused(
    "a build elsewhere",
    () => ["build"],
    (c, there) => c.link(there, "build"),
    place("build", "--out DIR"),
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
    place("build", "--out DIR"),
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
    place("build", "--report DIR"),
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
  // What it leads to would be replaced as a whole: the course, or its lessons.
  const listed = ".mjcourse-site\ncontent/course.yaml\ncontent/1-basics/1.1-one.md\n";
  refused(
    "a site that is the course",
    () => ["build"],
    (c) => {
      c.write(".mjcourse-site", listed);
      c.link("..", "build/site");
    },
    place("build/site", "--out DIR"),
  );
  refused(
    "a site among the lessons",
    () => ["build"],
    (c) => c.link("content", "build"),
    place("build", "--out DIR"),
  );
  refused(
    "a trace that is a lesson",
    (c) => ["check", "--trace", c.path("trace.json")],
    (c) => c.link("content/1-basics/1.1-one.md", "trace.json"),
    place("trace.json", "--trace FILE"),
  );
  refused(
    "a site behind a link of the user's, and one of the course's",
    (c) => ["build", "--out", `${c.folder}-mine/build/site`],
    (c, there) => {
      c.link(there, "build");
      symlinkSync(c.folder, `${c.folder}-mine`);
    },
    place("build", "--out DIR"),
  );
  refused(
    "an exercise that is a link",
    (c) => ["try", "1.1", "--out", c.path("mine")],
    (c, there) => c.link(there, "mine"),
    place("mine", "--out DIR"),
  );
  refused(
    "a new model elsewhere",
    () => ["new", "model", "arm"],
    (c, there) => c.link(there, "models"),
    `mjcourse: models/arm.xml ${outside}, so nothing was written\n` +
      "  cure: move the link away, or put a folder there\n",
  );
  // Beside a course that is a folder of a repository, a link is a stranger's too.
  const above = (course) => join(course.folder, "..");
  const inRepository = (course, there, link) => {
    const repository = `${course.folder}-repository`;
    mkdirSync(join(repository, ".git"), { recursive: true });
    rmSync(course.path(".git"), { recursive: true });
    renameSync(course.folder, join(repository, "course"));
    symlinkSync(there, join(repository, link));
    course.folder = join(repository, "course");
    own(repository, user);
  };
  for (const [name, words, option, link] of [
    ["a site", ["build", "--out"], "--out DIR", "site"],
    ["a report", ["check", "--report"], "--report DIR", "report"],
    ["a trace", ["check", "--trace"], "--trace FILE", "trace.json"],
    ["a store", ["check", "--store"], "--store DIR", "store"],
    ["an exercise", ["try", "1.1", "--out"], "--out DIR", "mine"],
  ]) {
    const said = (c) => place(join(above(c), link), option);
    refused(
      `${name} beside the course`,
      (c) => [...words, join(above(c), link)],
      (c, there) => inRepository(c, there, link),
      said,
    );
    refused(
      `${name} in a folder beside the course`,
      (c) => [...words, join(above(c), link, "deep/er")],
      (c, there) => inRepository(c, there, link),
      said,
    );
  }
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

// A picture is accepted into its own file alone: not over another of the course's.
function isNotDrawnOver(user) {
  const { course } = fresh(user);
  const lab = '{"title": "L", "model": "ball", "alt": "A ball.", "pin": "q"}';
  course.lesson(`\`\`\`lab simlab\n${lab}\n\`\`\``);
  course.write("models/ball.xml", '<mujoco><worldbody><geom size="1"/></worldbody></mujoco>');
  course.write("notes.txt", "as it was\n");
  const picture = "content/1-basics/pictures/1.1-q.png";
  course.link("../../../notes.txt", picture);
  const came = run(["accept"], course, user);
  const column = lab.indexOf('q"}') + 1;
  const said =
    `content/1-basics/1.1-one.md:6:${column}: error: ${picture} is a link [E-file-refused]\n` +
    `  6 | ${lab}\n    | ${" ".repeat(column - 1)}^\n  cure: put the picture itself there\n`;
  expect(came.stderr.trim() === said.trim(), `a picture: it said\n${came.stderr}and not\n${said}`);
  expect(readFileSync(course.path("notes.txt"), "utf8") === "as it was\n", "it drew over a link");
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

// The folder of a course is never the site, nor is one that it lies in, though each has the list of
// one.
function isNotReplaced(user) {
  const { course } = fresh(user);
  const list = ".mjcourse-site\ncontent/course.yaml\n";
  course.write(".mjcourse-site", list);
  const above = `${course.folder}-above`;
  mkdirSync(join(above, "course"), { recursive: true });
  renameSync(course.folder, join(above, "course"));
  symlinkSync(join(above, "course"), course.folder);
  writeFileSync(join(above, ".mjcourse-site"), list);
  own(above, user);
  const before = everythingIn(above);
  for (const out of [
    course.folder,
    join(course.folder, "content/.."),
    join(above, "course"),
    above,
  ]) {
    const came = run(["build", "--out", out], course, user);
    expect(came.status === 2, `a site that holds the course: exit ${came.status}`);
    expect(
      came.stderr ===
        `mjcourse: the course lies in ${out}, which would be replaced\n` +
          "  cure: name another place: `--out DIR`\n",
      `a site that holds the course: it said\n${came.stderr}`,
    );
    expect(differences(before, everythingIn(above)).length === 0, "the course was replaced");
  }
}

async function all(user) {
  for (const [name, [make, said]] of Object.entries(courses)) isRefused(name, make, said, user);
  for (const [folder, make, said] of coursesOfLevels) await placesNoPage(folder, make, said, user);
  isNotReplaced(user);
  isFollowed(user);
  isNotWrittenThrough(user);
  isNamed(user);
  isNotAccepted(user);
  isNotDrawnOver(user);
  isNotOpenToPrograms(user);
}

// Can somebody else run the generator? Not where the repository lies in a closed folder.
function isOpen(user) {
  return spawnSync(mjcourse, ["--version"], { uid: user, gid: user, cwd: "/" }).error === undefined;
}

try {
  spawnSync("chmod", ["755", home]);
  await all(undefined);
  if (process.getuid() !== 0) console.log("not as another user: we are an ordinary one");
  else if (!isOpen(ordinary)) console.log("not as an ordinary user: nobody else can read this");
  else {
    chownSync(home, ordinary, ordinary);
    await all(ordinary);
  }
} finally {
  rmSync(home, { recursive: true });
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length > 0 ? 1 : 0;
