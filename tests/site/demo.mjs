// A demo shows what its author writes, and below that what it becomes: both to be read on a wide screen
// and on a phone, light and dark, on paper and without JavaScript.
//
//   node tests/site/demo.mjs SITE
//
// The site must have demos: the author guide is made of them.

import { pagesWith, testSite } from "./browser.mjs";

// What a demo's two halves hold, and where they are.
function halves() {
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
function contents() {
  const listed = [...document.querySelectorAll(".contents a")].map((link) => link.hash.slice(1));
  const shown = [...document.querySelectorAll(".demo-page :is(h2, h3, h4)[id]")].map(
    ({ id }) => id,
  );
  return { listed, shown };
}

await testSite(async (visitor) => {
  let demos = 0;
  let headings = 0;
  const ways = [
    { width: 1440 },
    { width: 390, scheme: "dark" },
    { width: 360, javaScript: false },
    { width: 700, media: "print" },
  ];
  for (const path of pagesWith('class="demo"')) {
    for (const { media, ...options } of ways) {
      await visitor.visit(path, options, async (page) => {
        if (media) await page.emulateMedia({ media });
        for (const { begins, ...demo } of await page.evaluate(halves)) {
          ++demos;
          const where = `${path} (${options.width} px) "${begins}"`;
          const expect = (good, what) => visitor.expect(good, where, what);
          expect(demo.labels === "In the lesson,In the page", `is labelled ${demo.labels}`);
          expect(!demo.empty, "becomes nothing");
          expect(demo.apart, "what it becomes is not below what is written");
          expect(!demo.clipped, "its source sticks out");
          expect(!demo.narrow, "what it becomes has not the page's column");
          expect(!demo.fences, "a fence is left in what it becomes");
        }
        const { listed, shown } = await page.evaluate(contents);
        headings += shown.length;
        for (const id of shown) {
          visitor.expect(!listed.includes(id), path, `the contents list #${id}, of a demo`);
        }
      });
    }
  }
  visitor.expect(demos > 0, "the site", "there are no demos");
  visitor.expect(headings > 0, "the site", "no demo has a heading");
});
