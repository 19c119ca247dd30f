// The browser may take WebGL away, say when the computer sleeps: a lab says so, goes on computing, and
// is drawn again when it is back.

import { testSite } from "../browser.mjs";
import { fourLabs, Lab } from "./lab.mjs";

// Keeps the page's WebGL contexts, which are on no canvas of the document.
function keepContexts() {
  globalThis.contexts = [];
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    const context = getContext.call(this, kind, ...rest);
    if (kind.startsWith("webgl")) globalThis.contexts.push(context);
    return context;
  };
}

await testSite(async (visitor) => {
  const before = (page) => page.addInitScript(keepContexts);
  await visitor.visit(fourLabs, { before }, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    const expect = (good, what) => visitor.expect(good, fourLabs, what);
    const first = await lab.picture();
    const status = lab.root.locator(".lab-status");

    await page.evaluate(() => {
      globalThis.extension = globalThis.contexts[0].getExtension("WEBGL_lose_context");
      globalThis.extension.loseContext();
    });
    await status.filter({ hasText: "taken the 3D view away" }).waitFor();
    await lab.press("Ten steps");
    expect((await lab.reading("time")) === "0.050", "without a view it does not compute");
    expect((await lab.picture()) === first, "a lost view draws");

    await page.evaluate(() => globalThis.extension.restoreContext());
    await status.waitFor({ state: "hidden" });
    await lab.press("Back to the start");
    expect((await lab.picture()) === first, "the view that came back differs");
    await lab.root.getByRole("combobox", { name: "Pole", exact: true }).selectOption("lies");
    expect((await lab.picture()) !== first, "the view that came back stands still");
  });
});
