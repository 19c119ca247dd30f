// A site that is published: what its pages tell of themselves is so, former addresses lead on, also
// to a heading and without scripts, and dates are written as the reader writes them.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { folder, movedPages, pages, testSite } from "./browser.mjs";

const root = "https://example.org/learn/course/";
const swing = "1-basics/1.1-a-swing.html";
const renamed = "1-basics/1.2-new-name.html";

function head() {
  const metas = [...document.head.querySelectorAll("meta[property], meta[name]")];
  const said = metas.map((meta) => [meta.getAttribute("property") ?? meta.name, meta.content]);
  const facts = document.head.querySelector('script[type="application/ld+json"]');
  return { ...Object.fromEntries(said), facts: facts && JSON.parse(facts.text) };
}

// A PNG has its size behind its first 16 bytes.
function sizeOf(file) {
  const bytes = readFileSync(file);
  return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)].map(String);
}

async function sharing(visitor) {
  for (const path of pages) {
    await visitor.visit(path, {}, async (page) => {
      const said = await page.evaluate(head);
      const title = await page.title();
      visitor.expect(title.startsWith(said["og:title"]), path, `og:title is ${said["og:title"]}`);
      visitor.expect(said["og:description"] === said.description, path, "og:description differs");
      visitor.expect(said["og:site_name"] === "A course & its place", path, said["og:site_name"]);
      const lesson = path.startsWith("1-");
      visitor.expect(said["og:type"] === (lesson ? "article" : "website"), path, said["og:type"]);
      const type = lesson ? "LearningResource" : path === "index.html" ? "Course" : undefined;
      visitor.expect(said.facts?.["@type"] === type, path, `facts of a ${said.facts?.["@type"]}`);
      visitor.expect(!said.facts || said.facts.url === said["og:url"], path, "facts of elsewhere");
    });
  }
  for (const path of [swing, "index.html"]) {
    await visitor.visit(path, {}, async (page) => {
      const said = await page.evaluate(head);
      const image = String(said["og:image"]);
      if (!visitor.expect(image.startsWith(root), path, `og:image is ${image}`)) return;
      const size = sizeOf(join(folder, image.slice(root.length)));
      const told = [said["og:image:width"], said["og:image:height"]];
      visitor.expect(`${size}` === `${told}`, path, `og:image is ${size}, and not ${told}`);
      visitor.expect(said["og:image:alt"].includes("The swing"), path, said["og:image:alt"]);
      visitor.expect(said["twitter:card"] === "summary_large_image", path, said["twitter:card"]);
    });
  }
}

async function redirects(visitor) {
  const expected = ["0-before/1.2-older-name.html", "1-basics/1.7-old-name.html"];
  visitor.expect(`${movedPages}` === `${expected}`, "the site", `moved pages: ${movedPages}`);
  // What the page left behind was loading is broken off.
  const before = (page) => page.removeAllListeners("requestfailed");
  for (const path of expected) {
    for (const [javaScript, hash] of [
      [true, "#what-was-linked-to"],
      [true, ""],
      [false, ""],
    ]) {
      await visitor.visit(path + hash, { javaScript, before }, async (page) => {
        const target = visitor.address(renamed) + hash;
        const led = await page.waitForURL(target).then(
          () => true,
          () => false,
        );
        visitor.expect(led, path + hash, `leads to ${page.url()}, scripts: ${javaScript}`);
      });
    }
  }
}

async function history(visitor) {
  const date = (page) => page.locator(".history time").innerText();
  const zone = { timezoneId: "America/Los_Angeles" };
  for (const [options, words] of [
    [{ locale: "en-US", ...zone }, "April 5, 2026"],
    [{ locale: "de-DE", ...zone }, "5. April 2026"],
    [{ javaScript: false }, "5 April 2026"],
  ]) {
    await visitor.visit(renamed, options, async (page) => {
      const shown = await date(page);
      visitor.expect(shown === words, renamed, `${shown}, and not ${words}`);
      const edit = page.locator(".history a");
      const href = await edit.getAttribute("href");
      const file = "content/1-basics/1.2-new-name.md";
      visitor.expect(href === `https://git.example/me/course/edit/main/${file}`, renamed, href);
      const { height } = await edit.boundingBox();
      visitor.expect(height >= 24, renamed, `a link ${height} px high`);
    });
  }
}

await testSite(async (visitor) => {
  await sharing(visitor);
  await redirects(visitor);
  await history(visitor);
});
