// A course that is published from a git repository: its dates are git's, the same in every time zone
// and in every clone, and none is said that git does not know. The site that other tests look at is
// built here, since a copy of ours has no history of its own.
//
//   node tests/site/published.mjs MJCOURSE COURSE SITE

import { spawnSync } from "node:child_process";
import { appendFileSync, cpSync, existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [mjcourse, course, site] = process.argv.slice(2);
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const repository = join(home, "repository");
const problems = [];

function expect(good, what) {
  if (!good) problems.push(what);
}

function run(program, words, env = {}) {
  const ran = spawnSync(program, words, { env: { ...process.env, ...env }, encoding: "utf8" });
  if (ran.status !== 0) throw new Error(`${program} ${words.join(" ")}\n${ran.stderr}`);
  return ran.stdout;
}

function git(words, when = "") {
  const who = { GIT_AUTHOR_NAME: "A", GIT_AUTHOR_EMAIL: "a@example.org" };
  const committer = { GIT_COMMITTER_NAME: "A", GIT_COMMITTER_EMAIL: "a@example.org" };
  const dates = { GIT_AUTHOR_DATE: when, GIT_COMMITTER_DATE: when };
  const own = { GIT_CONFIG_GLOBAL: "/dev/null", GIT_CONFIG_SYSTEM: "/dev/null" };
  run("git", words, { ...who, ...committer, ...dates, ...own });
}

function build(from, to, env = {}, more = []) {
  const words = ["build", "--course", from, "--out", to, "--store", join(home, "store"), ...more];
  return run(mjcourse, words, env);
}

const page = (built, path) => readFileSync(join(built, path), "utf8");
const dateOf = (built, path) => page(built, path).match(/<time datetime="([^"]*)">([^<]*)</)?.[0];

try {
  cpSync(course, repository, { recursive: true });
  git(["init", "--quiet", repository]);
  git(["-C", repository, "add", "--all"]);
  git(["-C", repository, "commit", "--quiet", "--message=begin"], "2026-03-03T23:30:00-0500");
  const renamed = join(repository, "content/1-basics/1.2-new-name.md");
  appendFileSync(renamed, "\nAnd more.\n");
  git(
    ["-C", repository, "commit", "--quiet", "--all", "--message=more"],
    "2026-04-05T01:00:00+0900",
  );

  build(repository, site, { TZ: "Asia/Kathmandu" });
  const swing = dateOf(site, "1-basics/1.1-a-swing.html");
  expect(swing === '<time datetime="2026-03-03">3 March 2026<', `the swing's date is ${swing}`);
  const name = dateOf(site, "1-basics/1.2-new-name.html");
  expect(name === '<time datetime="2026-04-05">5 April 2026<', `the new name's date is ${name}`);

  const clone = join(home, "clone");
  git(["clone", "--quiet", repository, clone]);
  build(clone, join(home, "cloned"), { TZ: "America/Los_Angeles", LC_ALL: "C" });
  const compared = spawnSync("diff", ["-rq", site, join(home, "cloned")], { encoding: "utf8" });
  expect(compared.status === 0, `a clone gives another site\n${compared.stdout}`);

  // What git cannot know: that of a shallow clone, and that of a change which is in no commit.
  const shallow = join(home, "shallow");
  git(["clone", "--quiet", "--depth=1", `file://${repository}`, shallow]);
  const said = build(shallow, join(home, "guessed"));
  const note = "note: no page says when it was last changed: this is a shallow clone, ";
  expect(said.split(note).length === 2, `of a shallow clone is said: ${said}`);
  expect(!page(join(home, "guessed"), "sitemap.xml").includes("lastmod"), "a shallow date");
  expect(!dateOf(join(home, "guessed"), "1-basics/1.2-new-name.html"), "a shallow clone's date");
  expect(!existsSync(join(home, "guessed", "feed.xml")), "a feed of a shallow clone");

  appendFileSync(join(clone, "content/1-basics/1.1-a-swing.md"), "\nNot committed.\n");
  const elsewhere = ["--base-url", "http://localhost:8000"];
  build(clone, join(home, "edited"), {}, elsewhere);
  expect(!dateOf(join(home, "edited"), "1-basics/1.1-a-swing.html"), "a date of what is edited");
  expect(dateOf(join(home, "edited"), "1-basics/1.2-new-name.html") === name, "no date beside it");
  const feed = page(join(home, "edited"), "feed.xml");
  expect(feed.split("<entry>").length === 3, `not two entries: ${feed}`);
  expect(feed.includes("<id>http://localhost:8000/</id>"), "--base-url has no effect");
  expect(!feed.includes("example.org"), "course.yaml's address, whatever --base-url says");
} catch (error) {
  problems.push(error.message);
} finally {
  rmSync(home, { recursive: true });
}
for (const problem of problems) console.error(problem);
console.log(`${problems.length} problems`);
process.exitCode = problems.length > 0 ? 1 : 0;
