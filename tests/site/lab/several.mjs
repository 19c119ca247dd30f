// Four labs on one page: one engine, one WebGL context, four simulations that know nothing of one
// another, memory that grows under all of them included.

import { testSite } from "../browser.mjs";
import { fourLabs, Lab } from "./lab.mjs";

const ids = ["lab-1", "lab-2", "lab-3", "lab-4"];

function countContexts() {
  globalThis.contexts = 0;
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    if (kind.startsWith("webgl")) globalThis.contexts++;
    return getContext.call(this, kind, ...rest);
  };
}

await testSite(async (visitor) => {
  const fetched = [];
  const before = async (page) => {
    await page.addInitScript(countContexts);
    page.on("request", (request) => fetched.push(request.url()));
  };
  // So high that all four are seen, and play, together.
  const viewport = { width: 1440, height: 5000 };
  await visitor.visit(fourLabs, { before, viewport }, async (page) => {
    const expect = (good, what) => visitor.expect(good, fourLabs, what);
    const labs = [];
    for (const id of ids) labs.push(await Lab.live(page, id));

    const engines = fetched.filter((url) => url.endsWith(".wasm")).length;
    expect(engines === 1, `${engines} engines`);
    const contexts = await page.evaluate(() => globalThis.contexts);
    expect(contexts === 1, `${contexts} WebGL contexts`);

    const [first, second, third, fourth] = labs;
    await first.press("Ten steps");
    const times = await Promise.all(labs.map((lab) => lab.seconds()));
    expect(times.join() === "0.05,0,0,0", `after ten steps of the first: ${times}`);

    for (const lab of labs) await lab.button("Play").last().click();
    for (const lab of labs) await lab.runs();
    for (const lab of labs) await lab.press("Pause");
    await third.press("Back to the start");
    await third.press("Tilted");
    expect((await third.reading("angle")) === "0.800", "the third does not tilt");
    expect((await second.reading("cart")) === "0.000", "the third moves the second");
    await tryEdit(visitor, fourth, first);
  });
});

// A model of another size is compiled: the others go on as they were.
async function tryEdit(visitor, edited, other) {
  const before = await other.readings();
  const bodies = Array.from({ length: 60 }, (_, i) => {
    return `<body pos="${i} 0 1"><freejoint/><geom size="0.1"/></body>`;
  });
  await edited.edit(`<mujoco><worldbody>${bodies.join("")}</worldbody></mujoco>`);
  await edited.root
    .locator(".lab-live .readouts .value", { hasText: /^60$/ })
    .waitFor({ timeout: 30_000 });
  visitor.expect(
    (await other.readings()) === before,
    fourLabs,
    "an edited model moves another lab",
  );
  await other.press("One step");
  await other.press("Back to the start");
  const start = await other.reading("angle");
  visitor.expect(start === "0.0000", fourLabs, `after that the first starts at ${start}`);
}
