// What each kind of page looks like, on a wide screen, on a phone, in the dark and on paper: held
// against the pictures in appearance/, which are half as large as the page.
//
//   node tests/site/appearance.mjs SITE [KIND…]
//   UPDATE_EXPECTED=1 node tests/site/appearance.mjs SITE [KIND…]     takes them anew
//
// Of what differs, the picture and the difference are left in SITE-appearance/.

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import pixelmatch from "../../site/node_modules/pixelmatch/index.js";
import { PNG } from "../../site/node_modules/pngjs/lib/png.js";
import { folder, testSite } from "./browser.mjs";

const expected = join(import.meta.dirname, "appearance");
const left = `${folder}-appearance`;
const update = process.env.UPDATE_EXPECTED === "1";
const asked = process.argv.slice(3);

// Another processor draws the models with a few other pixels. A word that moved, a border that is
// gone, another colour of a button are more.
const mostOff = 0.0002; // of a page's pixels

// A busy browser says that it has all fonts, and draws with them some frames later: so a picture is
// wrong that stays so.
const patience = 5; // more pictures
const pause = 500; // ms between them

const kinds = {
  home: "index.html",
  lesson: "1-motion/1.1-a-pendulum.html",
  short: "2-more/2.1-a-note.html",
  glossary: "glossary.html",
  api: "api.html",
  gallery: "models.html",
  model: "models/pendulum.html",
  review: "review.html",
  progress: "progress.html",
  offline: "offline.html",
  verification: "verification.html",
  missing: "404.html",
  search: "index.html",
  finding: "search.html?q=pendulum",
  document: "print.html",
};
const looks = {
  wide: { width: 1280 },
  dark: { width: 1280, scheme: "dark" },
  phone: { width: 390 },
  paper: { width: 720, media: "print" },
};

// It asks for the site's files in the folders above as well (missing.mjs).
const before = (kind) => (page) => kind === "missing" && page.removeAllListeners();

async function open(page, kind) {
  if (kind === "finding") await page.locator(".search-result").first().waitFor();
  if (kind !== "search") return;
  await page.keyboard.press("/");
  await page.getByRole("combobox").fill("pendulum");
  await page.getByRole("option").first().waitFor();
}

// All pictures are there, also those far below, and all fonts. Not there are the keys of claims, which
// another processor computes otherwise, and the hash of the engine, which each change of it alters.
async function complete() {
  for (const key of document.querySelectorAll(".claim-place code")) key.textContent = "key";
  for (const hash of document.querySelectorAll(".engine-build")) hash.textContent = "hash";
  const pictures = [...document.images];
  for (const picture of pictures) picture.loading = "eager";
  await Promise.all(pictures.map((picture) => picture.decode().catch(() => {})));
  await document.fonts.ready;
}

// What is wrong with the picture, and the difference for a person to see.
function compare(old, young) {
  const { width, height } = old;
  if (width !== young.width || height !== young.height) {
    return {
      wrong: `it is ${young.width} × ${young.height} pixels large, and was ${width} × ${height}`,
    };
  }
  const difference = new PNG({ width, height });
  const off = pixelmatch(old.data, young.data, difference.data, width, height);
  if (off <= mostOff * width * height) return { wrong: "" };
  return { wrong: `${off} pixels are others`, difference };
}

async function take(page, name, settings) {
  await page.waitForTimeout(pause);
  await page.screenshot({ ...settings, path: join(expected, `${name}.png`) });
}

// What is wrong with the page's last picture, which is then left.
async function judge(page, name, settings) {
  const file = join(expected, `${name}.png`);
  if (!existsSync(file)) return "there is no picture of it";
  const old = PNG.sync.read(readFileSync(file));
  for (let later = patience; ; --later) {
    const bytes = await page.screenshot(settings);
    const { wrong, difference } = compare(old, PNG.sync.read(bytes));
    if (wrong !== "" && later > 0) {
      await page.waitForTimeout(pause);
      continue;
    }
    if (wrong !== "") writeFileSync(join(left, `${name}.png`), bytes);
    if (difference) writeFileSync(join(left, `${name}-difference.png`), PNG.sync.write(difference));
    return wrong;
  }
}

rmSync(left, { recursive: true, force: true });
mkdirSync(update ? expected : left, { recursive: true });
await testSite(
  async (visitor) => {
    for (const [kind, path] of Object.entries(kinds)) {
      if (asked.length > 0 && !asked.includes(kind)) continue;
      for (const [look, { media, ...options }] of Object.entries(looks)) {
        if ((kind === "document") !== (look === "paper") && kind !== "lesson") continue;
        const name = `${kind}-${look}`;
        const settings = {
          savesData: true, // a lab would go live, and its clock is not ours
          reducedMotion: "reduce",
          deviceScaleFactor: 0.5,
          before: before(kind),
        };
        await visitor.visit(path, { ...options, ...settings }, async (page) => {
          if (media) await page.emulateMedia({ media });
          await page.evaluate(complete);
          await open(page, kind);
          const screenshot = { fullPage: kind !== "search" };
          if (update) return take(page, name, screenshot);
          const wrong = await judge(page, name, screenshot);
          visitor.expect(wrong === "", name, `${wrong}; see ${left}`);
        });
      }
    }
  },
  { asPictured: true },
);
