// What a lab asks: a guess before the run, a goal, a number of the model that the reader edited. And
// the shadow of a ghost.

import { testSite } from "../browser.mjs";
import { fourLabs, Lab } from "./lab.mjs";

await testSite(async (visitor) => {
  const expect = (good, what) => visitor.expect(good, fourLabs, what);
  await visitor.visit(fourLabs, {}, async (page) => {
    await tryPrediction(await Lab.live(page, "lab-2"), expect);
    await tryGoal(await Lab.live(page, "lab-2"), expect);
    await tryGhost(await Lab.live(page, "lab-3"), expect);
    await tryEditor(await Lab.live(page, "lab-4"), expect);
  });
});

async function tryPrediction(lab, expect) {
  const { root } = lab;
  const field = root.getByRole("textbox");
  const answer = root.locator(".lab-predict [role=status]");
  const guess = async (text) => {
    await field.fill(text);
    await field.press("Enter");
  };
  await guess("fast");
  expect((await answer.innerText()).includes("not a number"), "fast is a number");
  for (const [text, verdict] of [
    ["2", "Not quite."],
    ["0,4", "Right."],
  ]) {
    await guess(text);
    await answer.getByText(verdict, { exact: true }).waitFor({ timeout: 30_000 });
    const words = await answer.innerText();
    expect(words.includes(`${text} m/s`) && words.includes("0.381 m/s"), `it says ${words}`);
    expect((await lab.seconds()) === 0.5, "it does not stop where the value was measured");
  }
}

async function tryGoal(lab, expect) {
  const goal = lab.root.locator(".lab-goal [role=status]");
  expect((await goal.innerText()) === "not yet", `the goal is ${await goal.innerText()}`);
  await lab.root.getByRole("slider", { name: "Motor" }).fill("1");
  await lab.button("Play").first().click();
  await goal.filter({ hasText: "there" }).waitFor({ timeout: 30_000 });
  await lab.press("Back to the start");
  expect((await goal.innerText()) === "there", "a goal that was reached is forgotten");
}

async function tryGhost(lab, expect) {
  expect(await lab.root.getByText("shadow: no gravity").isVisible(), "the shadow has no name");
  await lab.press("Tilted");
  for (let i = 0; i < 5; ++i) await lab.press("Ten steps");
  const latest = lab.root.locator(".lab-plot tbody td:first-of-type");
  const [own, shadow] = await latest.allTextContents();
  expect(own !== shadow, `pole and shadow are both at ${own}`);
  expect(shadow === "0.8000", `without gravity the pole is at ${shadow}`);
}

async function tryEditor(lab, expect) {
  const { root } = lab;
  const status = root.locator(".lab-edit-status");
  await lab.edit('<mujoco>\n<worldbody>\n<body>\n<geom sizee="1"/>\n</body></worldbody></mujoco>');
  await status.filter({ hasText: "Line 4" }).waitFor({ timeout: 30_000 });
  expect((await status.innerText()).includes("`size`"), `no cure: ${await status.innerText()}`);
  expect((await lab.reading("mass")) === "1.00", "what does not compile takes the model away");

  const body = '<body><freejoint/><geom size="0.1" mass="4.25"/></body>';
  await lab.edit(`<mujoco><worldbody>${body}</worldbody></mujoco>`);
  await root.locator(".lab-live .value", { hasText: "4.25" }).waitFor({ timeout: 30_000 });
  expect((await status.innerText()) === "", "the old error stays");
  const field = root.locator(".lab-task").getByRole("textbox");
  for (const [text, verdict] of [
    ["1", "Not yet: try again."],
    ["4.25", "Right."],
  ]) {
    await field.fill(text);
    await field.press("Enter");
    const said = await root.locator(".lab-task [role=status]").innerText();
    expect(said === verdict, `to ${text} it says ${said}`);
  }

  // A model without what is read is a model; what cannot be read of it is said.
  await lab.edit("<mujoco/>");
  const alert = root.getByRole("alert");
  await alert.filter({ hasText: "This cannot be read" }).waitFor({ timeout: 30_000 });
  const words = await alert.innerText();
  expect(words.includes("model.body_mass[1] is out of range 0..0"), `the alert says ${words}`);
  await lab.press("The first text again");
  expect((await alert.innerText()) === "", "the alert stays");
  expect((await lab.reading("mass")) === "1.00", "the lesson's model does not come back");
}
