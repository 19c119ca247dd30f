// A lab without a mouse: every key does what the list of keys says, and the focus is seen.

import { testSite } from "../browser.mjs";
import { fourLabs, Lab } from "./lab.mjs";

await testSite(async (visitor) => {
  await visitor.visit(fourLabs, {}, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    const expect = (good, what) => visitor.expect(good, fourLabs, what);
    const press = async (...keys) => {
      for (const key of keys) await page.keyboard.press(key);
      await lab.settle();
    };

    // As where a lesson puts the lab into an element of its own that calls itself an editor.
    await page.evaluate(() => document.querySelector(".prose").classList.add("lab-editor"));
    await lab.canvas.focus();
    await press(".");
    expect((await lab.seconds()) === 0.005, "the period is no step");
    await press("Shift+>");
    expect((await lab.seconds()) === 0.055, "Shift and the period are not ten steps");
    await press("0");
    expect((await lab.seconds()) === 0, "0 is not the start");
    await press("k");
    await lab.runs();
    await press("Space");
    expect(await lab.rests(), "Space on the view does not pause");

    const speed = lab.root.getByRole("combobox", { name: "Speed" });
    await press("[");
    expect((await speed.inputValue()) === "0.5", "[ is not slower");
    await press("]", "]");
    expect((await speed.inputValue()) === "2", "] is not faster");

    await tryView(lab, press, expect);
    await tryFocus(lab, press, expect);
    await tryPush(lab, press, expect);
  });
});

async function tryView(lab, press, expect) {
  await lab.canvas.focus();
  const pictures = new Set([await lab.picture()]);
  const keys = ["ArrowLeft", "ArrowUp", "Shift+ArrowLeft", "Shift+ArrowUp", "+", "-", "v"];
  for (const key of keys) {
    const before = pictures.size;
    await press(key);
    pictures.add(await lab.picture());
    expect(pictures.size === before + 1, `${key} shows what was seen before`);
  }
  await press("v", "v", "v");
  await press("Shift+?");
  const list = lab.root.locator(".lab-keys");
  expect(await list.isVisible(), "? shows no list of keys");
  await press("Escape");
  expect(!(await list.isVisible()), "Escape leaves the list of keys");
}

// Space presses the focused button and no more; typing in a field is typing.
async function tryFocus(lab, press, expect) {
  await press("0");
  await lab.button("Ten steps").focus();
  await press("Space");
  expect((await lab.seconds()) === 0.05, "Space on a button does not press it alone");
  const ring = await lab.button("Ten steps").evaluate((button) => {
    const { outlineStyle, outlineWidth } = getComputedStyle(button);
    return `${outlineStyle} ${outlineWidth}`;
  });
  expect(ring === "solid 2px", `the focus is shown as ${ring}`);
  const second = await Lab.live(lab.page, "lab-2");
  await second.root.getByRole("textbox").fill("");
  await second.root.getByRole("textbox").pressSequentially("0.5");
  expect((await second.root.getByRole("textbox").inputValue()) === "0.5", "a field loses keys");
  expect((await second.seconds()) === 0, "a key in a field moves the lab");
  await lab.root.scrollIntoViewIfNeeded();
}

async function tryPush(lab, press, expect) {
  await lab.button("push").focus();
  await press("Enter");
  await lab.root.getByLabel("Body").selectOption("cart");
  await lab.root.getByLabel("Direction").selectOption("−x");
  await lab.root.getByLabel("Force").fill("20");
  await press("Enter");
  await lab.press("Pause");
  const where = Number(await lab.reading("cart"));
  expect(where < -0.02, `pushed to the left, the cart is at ${where}`);
}
