// A link brings another reader to the very same state, once they have agreed; what does not fit does no
// harm; "reset all" undoes all of it. Nothing of a link is unpacked before, and what would hold up the
// page or end it is refused while the page goes on.

import { deflateRawSync, inflateRawSync } from "node:zlib";

import { testSite } from "../browser.mjs";
import { fourLabs, Lab } from "./lab.mjs";

// It ends the page that compiles it. What else is refused, run-trial.mjs tries.
const grains =
  '<composite type="particle" count="17 17 17" spacing=".1"><geom size=".05"/></composite>';
const endless = `<mujoco><worldbody><body pos="0 0 1">${grains}</body></worldbody></mujoco>`;

const linkOf = (id, bytes, json) =>
  `${fourLabs}?lab=2.${id}.${bytes}.${deflateRawSync(JSON.stringify(json)).toString("base64url")}#${id}`;
const withModel = (mjcf) => linkOf("lab-4", mjcf.length, { mjcf });

// Keeps what a page may do with a link: unpack it, or hand it to a worker.
function watch(page) {
  return page.addInitScript(() => {
    globalThis.touched = [];
    for (const name of ["DecompressionStream", "Worker"]) {
      const original = globalThis[name];
      globalThis[name] = function (...given) {
        globalThis.touched.push(name);
        return new original(...given);
      };
    }
  });
}

async function leaves(page, expect) {
  const lab = await Lab.live(page, "lab-1");
  await lab.press("Leave it");
  expect((await lab.root.locator(".lab-offer").count()) === 0, "it asks when it was left");
  expect(!page.url().includes("lab="), "the address still speaks of a link that was left");
  expect((await lab.seconds()) === 0, "a link that was left moves the lab");
  const focused = await page.evaluate(() => document.activeElement.ariaLabel);
  expect(focused === "Play", `after that the focus is on “${focused}”`);
}

async function takesAModel(page, mjcf, expect) {
  const lab = await Lab.live(page, "lab-4");
  const words = await lab.root.locator(".lab-offer p").first().innerText();
  const expected =
    "The link brings a state of this lab, and a model that somebody else may have written: " +
    `${mjcf.length} bytes of MJCF.`;
  expect(words === expected, `of a link with a model it says ${words}`);
  expect((await lab.reading("bodies")) === "2", "a model comes before its reader agrees");
  await lab.press("Load it");
  await lab.root.locator(".lab-offer").waitFor({ state: "detached" });
  expect((await lab.reading("bodies")) === "1", "the link’s model does not come");
}

// Keeps how many bytes the largest array has that a page draws from.
function weigh(page) {
  return page.addInitScript(() => {
    globalThis.largest = 0;
    const { prototype } = WebGL2RenderingContext;
    const { bufferData } = prototype;
    prototype.bufferData = function (target, data, ...rest) {
      globalThis.largest = Math.max(globalThis.largest, data?.byteLength ?? 0);
      return bufferData.call(this, target, data, ...rest);
    };
  });
}

// A model may ask for any fineness: what is seen is drawn.
async function drawsNoFiner(page, expect) {
  const lab = await Lab.live(page, "lab-4");
  await lab.press("Load it");
  await lab.root.locator(".lab-offer").waitFor({ state: "detached" });
  await lab.press("One step");
  const largest = await page.evaluate(() => globalThis.largest);
  const bounded = largest > 0 && largest < 4e6;
  expect(bounded, `for a shape as fine as can be, ${largest} bytes are drawn from`);
}

// And the page lives on, as the lesson gave it.
async function refuses(page, id, why, expect) {
  const lab = await Lab.live(page, id);
  await page.evaluate(() => {
    globalThis.beats = 0;
    setInterval(() => ++globalThis.beats, 10);
  });
  await lab.press("Load it");
  const status = lab.root.locator(".lab-offer [role=status]");
  await status.filter({ hasText: "It was not loaded" }).waitFor();
  const words = await status.innerText();
  const reason = words.replace("It was not loaded: ", "");
  expect(why.test(reason), `of what is refused as ${why} it says ${words}`);
  expect((await page.evaluate(() => globalThis.beats)) > 0, "the page stood still meanwhile");
  await lab.press("Leave it");
  await lab.press("One step");
  expect((await lab.seconds()) === 0.005, "the lab is not as the lesson gave it");
}

// A state of the lab with a shadow, which would have a year to catch up.
async function fromTheFuture(visitor) {
  let address;
  const options = { permissions: ["clipboard-read", "clipboard-write"] };
  await visitor.visit(fourLabs, options, async (page) => {
    const lab = await Lab.live(page, "lab-3");
    await lab.press("One step");
    address = await copied(lab, "Copy a link to this state");
  });
  const [, packed] = /\.([\w-]+)#/.exec(address);
  const json = JSON.parse(inflateRawSync(Buffer.from(packed, "base64url")));
  const state = Buffer.from(json.run.run.state, "base64url");
  state.writeDoubleLE(3e7, 0);
  json.run.run.state = state.toString("base64url");
  return linkOf("lab-3", 0, json);
}

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
  await visitor.visit(path, { before: watch }, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    const words = await lab.root.locator(".lab-offer p").first().innerText();
    const characters = new URL(link).searchParams.get("lab").length;
    const expected = `The link brings a state of this lab that somebody else has left: ${characters} characters.`;
    expect(words === expected, words);
    expect((await lab.seconds()) === 0, "a link moves the lab before its reader agrees");
    const touched = await page.evaluate(() => globalThis.touched);
    expect(touched.length === 0, `before its reader agrees, a link is given to ${touched}`);
    await lab.press("Load it");
    await lab.time.filter({ hasText: "0.100 s" }).waitFor();
    expect((await lab.picture()) === picture, "the link brings another view");
    let again = await state(lab);
    await lab.press("Ten steps");
    again += ` then ${await state(lab)}`;
    expect(again === seen, `the link brings ${again}, not ${seen}`);
    expect((await lab.root.locator(".lab-offer").count()) === 0, "it still asks when it is loaded");
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

  await visitor.visit(path, {}, (page) => leaves(page, expect));

  for (const value of ["", "1AAAA", "2.lab-9.0.AAAA", "%"]) {
    await visitor.visit(`${fourLabs}?lab=${value}#lab-1`, {}, async (page) => {
      const lab = await Lab.live(page, "lab-1");
      expect((await lab.seconds()) === 0, `?lab=${value} moves the lab`);
      expect((await lab.root.locator(".lab-offer").count()) === 0, `?lab=${value} is offered`);
    });
  }

  const own = '<mujoco><worldbody><body><joint/><geom size="1"/></body></worldbody></mujoco>';
  await visitor.visit(withModel(own), {}, (page) => takesAModel(page, own, expect));
  const all = '<geom size="1"/><geom type="box" size="1 1 1"/><geom type="capsule" size="1 1"/>';
  const fine = '<quality numslices="14000" numstacks="14000" numquads="9000"/>';
  const finest = `<mujoco><visual>${fine}</visual><worldbody>${all}</worldbody></mujoco>`;
  await visitor.visit(withModel(finest), { before: weigh }, (page) => drawsNoFiner(page, expect));
  // On a slow machine its time ends first.
  const noMemory =
    /^(its model does not compile: the page has no memory left for this model|it was not ready after 10 seconds)\.$/;
  await visitor.visit(withModel(endless), {}, (page) => refuses(page, "lab-4", noMemory, expect));
  const late = await fromTheFuture(visitor);
  await visitor.visit(late, {}, (page) =>
    refuses(page, "lab-3", /^it was not ready after 10 seconds\.$/, expect),
  );
});
