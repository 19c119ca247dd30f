// What a test does with a lab of a page: waits until it is live, presses its buttons, reads it.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { folder, pages } from "../browser.mjs";

// How long a lab may take to go live, on a machine that has other tests to run and draws in software.
const patience = 60_000;

export const fourLabs = "1-labs/1.1-four-labs.html";
export const docked = "1-labs/1.2-docked.html";
export const trouble = "1-labs/1.3-trouble.html";

// Without the sources of MuJoCo a site has pictures in place of labs; tests/CMakeLists.txt knows these
// words.
const isLive = (page) => readFileSync(join(folder, page), "utf8").includes("data-code");
if (!pages.some(isLive)) {
  console.log("MuJoCo for the browser was not built");
  process.exit();
}

export class Lab {
  constructor(page, id) {
    this.page = page;
    this.root = page.locator(`#${id}`);
    this.canvas = this.root.locator("canvas[tabindex]");
    this.time = this.root.locator(".lab-time");
  }

  // The lab of that id, once it is live; it is scrolled to, as labs go live when they come near a reader
  // who has moved.
  static async live(page, id) {
    const lab = new Lab(page, id);
    for (const place of [4, 5]) await page.mouse.move(place, place);
    await lab.root.scrollIntoViewIfNeeded();
    const live = page.locator(`#${id}[data-live]`);
    await live.waitFor({ timeout: patience }).catch(async (error) => {
      const said = await lab.root.locator(".lab-status").allInnerTexts();
      throw new Error(`${id} does not go live, and says “${said}”`, { cause: error });
    });
    await lab.settle();
    return lab;
  }

  button(name) {
    return this.root.getByRole("button", { name, exact: true });
  }

  async press(name) {
    await this.button(name).click();
    await this.settle();
  }

  // What was done is shown in the next frame.
  async settle() {
    await this.page.evaluate(async () => {
      for (let frame = 0; frame < 3; ++frame) await new Promise(requestAnimationFrame);
    });
  }

  async seconds() {
    return Number.parseFloat(await this.time.innerText());
  }

  // Resolves once it has played for some time from where it is.
  async runs() {
    const before = await this.seconds();
    const moved = ([id, from]) =>
      Number.parseFloat(document.querySelector(`#${id} .lab-time`).textContent) > from;
    const id = await this.root.getAttribute("id");
    await this.page.waitForFunction(moved, [id, before], { timeout: patience });
  }

  // Whether it stands still, as far as can be seen in half a second.
  async rests() {
    const before = await this.seconds();
    await this.page.waitForTimeout(500);
    return (await this.seconds()) === before;
  }

  async reading(label) {
    const rows = this.root.locator(".lab-live .readouts > div");
    const row = rows.filter({
      has: this.page.locator("dt", { hasText: new RegExp(`^${label}$`) }),
    });
    return row.locator(".value").innerText();
  }

  // The overlays whose boxes are checked, as one text.
  async shown() {
    return (await this.root.locator(".lab-shown label:has(:checked)").allInnerTexts()).join(" ");
  }

  // All of them, as one text.
  async readings() {
    return (await this.root.locator(".lab-live .readouts .value").allInnerTexts()).join(" ");
  }

  // Opens the editor and pastes `mjcf` over all that is there.
  async edit(mjcf) {
    const details = this.root.locator(".lab-edit");
    if ((await details.getAttribute("open")) === null) await details.locator("summary").click();
    const field = this.root.getByRole("textbox", { name: /^MJCF of/ });
    await field.focus();
    await this.page.keyboard.press("Control+A");
    await field.evaluate((element, text) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData("text/plain", text);
      const options = { clipboardData, bubbles: true, cancelable: true };
      element.dispatchEvent(new ClipboardEvent("paste", options));
    }, mjcf);
  }

  // The live picture.
  async picture() {
    await this.settle();
    return this.canvas.evaluate((canvas) => canvas.toDataURL());
  }
}
