// Figures: pictures at their size, films that play when they are asked to and not before, words for
// those who see neither, and stills on paper; with and without JavaScript.
//
//   node tests/site/figures.mjs SITE
//
// The site must have a still and a film.

import { setTimeout } from "node:timers/promises";

import { pages, testSite } from "./browser.mjs";

await testSite(async (visitor) => {
  const met = { stills: 0, films: 0 };
  for (const path of pages) {
    for (const options of [{}, { javaScript: false }, { width: 390 }]) {
      const fetched = [];
      const before = (page) => page.on("request", (request) => fetched.push(request.url()));
      await visitor.visit(path, { ...options, before }, async (page) => {
        const where = `${path} (${JSON.stringify(options)})`;
        const expect = (good, what) => visitor.expect(good, where, what);
        for (const figure of await page.locator(".figure").all()) {
          const film = (await figure.locator("video").count()) > 0;
          met[film ? "films" : "stills"]++;
          await figure.scrollIntoViewIfNeeded();
          await (film ? tryFilm(figure, fetched, expect) : tryStill(figure, expect));
        }
        await tryPaper(page, expect);
      });
    }
  }
  visitor.expect(met.stills > 0 && met.films > 0, "the site", "lacks a still or a film");
});

// How large `element` shows, how large it says it is, and how many pixels it has.
async function sizes(element) {
  return element.evaluate(async (shown) => {
    if (shown instanceof HTMLImageElement) await shown.decode();
    const { width, height } = shown.getBoundingClientRect();
    return {
      width,
      height,
      said: Number(shown.getAttribute("width")),
      ratio: Number(shown.getAttribute("width")) / Number(shown.getAttribute("height")),
      natural: shown.naturalWidth ?? shown.videoWidth,
      room: document.documentElement.clientWidth,
    };
  });
}

// `pixels` of its own for each of the page's.
function expectSize({ width, height, said, ratio, natural, room }, pixels, expect, what) {
  const fits = width === said || (width < said && width > 0.75 * room);
  expect(fits, `${what} says ${said} pixels and is ${width} wide, in ${room}`);
  expect(Math.abs(width / height - ratio) < 0.02, `${what} is ${width} x ${height}`);
  expect(
    Math.abs(natural - pixels * said) < 2,
    `${what} of ${said} pixels has ${natural} of its own`,
  );
}

async function tryStill(figure, expect) {
  const image = figure.locator("img");
  expect((await image.getAttribute("alt")) !== "", "a still without words");
  expectSize(await sizes(image), 2, expect, "a still");
}

async function tryFilm(figure, fetched, expect) {
  const film = figure.locator("video");
  const address = await film.evaluate((video) => video.src);
  expect((await film.getAttribute("aria-label")) !== "", "a film without words");
  expect(await figure.locator("img").isHidden(), "a film and its still beside each other");
  expect(!fetched.includes(address), "a film that nobody plays is fetched");
  expect(await film.evaluate((video) => video.paused && video.muted), "a film plays by itself");
  expect(
    fetched.some((url) => url.endsWith(".webp") && url.startsWith(address.slice(0, -4))),
    "a film without its poster",
  );
  // As the reader would, by the browser's own controls.
  await film.focus();
  await film.press("Space");
  // A page without JavaScript has no timers, so the looking is done from here.
  let played = false;
  for (let look = 0; look < 100 && !played; ++look) {
    await setTimeout(100);
    played = await film.evaluate((video) => video.currentTime > 0.1);
  }
  expect(played, "a film does not play");
  expectSize(await sizes(film), 1.5, expect, "a film");
  await film.press("Space");
}

async function tryPaper(page, expect) {
  await page.emulateMedia({ media: "print" });
  for (const figure of await page.locator(".figure").all()) {
    expect((await figure.locator("video:visible").count()) === 0, "a film on paper");
    await figure.scrollIntoViewIfNeeded();
    const { width } = await sizes(figure.locator("img"));
    expect(width > 0, "a figure is missing on paper");
  }
}
