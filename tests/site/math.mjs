// Each formula is there twice: as MathML, for what reads aloud and copies, and drawn, for the eye. No
// line begins with the comma behind one.

import { pagesWith, testSite } from "./browser.mjs";

function formulas() {
  return [...document.querySelectorAll(".katex")].map((formula) => ({
    tex: formula.querySelector("annotation[encoding='application/x-tex']")?.textContent ?? "",
    spoken: formula.querySelectorAll(":scope > .katex-mathml > math").length,
    drawn: formula.querySelectorAll(":scope > .katex-html[aria-hidden='true']").length,
    height: formula.getBoundingClientRect().height,
    // Roots, arrows and wide accents.
    drawings: [...formula.querySelectorAll("svg")].map((svg) => svg.getBoundingClientRect().height),
    folded: formula.closest("details:not([open])") !== null,
    onPaper: formula.closest(".answers") !== null,
  }));
}

// Formulas behind which a mark stands on the next line.
function parted() {
  return [...document.querySelectorAll(".with-mark > .math")]
    .filter((formula) => {
      const mark = document.createRange();
      mark.selectNodeContents(formula.nextSibling);
      const { left, top, width } = mark.getBoundingClientRect();
      const end = [...formula.getClientRects()].at(-1);
      return width > 0 && left < end.left && top > end.top + 4;
    })
    .map((formula) => formula.querySelector("annotation").textContent);
}

const errors = () => [...document.querySelectorAll(".katex-error, merror")].map((e) => e.outerHTML);

await testSite(async (visitor) => {
  let count = 0;
  for (const path of pagesWith('class="katex')) {
    await visitor.visit(path, { javaScript: false }, async (page) => {
      for (const width of [360, 390, 412, 480, 600, 768, 1280]) {
        await page.setViewportSize({ width, height: 1000 });
        for (const tex of await page.evaluate(parted)) {
          visitor.complain(path, `at ${width} px a line begins with the mark behind ${tex}`);
        }
      }
      for (const error of await page.evaluate(errors)) visitor.complain(path, error);
      for (const formula of await page.evaluate(formulas)) {
        const { tex, spoken, drawn, height, drawings, folded, onPaper } = formula;
        ++count;
        const seen = folded || onPaper || (height > 0 && drawings.every((svg) => svg > 1));
        const whole = tex !== "" && spoken === 1 && drawn === 1 && seen;
        visitor.expect(whole, path, `a formula that is not whole: ${tex}`);
      }
    });
  }
  visitor.expect(count > 0, "the site", "there are no formulas");
});
