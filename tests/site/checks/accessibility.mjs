// axe finds nothing, on a wide light and on a narrow dark screen, with everything unfolded.

import { violations } from "../axe.mjs";

async function unfold() {
  for (const details of document.querySelectorAll("details")) details.open = true;
  // The page's own script follows what was unfolded: observers are told after the next frame.
  for (let frame = 0; frame < 2; ++frame) await new Promise(requestAnimationFrame);
}

async function light(page, { expect }) {
  const look = async (how) => {
    await page.evaluate(unfold);
    for (const violation of await violations(page)) expect(false, `(${how}) ${violation}`);
  };
  // What a scheme may spoil are colours, and a width sizes and places: so two looks do.
  await look("light, 1440 px");
  await page.setViewportSize({ width: 390, height: 900 });
  await page.emulateMedia({ colorScheme: "dark" });
  await look("dark, 390 px");
}

export const looks = { light };
