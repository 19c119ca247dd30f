// What the course explains is found from where it is spoken of, and the way back as well; a picture
// of the author's keeps its place before it has come.

import { pages, testSite } from "./browser.mjs";

const words = (text) => text.replace(/\s+/g, " ").trim();

// The links that leave the page for something that is explained: terms, MuJoCo's names, models.
function links() {
  return [...document.querySelectorAll("main a[href]")]
    .map((link) => ({
      href: link.href,
      title: link.title,
      term: link.classList.contains("term"),
      used: link.closest(".used-in") !== null,
    }))
    .filter(({ href, term }) => term || /\/(api|models\/[^/]*)\.html#?[^/]*$/.test(href))
    .filter(({ used }) => !used);
}

// What a page explains, by its address: the text of each entry, and where it is used.
function entries() {
  const explained = [...document.querySelectorAll("main h2[id]")].map((heading) => {
    const entry = heading.closest(".entry");
    return [`#${heading.id}`, entry];
  });
  if (document.querySelector(".model")) explained.push(["", document.querySelector(".model")]);
  return explained
    .filter(([, entry]) => entry !== null)
    .map(([id, entry]) => ({
      address: new URL(id, location.href).href,
      text: entry.querySelector(".prose")?.innerText ?? "",
      used: [...entry.querySelectorAll(".used-in a")].map((link) => link.href.split("#")[0]),
    }));
}

// Of MuJoCo's names, the lines of programs that they are said to stand in.
function lineLinks() {
  return [...document.querySelectorAll(".entry")].flatMap((entry) => {
    const name = entry.querySelector("h2").innerText.trim();
    const links = [...entry.querySelectorAll(".used-in a")].map(({ href }) => href);
    return links.filter((href) => /-L\d+$/.test(href)).map((href) => ({ name, href }));
  });
}

// Those of `links` into this page whose line does not have the name.
function misledLines(links) {
  return links.filter(({ name, href }) => {
    const [id, number] = new URL(href).hash.slice(1).split(/-L(?=\d+$)/);
    const code = document.getElementById(`${id}-L${number}`)?.closest("code");
    const line = code?.textContent.split("\n")[number - 1];
    return !line?.includes(name.split(".").at(-1));
  });
}

// The pictures whose place is not that of the file, as "address: why".
async function misplacedImages() {
  const wrong = [];
  for (const image of document.querySelectorAll(".image img, img.in-line")) {
    const box = image.getBoundingClientRect();
    if (image.loading !== "lazy") wrong.push(`${image.src}: is loaded at once`);
    image.loading = "eager";
    await image.decode();
    const after = image.getBoundingClientRect();
    const [now, file] = [after.width / after.height, image.naturalWidth / image.naturalHeight];
    if (Math.abs(now / file - 1) > 0.02) wrong.push(`${image.src}: ${now} and not ${file}`);
    if (Math.abs(after.height - box.height) > 0.5) wrong.push(`${image.src}: moves what is below`);
  }
  return wrong;
}

await testSite(async (visitor) => {
  const explained = new Map();
  const linked = [];
  let inLines = [];
  await visitor.visit("api.html", {}, async (page) => (inLines = await page.evaluate(lineLinks)));
  visitor.expect(inLines.length > 0, "api.html", "no line of a program uses MuJoCo");
  await visitor.visit("api.html", { javaScript: false }, async (page) => {
    const plain = await page.locator("a[data-line]").evaluateAll((all) => all.map((a) => a.href));
    visitor.expect(plain.length === inLines.length, "api.html", `${plain.length} without scripts`);
    visitor.expect(
      plain.every((href) => /#example-/.test(href)),
      "api.html",
      `${plain[0]}`,
    );
  });
  for (const path of pages) {
    await visitor.visit(path, {}, async (page) => {
      if (!path.includes("-")) {
        for (const entry of await page.evaluate(entries)) explained.set(entry.address, entry);
      }
      for (const link of await page.evaluate(links)) linked.push({ path, ...link });
      const here = inLines.filter(({ href }) => href.split("#")[0] === visitor.address(path));
      for (const { name, href } of await page.evaluate(misledLines, here)) {
        visitor.complain(path, `${name} is not at ${href}`);
      }
      for (const wrong of await page.evaluate(misplacedImages)) visitor.complain(path, wrong);
    });
  }
  visitor.expect(
    linked.some(({ term }) => term),
    "the site",
    "no term is used",
  );
  for (const { path, href, title, term } of linked) {
    const entry = explained.get(href);
    if (!visitor.expect(entry !== undefined, path, `${href} explains nothing`)) continue;
    const isLesson = path.includes("/") && !path.startsWith("models/");
    const back = !isLesson || entry.used.includes(visitor.address(path));
    visitor.expect(back, path, `there is no way back from ${href}`);
    // Formulas and values look otherwise as text; words are words.
    const first = words(entry.text).split(" ").slice(0, 2).join(" ");
    visitor.expect(!term || title.startsWith(first), path, `${href} is not titled ${first}`);
  }
});
