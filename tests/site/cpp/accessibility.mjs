// The editor of a program is for everybody: axe finds nothing while it asks, edits, complains and has
// printed, in both schemes and on a phone, and the keyboard does all of it.
//
//   node tests/site/cpp/accessibility.mjs SITE

import { violations } from "../axe.mjs";
import { testPrograms } from "./compiler.mjs";
import { fallPage, Program } from "./program.mjs";

async function look(page, visitor, how) {
  // Scrolled, the page's head covers a part of what is below it.
  await page.evaluate(() => scrollTo(0, 0));
  for (const violation of await violations(page))
    visitor.complain(`${fallPage} (${how})`, violation);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  visitor.expect(wide <= 0, fallPage, `${how}: the page is ${wide} px too wide`);
}

async function fits(page, visitor, how) {
  const buttons = await page.locator("#example-fall button:visible").all();
  for (const button of buttons) {
    const { width, height } = await button.boundingBox();
    const name = await button.textContent();
    visitor.expect(
      width >= 24 && height >= 24,
      fallPage,
      `${how}: “${name}” is ${width} by ${height}`,
    );
  }
}

const focused = (page) =>
  page.evaluate(() => {
    const { activeElement } = document;
    return (activeElement.shadowRoot?.activeElement ?? activeElement).textContent.trim();
  });

// From the listing into the editor, to Run, and back.
async function byKeyboard(page, program, expect) {
  await program.button(/^Edit and run/).focus();
  await page.keyboard.press("Enter");
  await program.button("Fetch the compiler").waitFor();
  expect(
    (await focused(page)) === "Fetch the compiler",
    `asked, the focus is on ${await focused(page)}`,
  );
  await page.keyboard.press("Enter");
  await program.says("Ready to run.");
  expect((await focused(page)).includes("int main()"), "opened, the focus is not in the editor");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Tab");
  expect((await focused(page)) === "Run", `out of the editor, it is on ${await focused(page)}`);
  await page.keyboard.press("Enter");
  await program.says("It ran to the end.");
}

await testPrograms(async (visitor) => {
  for (const [scheme, width] of [
    ["light", 1440],
    ["dark", 360],
  ]) {
    const how = (state) => `${scheme}, ${width} px, ${state}`;
    await visitor.visit(fallPage, { scheme, width }, async (page) => {
      const expect = (good, what) => visitor.expect(good, fallPage, what);
      const program = new Program(page, "example-fall");
      await program.button(/^Edit and run/).click();
      await look(page, visitor, how("asked"));
      await fits(page, visitor, how("asked"));
      await program.button("Not now").click();
      expect((await focused(page)).startsWith("Edit and run"), "Not now loses the focus");
      await byKeyboard(page, program, expect);
      await look(page, visitor, how("run"));
      await program.replace("seconds = 0.5;", "seconds = undeclared;");
      await program.run();
      await look(page, visitor, how("refused"));
      await fits(page, visitor, how("refused"));
      expect((await program.status.getAttribute("role")) === "status", "nobody hears how it goes");
    });
  }
});
