// A course has its own look: what it says in theme/ stands in the place of what it is given, page by
// page, and what stands for nothing there is said at its line.
//
//   node --test tests/system/themed.mjs     the generator is named by the environment: MJCOURSE

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { after, test } from "node:test";

import { launch } from "../site/chromium.mjs";
import { serve } from "../site/server.mjs";

const mjcourse = resolve(process.env.MJCOURSE ?? "build/release/generator/mjcourse");
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(folder, { recursive: true }));

function run(...words) {
  const { status, stdout, stderr } = spawnSync(mjcourse, words, { cwd: folder, encoding: "utf8" });
  return { status, stdout, stderr };
}
const build = () => run("build", "--course", "course", "--out", "site");

function write(path, text) {
  mkdirSync(dirname(join(folder, "course/theme", path)), { recursive: true });
  writeFileSync(join(folder, "course/theme", path), text);
}

test("a theme changes a template, a partial and a token", async (context) => {
  assert.equal(run("init", "course").status, 0);
  write("style.css", ":root {\n  --accent: rgb(1 120 30);\n}\n");
  write(
    "templates/card.hbs",
    '<li class="mine"><a href="{{href}}">{{> stamp}}</a> {{title}}</li>\n',
  );
  write("templates/stamp.hbs", 'No. <b class="number">{{number}}</b>\n');
  const { status, stderr } = build();
  assert.equal(stderr, "");
  assert.equal(status, 0);

  const { root, close } = await serve(join(folder, "site"));
  const browser = await launch();
  context.after(() => Promise.all([browser.close(), close()]));
  const page = await browser.newPage();
  await page.goto(root);
  assert.equal(await page.locator("li.mine").innerText(), "No. 1.1 A pendulum");
  const accent = () => getComputedStyle(document.querySelector("main .number")).color;
  assert.equal(await page.evaluate(accent), "rgb(1, 120, 30)");
  await page.goto(root + "1-first-steps/1.1-a-pendulum.html");
  assert.equal(await page.evaluate(accent), "rgb(1, 120, 30)");
});

test("what stands for nothing is an error", () => {
  write("templates/lession.hbs", "x");
  write("templates/notes.txt", "x");
  write("logo.svg", "x");
  write("styles/a.css", "x");
  write("templates/parts/a.hbs", "x");
  // What editors leave is nothing of the theme's.
  write("style.css~", "x");
  write(".style.css.swp", "x");
  write("templates/card.hbs~", "{{> lession}}");
  write("templates/.card.hbs.swp", "x");
  const { status, stderr } = run("check", "--course", "course");
  assert.equal(status, 1);
  assert.equal(
    stderr,
    `theme/logo.svg: error: a theme has no such file [E-theme-file]
  cure: its styles are \`style.css\`, its templates \`templates/NAME.hbs\`

theme/styles: error: a theme has no such folder [E-theme-file]
  cure: its styles are \`style.css\`, its templates \`templates/NAME.hbs\`

theme/templates/lession.hbs: error: no template has this name, and none includes it [E-theme-file]
  cure: did you mean \`lesson\`?

theme/templates/notes.txt: error: a template is a file \`NAME.hbs\` [E-theme-file]
  cure: name it so, or remove it

theme/templates/parts: error: a template is a file \`NAME.hbs\`, not a folder [E-theme-file]
  cure: put what is in it into \`theme/templates/\` itself

`,
  );
  const stray = ["templates/lession.hbs", "templates/notes.txt", "logo.svg", "styles"];
  for (const name of [...stray, "templates/parts"]) {
    rmSync(join(folder, "course/theme", name), { recursive: true });
  }
});

test("a template that loses its text, or has it twice, is an error", () => {
  for (const name of ["page", "lesson", "printed-lesson"]) {
    for (const text of ["x", "{{{body}}}{{{body}}}"]) {
      write(`templates/${name}.hbs`, text);
      const { status, stderr } = build();
      const wanted = `theme/templates/${name}.hbs: error: \`{{{body}}}\` must stand here, and once [E-template]`;
      assert.equal(stderr, `${wanted}\n\n`);
      assert.equal(status, 1);
    }
    rmSync(join(folder, `course/theme/templates/${name}.hbs`));
  }
});

test("a mistake in a template is shown at its line, and the old site stays", () => {
  write("templates/stamp.hbs", "<b>\n{{nummer}}</b>\n");
  const { status, stderr } = build();
  assert.equal(status, 1);
  assert.equal(
    stderr,
    `theme/templates/stamp.hbs:2:1: error: "nummer" is not in the data [E-template]
  2 | {{nummer}}</b>
    | ^~~~~~~~~~~~~~

`,
  );
  assert.match(readFileSync(join(folder, "site/index.html"), "utf8"), /No\. <b/);
});

test("templates that take much are an error, and not the generator's end", () => {
  write("templates/stamp.hbs", "{{number}}".repeat(25000));
  const { status, stderr } = build();
  assert.equal(
    stderr,
    `theme/templates/card.hbs: error: takes more than 512 MiB of memory [E-template]
  cure: look for a loop in a loop, and for a template of many parts

`,
  );
  assert.equal(status, 1);
});
