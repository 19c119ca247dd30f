// What comes out of the printer: each lesson, and the whole course as one document. The pages have
// numbers and, behind the first, the running head; nothing of the interface is on them; what was
// asked is answered behind all text; each picture and plot is drawn, and each line of code is whole;
// no heading is the last line of a page.
//
//   node tests/site/print.mjs SITE

import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { folder, pages, testSite } from "./browser.mjs";

const work = mkdtempSync(join(tmpdir(), "mjcourse-print-"));
const whole = "print.html";

// The lessons of the site, as their pages name them.
const lessons = pages.flatMap((path) => {
  const html = readFileSync(join(folder, path), "utf8");
  const name = html.match(/<article class="lesson" data-name="(\S+) ([^"]*)">/);
  return name === null ? [] : [{ path, number: name[1], title: decoded(name[2]) }];
});

const run = (program, ...options) =>
  execFileSync(program, options, { maxBuffer: 1 << 28, encoding: "latin1" });
// Of a page's text as a PDF has it, and of the page's own: letters and digits alone, since what is
// between them depends on where lines end.
const letters = (text) => text.normalize("NFKC").replace(/[^\p{L}\p{N}]/gu, "");

// What the page has to show. Works in the page, once it is set for paper.
function contentsOf() {
  // The longest text between two formulas, which are not in a PDF as they are in the page.
  const textOf = (element) => {
    const copy = element.cloneNode(true);
    for (const formula of copy.querySelectorAll(".katex")) formula.replaceWith("\0");
    const runs = copy.textContent.split("\0").map((run) => run.trim());
    return runs.reduce((longest, run) => (run.length > longest.length ? run : longest));
  };
  const shown = (selector) =>
    [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility());
  const lines = shown("main pre")
    .flatMap((pre) => pre.textContent.split("\n"))
    .filter((line) => line.trim() !== "");
  return {
    headings: shown("main :is(h1, h2, h3, h4, h5)").map(textOf),
    answers: shown(".answers .right strong, .answers .explain").map(textOf),
    lastText: shown(".prose > p:not(.answers *, .entry *)")
      .map(textOf)
      .findLast((text) => text.length > 40),
    lines,
    pictures: shown("main img").filter((img) => !img.currentSrc.endsWith(".svg")).length,
    plots: shown("main .plot svg").length,
    running: document.documentElement.dataset.title,
  };
}

// The PDF of the page at `path`, page by page: its text, its lines with their tops, its pixels.
async function printed(page, path, format) {
  const file = join(work, "page.pdf");
  await page.pdf({ path: file, format, printBackground: true });
  const boxes = Buffer.from(run("pdftotext", "-bbox-layout", file, "-"), "latin1").toString();
  return { file, pages: boxes.split("<page ").slice(1).map(readPage) };
}

function decoded(text) {
  const meant = { lt: "<", gt: ">", quot: '"', apos: "'", amp: "&", "#x27": "'" };
  return text.replace(/&([^;]+);/g, (reference, name) => meant[name] ?? reference);
}

function readPage(xml) {
  const height = Number(xml.match(/height="([\d.]+)"/)[1]);
  const lines = xml
    .split("<line ")
    .slice(1)
    .map((line) => {
      const [, left, top, right, bottom] = line
        .match(/xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" yMax="([-\d.]+)"/)
        .map(Number);
      const words = [...line.matchAll(/<word [^>]*>(.*?)<\/word>/g)].map(([, word]) =>
        decoded(word),
      );
      return { left, top, right, bottom, text: words.join(" ") };
    });
  const margin = 60; // points; heads and numbers stand in there
  const inMargin = ({ top, bottom }) => bottom < margin || top > height - margin;
  // A table's columns come one after the other.
  const body = lines
    .filter((line) => !inMargin(line))
    .sort((one, other) => one.top - other.top || one.left - other.left);
  return {
    height,
    width: Number(xml.match(/width="([\d.]+)"/)[1]),
    body,
    margins: lines.filter(inMargin),
  };
}

const interfaceWords = [
  "Skip to the text",
  "Show the answer",
  "Download",
  "Copy",
  "Search",
  "On this page",
  "Edit this page",
  "more lines",
  "The numbers",
  "Play",
  "Check",
];

function checkPages(expect, pages, { headings, running }) {
  const known = new Set(headings.map(letters));
  pages.forEach(({ body, margins, width }, i) => {
    const where = `page ${i + 1}`;
    const said = margins.map(({ text }) => text).join(" ");
    expect(said.includes(`${i + 1} / ${pages.length}`), `${where} has no number: ${said}`);
    if (i > 0) expect(said.length > 20, `${where} has no running head: ${said}`);
    if (body.length === 0) return void expect(false, `${where} is empty`);
    const last = body.at(-1);
    const lists = body[0].text === "Contents";
    const isHeading = !lists && body.length > 1 && known.has(letters(last.text));
    expect(!isHeading, `${where} ends with the heading "${last.text}"`);
    const out = body.filter(({ left, right }) => left < 40 || right > width - 40);
    expect(out.length === 0, `${where}: "${out[0]?.text}" runs off the text's width`);
    for (const { text } of body) {
      expect(!interfaceWords.includes(text), `${where} shows "${text}" of the interface`);
    }
  });
  expect(running.length > 0, "the page has no title to run along");
}

// The share of each page's pixels that are neither white nor a grey: what pictures and plots are of.
function colours(file) {
  const raw = execFileSync("pdftoppm", ["-r", "20", file], { maxBuffer: 1 << 30 });
  const shares = [];
  for (let at = 0; at < raw.length;) {
    const head = raw
      .subarray(at, at + 40)
      .toString("latin1")
      .match(/^P6\s(\d+)\s(\d+)\s255\s/);
    const size = Number(head[1]) * Number(head[2]) * 3;
    at += head[0].length;
    let coloured = 0;
    for (let i = at; i < at + size; i += 3) {
      const [r, g, b] = [raw[i], raw[i + 1], raw[i + 2]];
      if (Math.max(r, g, b) - Math.min(r, g, b) > 40) ++coloured;
    }
    shares.push((3 * coloured) / size);
    at += size;
  }
  return shares;
}

// Each picture, but for those made of lines, is in the document, and where pictures and plots are, pixels
// have colours.
function checkDrawn(expect, file, shown) {
  const listed = run("pdfimages", "-list", file).match(/^ *\d+ +\d+ image /gm) ?? [];
  const drawn = `${listed.length} pictures are drawn, of ${shown.pictures}`;
  expect(shown.pictures > 0 && listed.length >= shown.pictures, drawn);
  const coloured = colours(file).filter((share) => share > 0.005).length;
  const onePage = 4; // has room for
  const least = Math.ceil((shown.pictures + shown.plots) / onePage);
  expect(coloured >= least, `${coloured} pages have colours, and not ${least}`);
}

function checkText(expect, pages, { lines, answers, lastText }) {
  const text = letters(pages.flatMap(({ body }) => body.map(({ text }) => text)).join(" "));
  const lost = lines.filter((line) => !text.includes(letters(line)));
  expect(lost.length === 0, `${lost.length} lines of code are cut, like: ${lost[0]}`);
  const end = text.indexOf(letters(lastText ?? ""));
  expect(end >= 0, `the text's end is not there: ${lastText}`);
  const behind = text.slice(end);
  for (const answer of answers) {
    // Its last words: pieces of a tall formula may stand between the lines before.
    expect(
      behind.includes(letters(answer).slice(-24)),
      `the text's end has no answer behind it: ${answer}`,
    );
  }
}

async function look(visitor, path, format) {
  const before = async (page) => {
    page.setDefaultTimeout(120_000); // the course is a long page
    await page.emulateMedia({ media: "print" });
  };
  await visitor.visit(path, { scheme: "dark", before }, async (page) => {
    const expect = (good, what) => visitor.expect(good, `${path} (${format})`, what);
    const shown = await page.evaluate(contentsOf);
    // Of colours in a program there is nothing to see here: they would pass for pictures.
    await page.evaluate(() => {
      document.styleSheets[0].insertRule("pre, pre * { color: black !important; }");
    });
    const { file, pages } = await printed(page, path, format);
    expect(pages.length > 0, "is no document");
    checkPages(expect, pages, shown);
    checkText(expect, pages, shown);
    checkDrawn(expect, file, shown);
    console.log(`${path} (${format}): ${pages.length} pages`);
    if (path === whole) checkWhole(expect, pages, shown);
  });
}

// The document has each lesson's title, on a page that begins with it and in the contents before.
function checkWhole(expect, printedPages) {
  const tops = printedPages.map(({ body }) =>
    letters(
      body
        .slice(0, 4)
        .map(({ text }) => text)
        .join(""),
    ),
  );
  const contents = letters(
    printedPages
      .slice(0, 4)
      .flatMap(({ body }) => body)
      .map(({ text }) => text)
      .join(""),
  );
  for (const { number, title } of lessons) {
    expect(contents.includes(letters(number + title)), `the contents lack ${number} ${title}`);
    const there = tops.some((top) => top.includes(letters(`Lesson${number}${title}`)));
    expect(there, `${number} ${title} begins on no page`);
  }
}

try {
  await testSite(async (visitor) => {
    visitor.expect(existsSync(join(folder, whole)), folder, `has no ${whole}`);
    // One with labs, a film, a plot, questions and solutions.
    const { path } = lessons.find(({ number }) => number === "1.2");
    await look(visitor, path, "A4");
    await look(visitor, path, "Letter");
    await look(visitor, whole, "A4");
  });
} finally {
  rmSync(work, { recursive: true });
}
