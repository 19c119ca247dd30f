// Each formula is there twice: as MathML, for what reads aloud and copies, and drawn, for the eye. No
// line begins with the comma behind one.

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

// Gives how many formulas there are.
async function plain(page, { expect }) {
  for (const width of [360, 390, 412, 480, 600, 768, 1280]) {
    await page.setViewportSize({ width, height: 1000 });
    for (const tex of await page.evaluate(parted)) {
      expect(false, `at ${width} px a line begins with the mark behind ${tex}`);
    }
  }
  for (const error of await page.evaluate(errors)) expect(false, error);
  const all = await page.evaluate(formulas);
  for (const { tex, spoken, drawn, height, drawings, folded, onPaper } of all) {
    const seen = folded || onPaper || (height > 0 && drawings.every((svg) => svg > 1));
    const whole = tex !== "" && spoken === 1 && drawn === 1 && seen;
    expect(whole, `a formula that is not whole: ${tex}`);
  }
  return all.length;
}

export const concerns = (html) => html.includes('class="katex');
export const looks = { plain };

export function conclude({ plain: counts }, { expect }) {
  const count = [...counts.values()].reduce((sum, formulas) => sum + formulas, 0);
  expect(count > 0, "the site", "there are no formulas");
}
