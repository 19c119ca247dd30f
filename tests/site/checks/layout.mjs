// On wide and narrow screens, light, and dark without JavaScript: nothing is wider than the window, and
// every picture is there. Enlarged and spaced out as readers may have it, no text is cut off.

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

function closeUp() {
  document.adoptedStyleSheets = [];
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
    const { loading } = image;
    image.loading = "eager";
    await image.decode().catch(() => missing.push(image.currentSrc || image.src));
    image.loading = loading;
  }
  return missing;
}

// What a scheme may spoil are pictures, and a script sizes: so two views do. Gives how many pictures labs
// and figures have.
async function look(page, { path, expect }) {
  const fits = async (width, how) => {
    await page.setViewportSize({ width, height: 900 });
    const wide = await page.evaluate(overflowing);
    expect(wide.length === 0, `at ${width} px${how} this is too wide: ${wide}`);
  };
  for (const width of widths) await fits(width, "");
  if (/^(index|models).*html$/.test(path)) {
    const loading = await page.evaluate(() => document.images[0].loading);
    expect(loading !== "lazy", "what is seen first waits until it is near");
  }
  const missing = await page.evaluate(missingPictures);
  expect(missing.length === 0, `pictures did not load: ${missing}`);
  await page.evaluate(spaceOut, spacing);
  await fits(narrowest, ", spaced out,");
  const cut = await page.evaluate(cutOff);
  expect(cut.length === 0, `spaced out, this is cut off: ${cut}`);
  await page.evaluate(closeUp);
  return page.locator(":is(.lab, .figure) picture img").count();
}

export const looks = { light: look, plain: look };

export function conclude({ light }, { expect }) {
  const pictures = [...light.values()].reduce((sum, count) => sum + count, 0);
  expect(pictures > 0, "the site", "no lab or figure has a picture");
}
