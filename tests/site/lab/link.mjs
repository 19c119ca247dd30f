// A link brings another reader to the very same state; what does not fit does no harm; "reset all"
// undoes all of it.

import { testSite } from "../browser.mjs";
import { fourLabs, Lab } from "./lab.mjs";

await testSite(async (visitor) => {
  const expect = (good, what) => visitor.expect(good, fourLabs, what);
  let link, seen, picture;
  await visitor.visit(
    fourLabs,
    { permissions: ["clipboard-read", "clipboard-write"] },
    async (page) => {
      const lab = await Lab.live(page, "lab-1");
      await lab.root.getByRole("slider", { name: "Motor" }).fill("0.75");
      await lab.press("Kick the cart");
      await lab.press("Ten steps");
      await lab.root.getByRole("switch", { name: "Gravity" }).click();
      await lab.press("Ten steps");
      await lab.root.getByRole("checkbox", { name: "com" }).check();
      await lab.root.getByRole("combobox", { name: "Speed" }).selectOption("2×");
      await lab.canvas.focus();
      await page.keyboard.press("ArrowLeft");
      link = await copied(lab, "Copy a link to this state");
      seen = await state(lab);
      picture = await lab.picture();
      const program = await copied(lab, "Copy the state as C++");
      expect(program.includes("data->time = 0.1"), `the state as C++ is ${program}`);
      await lab.press("Ten steps");
      seen += ` then ${await state(lab)}`;
    },
  );

  const path = link.slice(visitor.address("").length);
  await visitor.visit(path, {}, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    await lab.time.filter({ hasText: "0.100 s" }).waitFor();
    expect((await lab.picture()) === picture, "the link brings another view");
    let again = await state(lab);
    await lab.press("Ten steps");
    again += ` then ${await state(lab)}`;
    expect(again === seen, `the link brings ${again}, not ${seen}`);
    const other = await Lab.live(page, "lab-2");
    expect((await other.seconds()) === 0, "the link moves another lab");

    await lab.root.scrollIntoViewIfNeeded();
    await lab.press("reset all");
    const fresh = await state(lab);
    expect(fresh === "0.000 0.0000 0.0000 0.00 -9.81 1", `after the reset: ${fresh}`);
    const shown = await lab.shown();
    expect(shown === "joints tendons", `after the reset, ${shown} are shown`);
    expect(!page.url().includes("lab="), "the address still speaks of the lab");
  });

  for (const value of ["", "1", "nonsense", "1AAAA", "9abc"]) {
    await visitor.visit(`${fourLabs}?lab=${value}#lab-1`, {}, async (page) => {
      const lab = await Lab.live(page, "lab-1");
      expect((await lab.seconds()) === 0, `?lab=${value} moves the lab`);
    });
  }
});

async function state(lab) {
  const speed = await lab.root.getByRole("combobox", { name: "Speed" }).inputValue();
  return `${await lab.readings()} ${speed}`;
}

async function copied(lab, what) {
  await lab.press("copy");
  await lab.press(what);
  await lab.root.getByText(/copied\.$/).waitFor();
  return lab.page.evaluate(() => navigator.clipboard.readText());
}
