// Every page, on wide and narrow screens, light, and dark without JavaScript: nothing is wider than the
// window, and every picture is there. Enlarged and spaced out as readers may have it, no text is cut off.

import { pages, testSite } from "./browser.mjs";

const widths = [1440, 1000, 390, 360];
const narrowest = 320; // a window of 1280 px, enlarged to 400 %

// The spacing that readers may choose (WCAG 2.2, 1.4.12). Formulas have one of their own.
const spacing = `
  * { letter-spacing: 0.12em !important; line-height: 1.5 !important; word-spacing: 0.16em !important; }
  p { margin-block-end: 2em !important; }
  .katex, .katex * {
    letter-spacing: normal !important; line-height: 1.2 !important; word-spacing: normal !important;
  }`;

function spaceOut(css) {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  document.adoptedStyleSheets = [sheet];
}

// Texts that are cut off. What is there for screen readers alone is 1 px wide; a formula's strut is higher
// than all that is seen of it.
function cutOff() {
  const cut = [...document.querySelectorAll("main *, header *, footer *")].filter((element) => {
    const { overflowX, overflowY } = getComputedStyle(element);
    if (element.clientWidth <= 1 || element.closest(".math")) return false;
    const hides = (overflow) => overflow === "hidden" || overflow === "clip";
    return (
      (hides(overflowX) && element.scrollWidth > element.clientWidth + 1) ||
      (hides(overflowY) && element.scrollHeight > element.clientHeight + 1)
    );
  });
  return cut.slice(0, 5).map((element) => element.outerHTML.slice(0, 80));
}

// What sticks out of the window, where the page as a whole can be scrolled sideways.
function overflowing() {
  const { scrollWidth, clientWidth } = document.documentElement;
  if (scrollWidth <= clientWidth) return [];
  // To the left, where the page is written from right to left.
  const wide = [...document.body.querySelectorAll("*")].filter((element) => {
    const { left, right } = element.getBoundingClientRect();
    return right > clientWidth + 0.5 || left < -0.5;
  });
  return wide.slice(0, 5).map((element) => element.outerHTML.slice(0, 80));
}

// The addresses of pictures that did not load; pictures far below load when they are scrolled to.
async function missingPictures() {
  const missing = [];
  for (const image of document.images) {
    image.loading = "eager";
    await image.decode().catch(() => missing.push(image.currentSrc || image.src));
  }
  return missing;
}

await testSite(async (visitor) => {
  let pictures = 0;
  for (const path of pages) {
    // What a scheme may spoil are pictures, and a script sizes: so two visits do.
    for (const [scheme, javaScript] of [
      ["light", true],
      ["dark", false],
    ]) {
      await visitor.visit(path, { scheme, javaScript }, async (page) => {
        const how = `${path} (${scheme}${javaScript ? "" : ", no JavaScript"}`;
        const fits = async (width, where) => {
          await page.setViewportSize({ width, height: 900 });
          const wide = await page.evaluate(overflowing);
          visitor.expect(wide.length === 0, where, `too wide: ${wide}`);
        };
        for (const width of widths) await fits(width, `${how}, ${width} px)`);
        if (/^(index|models).*html$/.test(path)) {
          const loading = await page.evaluate(() => document.images[0].loading);
          visitor.expect(loading !== "lazy", how, "what is seen first waits until it is near");
        }
        const missing = await page.evaluate(missingPictures);
        visitor.expect(missing.length === 0, `${how})`, `pictures did not load: ${missing}`);
        await page.evaluate(spaceOut, spacing);
        await fits(narrowest, `${how}, ${narrowest} px, spaced out)`);
        const cut = await page.evaluate(cutOff);
        visitor.expect(cut.length === 0, `${how}, spaced out)`, `cut off: ${cut}`);
        pictures += await page.locator(":is(.lab, .figure) picture img").count();
      });
    }
  }
  visitor.expect(pictures > 0, "the site", "no lab or figure has a picture");
});
