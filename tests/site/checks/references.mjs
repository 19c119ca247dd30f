// What the course explains is found from where it is spoken of, and the way back as well; a picture
// of the author's keeps its place before it has come.

const words = (text) => text.replace(/\s+/g, " ").trim();

// The links that leave the page for something that is explained: terms, MuJoCo's names, models.
function linksOf() {
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
function entriesOf() {
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
function lineLinksOf() {
  return [...document.querySelectorAll(".entry")].flatMap((entry) => {
    const name = entry.querySelector("h2").innerText.trim();
    const links = [...entry.querySelectorAll(".used-in a")].map(({ href }) => href);
    return links.filter((href) => /-L\d+$/.test(href)).map((href) => ({ name, href }));
  });
}

// The lines that links may lead to, by their ids.
function numberedLines() {
  const lines = {};
  for (const { id } of document.querySelectorAll("[id*='-L']")) {
    const number = /-L(\d+)$/.exec(id)?.[1];
    const code = document.getElementById(id).closest("code");
    if (number && code) lines[id] = code.textContent.split("\n")[number - 1];
  }
  return lines;
}

// The pictures whose place is not that of the file, as "address: why".
async function misplacedImages() {
  const wrong = [];
  for (const image of document.querySelectorAll(".image img, img.in-line")) {
    const box = image.getBoundingClientRect();
    const { loading } = image;
    if (loading !== "lazy") wrong.push(`${image.src}: is loaded at once`);
    image.loading = "eager";
    await image.decode();
    image.loading = loading;
    const after = image.getBoundingClientRect();
    const [now, file] = [after.width / after.height, image.naturalWidth / image.naturalHeight];
    if (Math.abs(now / file - 1) > 0.02) wrong.push(`${image.src}: ${now} and not ${file}`);
    if (Math.abs(after.height - box.height) > 0.5) wrong.push(`${image.src}: moves what is below`);
  }
  return wrong;
}

// Gives all of these, with addresses below the site's root.
async function light(page, { path, expect, root }) {
  for (const wrong of await page.evaluate(misplacedImages)) expect(false, wrong);
  const below = (address) => address.replace(root, "");
  const entries = path.includes("-") ? [] : await page.evaluate(entriesOf);
  const links = await page.evaluate(linksOf);
  const lineLinks = path === "api.html" ? await page.evaluate(lineLinksOf) : [];
  return {
    entries: entries.map(({ address, text, used }) => ({
      address: below(address),
      first: words(text).split(" ").slice(0, 2).join(" "),
      used: used.map(below),
    })),
    links: links.map(({ href, title, term }) => ({ href: below(href), title, term })),
    lineLinks: lineLinks.map(({ name, href }) => ({ name, href: below(href) })),
    lines: await page.evaluate(numberedLines),
  };
}

// Gives how many names have a line of a program. Without scripts their links lead to the program.
async function plain(page, { path, expect }) {
  if (path !== "api.html") return 0;
  const links = await page.locator("a[data-line]").evaluateAll((all) => all.map((a) => a.href));
  const wrong = links.filter((href) => !/#example-/.test(href));
  expect(wrong.length === 0, `without scripts, ${wrong[0]} is no program`);
  return links.length;
}

export const looks = { light, plain };

// Whether the lines that a program is said to have a name in do have it.
function followLines(found, { expect }) {
  const { lineLinks } = found.get("api.html");
  expect(lineLinks.length > 0, "api.html", "no line of a program uses MuJoCo");
  for (const { name, href } of lineLinks) {
    const [path, id] = href.split("#");
    const line = found.get(decodeURIComponent(path))?.lines[decodeURIComponent(id)];
    expect(line?.includes(name.split(".").at(-1)), path, `${name} is not at ${href}`);
  }
}

function followLinks(found, { expect }) {
  const all = [...found.values()];
  const explained = new Map(all.flatMap(({ entries }) => entries.map((e) => [e.address, e])));
  const terms = all.flatMap(({ links }) => links.filter(({ term }) => term));
  expect(terms.length > 0, "the site", "no term is used");
  for (const [path, { links }] of found) {
    for (const { href, title, term } of links) {
      const entry = explained.get(href);
      if (!expect(entry !== undefined, path, `${href} explains nothing`)) continue;
      const isLesson = path.includes("/") && !path.startsWith("models/");
      const address = path.split("/").map(encodeURIComponent).join("/");
      const back = !isLesson || entry.used.includes(address);
      expect(back, path, `there is no way back from ${href}`);
      // Formulas and values look otherwise as text; words are words.
      const titled = !term || title.startsWith(entry.first);
      expect(titled, path, `${href} is not titled ${entry.first}`);
    }
  }
}

export function conclude({ light: found, plain: withoutScripts }, site) {
  followLines(found, site);
  followLinks(found, site);
  const links = withoutScripts.get("api.html");
  const same = links === found.get("api.html").lineLinks.length;
  site.expect(same, "api.html", `has ${links} links to programs without scripts`);
}
