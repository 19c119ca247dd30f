// The editor of MJCF in a browser, on a page with the site's policy, in both schemes.
//
//   node --test tests/site/lab/editor.mjs

import assert from "node:assert/strict";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";

import { serve } from "../server.mjs";

const site = path.resolve(import.meta.dirname, "../../../site");
const require = createRequire(path.join(site, "package.json"));

const page = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Editor</title>
<meta http-equiv="Content-Security-Policy" content="default-src 'self'">
<link rel="icon" href="favicon.svg"><link rel="stylesheet" href="site.css">
<main><h1>Editor</h1><button>before</button><div id="host"></div><button>after</button></main>
<script type="module" src="page.js"></script></html>`;

const script = `import { openModelEditor } from "./browser/lab/editor/model-editor.ts";
import { LoadError } from "./browser/engine/errors.ts";
window.changes = [];
window.editor = openModelEditor(document.getElementById("host"), {
  text: "<mujoco>\\n  <worldbody>\\n    <geom sizze='1'/>\\n  </worldbody>\\n</mujoco>\\n",
  label: "MJCF of model.xml",
  onChange: (text) => window.changes.push(text),
  file: "model.xml",
});
window.show = (...parts) => window.editor.showError(new LoadError(...parts));
`;

let folder, server, browser;

before(async () => {
  folder = await mkdtemp(path.join(tmpdir(), "mjcourse-editor-"));
  await require("esbuild").build({
    stdin: { contents: script, resolveDir: site },
    outfile: path.join(folder, "page.js"),
    bundle: true,
    format: "esm",
  });
  const styles = ["tokens", "reset", "type"].map(
    (name) => `@import "./browser/styles/${name}.css";`,
  );
  await require("esbuild").build({
    stdin: { contents: styles.join("\n"), resolveDir: site, loader: "css" },
    outfile: path.join(folder, "site.css"),
    bundle: true,
  });
  await writeFile(path.join(folder, "index.html"), page);
  await writeFile(path.join(folder, "favicon.svg"), '<svg xmlns="http://www.w3.org/2000/svg"/>');
  server = await serve(folder);
  browser = await require("playwright-core").chromium.launch({
    executablePath: "/usr/bin/chromium-headless-shell",
    args: ["--no-sandbox", "--disable-gpu"],
  });
});

after(async () => {
  await browser?.close();
  server?.close();
  await rm(folder, { recursive: true });
});

// The page for a new reader, which must not complain.
async function visit(look, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 700, height: 600 },
    ...options,
  });
  const visited = await context.newPage();
  const complaints = [];
  visited.on("console", (message) => complaints.push(message.text()));
  visited.on("pageerror", (error) => complaints.push(error.stack));
  await visited.goto(server.root);
  await visited.waitForFunction(() => window.editor);
  await look(visited);
  await context.close();
  assert.deepEqual(complaints, []);
}

const focused = (visited) =>
  visited.evaluate(() => {
    const { activeElement } = document;
    return activeElement.shadowRoot?.activeElement?.className ?? activeElement.textContent;
  });

test("it is styled and coloured under the page's policy, in both schemes", async () => {
  for (const colorScheme of ["light", "dark"]) {
    await visit(
      async (visited) => {
        const { ground, tag, gutter, hint, styles } = await visited.evaluate(() => {
          const root = document.getElementById("host").shadowRoot;
          const style = (selector) => getComputedStyle(root.querySelector(selector));
          const name = [...root.querySelectorAll(".cm-line span")].find(
            (span) => span.textContent === "mujoco",
          );
          return {
            ground: style(".cm-editor").backgroundColor,
            tag: getComputedStyle(name).color,
            gutter: style(".cm-gutters").backgroundColor,
            hint: style("#hint").marginBlockStart,
            styles: root.querySelectorAll("style").length,
          };
        });
        const dark = colorScheme === "dark";
        assert.equal(ground, dark ? "rgb(36, 32, 27)" : "rgb(246, 241, 232)");
        assert.equal(tag, dark ? "rgb(235, 163, 196)" : "rgb(122, 44, 84)");
        assert.equal(gutter, "rgba(0, 0, 0, 0)");
        assert.equal(hint, "4px");
        assert.equal(styles, 0);
      },
      { colorScheme },
    );
  }
});

test("changes are told once the reader pauses, replaced text is not", async () => {
  await visit(async (visited) => {
    await visited.evaluate(() => window.editor.focus());
    await visited.keyboard.type("<!-- a -->", { delay: 10 });
    assert.deepEqual(await visited.evaluate(() => window.changes), []);
    await visited.waitForFunction(() => window.changes.length > 0);
    const changes = await visited.evaluate(() => window.changes);
    assert.equal(changes.length, 1);
    assert.ok(changes[0].startsWith("<!-- a --><mujoco>"));

    await visited.keyboard.type("x");
    await visited.evaluate(() => window.editor.replace("<mujoco/>"));
    await visited.waitForTimeout(500);
    assert.equal(await visited.evaluate(() => window.changes.length), 1);
    assert.equal(await visited.evaluate(() => window.editor.text), "<mujoco/>");
    await visited.keyboard.press("Control+z");
    await visited.waitForFunction(() => window.changes.length === 2);
    assert.match(await visited.evaluate(() => window.editor.text), /worldbody/);
  });
});

test("an error is marked where it is", async () => {
  await visit(async (visited) => {
    const marked = () =>
      visited.evaluate(() => {
        const root = document.getElementById("host").shadowRoot;
        return [...root.querySelectorAll(".cm-lintRange-error")].map((mark) => mark.textContent);
      });
    const show = (...parts) => visited.evaluate((given) => window.show(...given), parts);
    await show("unrecognized attribute", "model.xml", 3, 11, "did you mean `size`?");
    assert.deepEqual(await marked(), ["sizze"]);
    await visited.keyboard.press("Tab");
    await visited.keyboard.press("Tab");
    await visited.keyboard.press("F8");
    const tooltip = visited.locator(".cm-tooltip-lint, .cm-diagnostic").first();
    await tooltip.waitFor();
    assert.match(await tooltip.textContent(), /unrecognized attribute \(did you mean `size`\?\)/);
    await show("unrecognized attribute", "model.xml", 3, 0, "");
    assert.equal((await marked()).join(""), "<geom sizze='1'/>");
    await show("far away", "model.xml", 99, 3, "");
    await show("elsewhere", "other.xml", 3, 0, "");
    assert.equal((await marked()).join(""), "<mujoco>");
    await visited.evaluate(() => window.editor.showError(undefined));
    assert.deepEqual(await marked(), []);
  });
});

test("the keyboard comes in and gets out", async () => {
  await visit(async (visited) => {
    const press = async (...keys) => {
      for (const key of keys) await visited.keyboard.press(key);
    };
    await press("Tab");
    assert.equal(await focused(visited), "before");
    await press("Tab");
    assert.match(await focused(visited), /cm-content/);
    await press("Tab");
    assert.match(await focused(visited), /cm-content/);
    assert.match(await visited.evaluate(() => window.editor.text), /^ {2}<mujoco>/);
    await press("Escape");
    await visited.waitForTimeout(2500);
    await press("Tab");
    assert.equal(await focused(visited), "after");
    await press("Shift+Tab");
    assert.match(await focused(visited), /cm-content/);
    await press("Tab");
    assert.match(await focused(visited), /cm-content/);
    // the search panel too
    await press("Control+f");
    await visited.keyboard.type("geom");
    await press("Enter", "Escape");
    assert.match(await focused(visited), /cm-content/);
    await press("Escape", "Tab");
    assert.equal(await focused(visited), "after");
  });
});

test("it has a name and a description, and no accessibility problem", async () => {
  await visit(async (visited) => {
    const field = visited.getByRole("textbox", { name: "MJCF of model.xml" });
    assert.equal(await field.count(), 1);
    await visited.evaluate(() => window.editor.replace("<geom size='1'/>\n".repeat(200)));
    await visited.evaluate(() => window.show("wrong", "model.xml", 3, 0, ""));
    await visited.evaluate(await readFile(require.resolve("axe-core"), "utf8"));
    const { violations } = await visited.evaluate(() => window.axe.run());
    assert.deepEqual(
      violations.map(({ id, nodes }) => [id, ...nodes.map(({ html }) => html)]),
      [],
    );
  });
});

test("on a phone it fits", async () => {
  await visit(
    async (visited) => {
      const overflow = await visited.evaluate(
        () => document.documentElement.scrollWidth - window.innerWidth,
      );
      assert.equal(overflow, 0);
    },
    { viewport: { width: 320, height: 600 }, hasTouch: true },
  );
});
