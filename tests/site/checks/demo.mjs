// A demo shows what its author writes, and below that what it becomes: both to be read on a wide screen
// and on a phone, light and dark, on paper and without JavaScript. The author guide is made of demos.

// What a demo's two halves hold, and where they are.
function halvesOf() {
  return [...document.querySelectorAll(".demo")].map((demo) => {
    const [source, result] = [demo.querySelector("pre"), demo.querySelector(".demo-page")];
    const box = (element) => element.getBoundingClientRect();
    return {
      begins: source.textContent.trim().slice(0, 40),
      labels: [...demo.querySelectorAll(".demo-label")].map((label) => label.textContent).join(),
      empty: result.children.length === 0 || box(result).height < 8,
      apart: box(result).top >= box(source).bottom && box(source).height > 8,
      // All of a lesson's line can be read without scrolling sideways.
      clipped: source.scrollWidth > source.clientWidth,
      narrow: box(result).width < 0.9 * box(demo.parentElement).width,
      fences: result.textContent.includes("```"),
    };
  });
}

// The page's contents, and the headings of its demos, which are not among them.
function contentsOf() {
  const listed = [...document.querySelectorAll(".contents a")].map((link) => link.hash.slice(1));
  const shown = [...document.querySelectorAll(".demo-page :is(h2, h3, h4)[id]")].map(
    ({ id }) => id,
  );
  return { listed, shown };
}

async function lookAt(page, expect, width, media) {
  await page.setViewportSize({ width, height: 900 });
  await page.emulateMedia(media);
  const demos = await page.evaluate(halvesOf);
  for (const demo of demos) {
    const that = (good, what) => expect(good, `at ${width} px "${demo.begins}" ${what}`);
    that(demo.labels === "In the lesson,In the page", `is labelled ${demo.labels}`);
    that(!demo.empty, "becomes nothing");
    that(demo.apart, "becomes something that does not stand below its source");
    that(!demo.clipped, "has a source that sticks out");
    that(!demo.narrow, "becomes something that does not fill the page's column");
    that(!demo.fences, "has a fence left in what it becomes");
  }
  return demos.length;
}

async function light(page, { expect }) {
  const demos = await lookAt(page, expect, 1440, {});
  await lookAt(page, expect, 390, { colorScheme: "dark" });
  await lookAt(page, expect, 700, { media: "print", colorScheme: "light" });
  const { listed, shown } = await page.evaluate(contentsOf);
  for (const id of shown) expect(!listed.includes(id), `the contents list #${id}, of a demo`);
  return { demos, headings: shown.length };
}

const plain = (page, { expect }) => lookAt(page, expect, 360, {});

export const concerns = (html) => html.includes('class="demo"');
export const looks = { light, plain };

export function conclude({ light: found }, { expect }) {
  const total = (what) => [...found.values()].reduce((sum, counts) => sum + counts[what], 0);
  expect(total("demos") > 0, "the site", "there are no demos");
  expect(total("headings") > 0, "the site", "no demo has a heading");
}
