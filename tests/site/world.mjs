// Pages in a language that is written from right to left, in a script without a slant: they say so, what is
// code runs the other way, and the search finds a word within a run of Chinese, which has no blanks.

import { pages, testSite } from "./browser.mjs";

const lesson = pages.find((path) => path.includes("/1.1-"));

// How things are set, and where.
function seen() {
  const style = (selector) => getComputedStyle(document.querySelector(selector));
  const left = (selector) => document.querySelector(selector).getBoundingClientRect().left;
  return {
    page: style(".prose p").direction,
    code: style(".prose pre").direction,
    word: style(".prose p code").direction,
    emphasis: style(".prose em").fontStyle,
    weight: Number(style(".prose em").fontWeight),
    quote: style(".prose blockquote p").fontStyle,
    formula: style(".prose .katex .mathnormal").fontStyle,
    lessonsAtTheRight: left(".lessons") > left("main"),
  };
}

async function isSetSo(visitor) {
  await visitor.visit(lesson, {}, async (page) => {
    const found = await page.evaluate(seen);
    const expected = {
      page: "rtl",
      code: "ltr",
      word: "ltr",
      emphasis: "normal",
      weight: 600,
      quote: "normal",
      formula: "italic",
      lessonsAtTheRight: true,
    };
    for (const [what, value] of Object.entries(expected)) {
      visitor.expect(found[what] === value, lesson, `${what} is ${found[what]}`);
    }
  });
}

async function findsWithinRuns(visitor) {
  for (const [words, marked] of [
    ["动力学", "动力学"],
    ["关节", "关节"],
    ["力", "力"],
    ["المفصل", "المفصل"],
  ]) {
    await visitor.visit("index.html", {}, async (page) => {
      await page.keyboard.press("Control+k");
      await page.getByRole("combobox").fill(words);
      const first = page.getByRole("option").first();
      await first.waitFor();
      const href = decodeURIComponent(await first.getAttribute("href"));
      visitor.expect(href.includes("1.1-"), words, `finds ${href}`);
      const marks = await first.locator("mark").allInnerTexts();
      visitor.expect(marks.includes(marked), words, `marks ${marks}`);
    });
  }
  await visitor.visit("index.html", {}, async (page) => {
    await page.keyboard.press("Control+k");
    await page.getByRole("combobox").fill("器动");
    await page.getByText("Nothing is found").waitFor();
  });
}

await testSite(async (visitor) => {
  await isSetSo(visitor);
  await findsWithinRuns(visitor);
});
