// axe finds nothing in labs that are live, with all that can be opened open: the editor, the push
// form, an answer, an alert, a menu, and what asks about a link; in either scheme, on a wide and on a narrow screen.

import { violations } from "../axe.mjs";
import { testSite } from "../browser.mjs";
import { fourLabs, Lab, trouble } from "./lab.mjs";

await testSite(async (visitor) => {
  for (const scheme of ["light", "dark"]) {
    for (const width of [1440, 390]) {
      for (const [path, open] of [
        [`${fourLabs}?lab=2.lab-1.0.A`, openAll],
        [trouble, failBoth],
      ]) {
        await visitor.visit(path, { scheme, width }, async (page) => {
          await open(page);
          for (const violation of await violations(page)) {
            visitor.complain(`${path} (${scheme}, ${width} px)`, violation);
          }
        });
      }
    }
  }
});

async function openAll(page) {
  await Lab.live(page, "lab-3");
  const edited = await Lab.live(page, "lab-4");
  await edited.root.locator("summary").click();
  await edited.root.getByRole("textbox", { name: /^MJCF of/ }).waitFor();
  const asked = await Lab.live(page, "lab-2");
  await asked.root.getByRole("textbox").fill("0.5");
  await asked.root.getByRole("textbox").press("Enter");
  await asked.root.locator(".lab-compare").waitFor({ timeout: 30_000 });
  const lab = await Lab.live(page, "lab-1");
  await lab.button("Leave it").waitFor();
  await lab.press("push");
  await lab.press("keys");
}

async function failBoth(page) {
  const lab = await Lab.live(page, "lab-1");
  await lab.press("One step");
  await lab.press("Look");
  await lab.root.locator(".lab-trouble").waitFor();
}
