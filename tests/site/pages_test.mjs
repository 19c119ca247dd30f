// Which pages tests/site/pages.mjs opens again, of a site of two pages: those of which something is not as
// it was when they were good, be it in a file that they load, and those that were not good.
//
//   node --test tests/site/pages_test.mjs

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";

const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(home, { recursive: true }));
const write = (name, text) => writeFileSync(join(home, name), text);

// What the check says last, its complaints, and the exit code.
function look(check = "layout") {
  const words = [join(import.meta.dirname, "pages.mjs"), home, check];
  const env = { ...process.env, XDG_CACHE_HOME: join(home, "cache") };
  const { stdout, stderr, status } = spawnSync(process.execPath, words, { env, encoding: "utf8" });
  return [stdout.trim(), stderr.trim(), status];
}
const good = (anew) => [`layout: 4 looks, ${anew} done anew, 0 problems`, "", 0];

const page = (style, text) => `<!doctype html><html lang="en"><title>A page</title>
<link rel="icon" href="data:,"><link rel="stylesheet" href="${style}">
<main class="figure"><picture><img src="dot.svg" alt="A dot"></picture>${text}</main></html>`;

test("what was good is looked at again once something of it changes", () => {
  write("dot.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>');
  write("one.css", "");
  write("two.css", "");
  write("index.html", page("one.css", "one"));
  write("two.html", page("two.css", "two"));
  assert.deepEqual(look(), good(4));
  assert.deepEqual(look(), good(0));

  write("two.css", "main { width: 2000px; }");
  for (const time of ["first", "second"]) {
    const [last, complaints, status] = look();
    assert.equal(last, "layout: 4 looks, 2 done anew, 10 problems", time);
    assert.match(complaints, /^layout: two.html \(light\): at 1000 px this is too wide: <main/);
    assert.equal(status, 1);
  }

  write("two.css", "");
  assert.deepEqual(look(), good(0));
  write("index.html", page("one.css", "another"));
  assert.deepEqual(look(), good(2));
});

test("a file that is missing is a problem, and its page good once it is there", () => {
  write("two.html", page("three.css", "two"));
  const [last, complaints] = look();
  assert.equal(last, "layout: 4 looks, 2 done anew, 0 problems");
  assert.match(complaints, /^browser: \(light\) two.html: 404 for http:.*three.css/);
  write("three.css", "");
  assert.deepEqual(look(), good(2));
});

test("a name that no check has is an error", () => {
  const [, complaints, status] = look("layuot");
  assert.match(complaints, /there is no check layuot, but markup, /);
  assert.equal(status, 1);
});
