// Fingers on a lab: one up or down scrolls the page, one sideways turns the view, two zoom it; with
// "a drag pulls bodies" one pulls. The mouse does the same and more.

import { testSite } from "../browser.mjs";
import { fourLabs, Lab } from "./lab.mjs";

await testSite(async (visitor) => {
  await visitor.visit(fourLabs, { width: 390, hasTouch: true, isMobile: true }, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    const expect = (good, what) => visitor.expect(good, fourLabs, what);
    const client = await page.context().newCDPSession(page);
    const touch = async (ways) => drag(client, lab, ways);

    let before = await lab.picture();
    const top = () => page.evaluate(() => scrollY);
    const from = await top();
    await touch([[0, -100]]);
    expect((await top()) > from, "a finger up does not scroll the page");
    expect((await lab.picture()) === before, "and turns the view");
    await lab.canvas.scrollIntoViewIfNeeded();
    await touch([[80, 0]]);
    expect((await lab.picture()) !== before, "a finger sideways does not turn the view");
    before = await lab.picture();
    await touch([
      [-60, 0],
      [60, 0],
    ]);
    expect((await lab.picture()) !== before, "two fingers do not zoom");
  });

  await visitor.visit(fourLabs, {}, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    const expect = (good, what) => visitor.expect(good, fourLabs, what);
    await tryMouse(lab, expect);
  });
});

// Each finger goes from beside the middle of the view by [dx, dy] pixels.
async function drag(client, lab, ways) {
  await lab.canvas.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await lab.canvas.boundingBox();
  const steps = 8;
  const points = (step) =>
    ways.map(([dx, dy], id) => ({
      id,
      x: x + width / 2 + id * 30 + (dx * step) / steps,
      y: y + height / 2 + (dy * step) / steps,
    }));
  const send = (type, touchPoints) =>
    client.send("Input.dispatchTouchEvent", { type, touchPoints });
  await send("touchStart", points(0));
  for (let step = 1; step <= steps; ++step) await send("touchMove", points(step));
  await send("touchEnd", []);
  await lab.settle();
}

async function tryMouse(lab, expect) {
  const { page } = lab;
  const { x, y, width, height } = await lab.canvas.boundingBox();
  const middle = [x + width / 2, y + height / 2];
  const first = await lab.picture();
  const dragged = async (options = {}) => {
    await page.mouse.move(...middle);
    await page.mouse.down(options);
    await page.mouse.move(middle[0] + 60, middle[1] + 10, { steps: 4 });
    await page.mouse.up(options);
    return lab.picture();
  };
  const turned = await dragged();
  expect(turned !== first, "a drag does not turn the view");
  expect((await dragged({ button: "right" })) !== turned, "the right button does not move it");
  await page.mouse.dblclick(...middle);
  expect((await lab.picture()) === first, "a double click is not the lesson’s view");

  await lab.canvas.evaluate((canvas) => canvas.blur());
  const top = () => page.evaluate(() => scrollY);
  const from = await top();
  await page.mouse.wheel(0, 60);
  await page.waitForFunction((before) => scrollY !== before, from);
  expect((await lab.picture()) === first, "the wheel zooms while it scrolls the page");
  await lab.canvas.focus();
  await lab.settle();
  const there = await top();
  await page.mouse.wheel(0, -60);
  expect((await lab.picture()) !== first, "the wheel does not zoom the focused view");
  expect((await top()) === there, "and scrolls the page");
  await page.mouse.dblclick(middle[0], middle[1] - 40);
  await tryPull(lab, expect);
}

// Ctrl takes the cart, which is above the middle, by the hand; time goes on for as long.
async function tryPull(lab, expect) {
  const { page } = lab;
  const { x, y, width, height } = await lab.canvas.boundingBox();
  const cart = [x + width / 2, y + height * 0.4];
  await page.keyboard.down("Control");
  await page.mouse.move(...cart);
  await page.mouse.down();
  await page.mouse.move(cart[0] + 80, cart[1], { steps: 4 });
  await lab.runs();
  await lab.runs();
  await page.mouse.up();
  await page.keyboard.up("Control");
  await lab.settle();
  expect(Number(await lab.reading("cart")) > 0, "a pull does not move the cart");
  expect(await lab.rests(), "time goes on after the pull");
}
