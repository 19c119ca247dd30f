// Every page, on wide and narrow screens, light, and dark without JavaScript: nothing is wider than the
// window, and every picture is there.

import { pages, testSite } from "./browser.mjs";

const widths = [1440, 1000, 390, 360];

// What sticks out of the window, where the page as a whole can be scrolled sideways.
function overflowing() {
  const { scrollWidth, clientWidth } = document.documentElement;
  if (scrollWidth <= clientWidth) return [];
  const wide = [...document.body.querySelectorAll("*")].filter(
    (element) => element.getBoundingClientRect().right > clientWidth + 0.5,
  );
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
        for (const width of widths) {
          await page.setViewportSize({ width, height: 900 });
          const wide = await page.evaluate(overflowing);
          visitor.expect(wide.length === 0, `${how}, ${width} px)`, `too wide: ${wide}`);
        }
        const missing = await page.evaluate(missingPictures);
        visitor.expect(missing.length === 0, `${how})`, `pictures did not load: ${missing}`);
        pictures += await page.locator(":is(.lab, .figure) picture img").count();
      });
    }
  }
  visitor.expect(pictures > 0, "the site", "no lab or figure has a picture");
});
