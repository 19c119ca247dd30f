// What a lab says when something goes wrong: a script, MuJoCo, a browser that lacks what it needs.

import { testSite } from "../browser.mjs";
import { Lab, trouble } from "./lab.mjs";

await testSite(async (visitor) => {
  const expect = (good, what) => visitor.expect(good, trouble, what);
  await visitor.visit(trouble, {}, async (page) => {
    await tryScript(await Lab.live(page, "lab-1"), expect);
    await tryDiverging(await Lab.live(page, "lab-2"), expect);
  });

  // What goes live by itself, as a small lab does, is in nobody's way: the other keeps its button.
  const unasked = (page) =>
    page.route(`**/${trouble}`, async (route) => {
      const response = await route.fetch();
      const body = (await response.text()).replaceAll(" data-large", "");
      await route.fulfill({ response, body });
    });
  for (const before of [undefined, unasked]) {
    await visitor.visit(trouble, { before }, (page) =>
      tryTwoLarge(page, before !== undefined, expect),
    );
  }

  const lacking = [
    ["WebGL 2", (page) => page.addInitScript(refuseWebGL)],
    ["WebAssembly", (page) => page.addInitScript(() => delete globalThis.WebAssembly)],
    ["could not be loaded", breakModule],
  ];
  for (const [words, before] of lacking) {
    await visitor.visit(trouble, { before }, async (page) => {
      const lab = page.locator("#lab-1");
      for (const place of [4, 5]) await page.mouse.move(place, place);
      const status = lab.getByRole("status").filter({ hasText: words });
      await status.waitFor({ timeout: 30_000 });
      expect(await lab.locator("img").isVisible(), `without ${words} there is no poster`);
      const buttons = await lab.getByRole("button").count();
      expect(buttons === 0, `without ${words} there are ${buttons} buttons that do nothing`);
    });
  }
});

async function tryScript(lab, expect) {
  await lab.press("Look");
  await lab.press("Ten steps");
  const alert = lab.root.getByRole("alert");
  expect((await alert.innerText()) === "", "there is an alert before there is trouble");
  await lab.press("Look");
  const words = await alert.innerText();
  for (const part of ["data.qpos[7] is out of range 0..1", "const moved = data.time > 0;"]) {
    expect(words.includes(part), `the alert says ${words}, not ${part}`);
  }
  await lab.button("Play").first().click();
  expect(await lab.rests(), "it plays on in trouble");
  await lab.press("Back to the start");
  expect((await alert.innerText()) === "", "a reset leaves the alert");
  await lab.press("One step");
  expect((await lab.seconds()) === 0.005, "after a reset it does not go on");
}

// Two labs of more than a gibibyte each.
async function tryTwoLarge(page, goesLive, expect) {
  const labs = ["lab-3", "lab-4"].map((id) => new Lab(page, id));
  for (const place of [4, 5]) await page.mouse.move(place, place);
  await labs[1].root.scrollIntoViewIfNeeded();
  const live = page.locator(":is(#lab-3, #lab-4)[data-live]");
  if (goesLive) await live.waitFor({ timeout: 60_000 });
  await page.evaluate(idle);
  expect((await live.count()) === (goesLive ? 1 : 0), `${await live.count()} large labs are live`);
  if (!goesLive) await labs[0].button("Play").click();
  await live.waitFor({ timeout: 60_000 });
  const other = (await live.getAttribute("id")) === "lab-3" ? labs[1] : labs[0];
  await other.button("Play").click();
  const words = /no memory left for this lab’s model, so it stays a picture/;
  await other.root.getByRole("status").filter({ hasText: words }).waitFor({ timeout: 60_000 });
  expect((await other.button("Play").count()) === 0, "a button is left that does nothing");
}

// Three times, after which what the page does unasked is done.
async function idle() {
  for (let i = 0; i < 3; ++i) {
    await new Promise((resolve) => requestIdleCallback(resolve));
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
}

async function tryDiverging(lab, expect) {
  await lab.press("One step");
  await lab.press("Blow up");
  await lab.press("Ten steps");
  const words = await lab.root.getByRole("alert").innerText();
  expect(words.includes("The simulation stopped"), `of a diverged simulation it says "${words}"`);
  await lab.press("Back to the start");
  await lab.press("One step");
  expect((await lab.seconds()) === 0.005, "after a reset it does not go on");
}

function refuseWebGL() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...rest);
  };
}

// The lab's module arrives, and is not one.
async function breakModule(page) {
  const body = "throw new Error('broken on purpose');";
  await page.route("**/labs/*.js", (route) =>
    route.fulfill({ contentType: "text/javascript", body }),
  );
}
