// From a program to a lab and back: a reader looks at where their run ended, and opens the state of a lab
// as a program.
//
//   node tests/site/cpp/labs.mjs SITE
//
// The site is that of tests/site/cpp/course.

import { testPrograms } from "./compiler.mjs";
import { fallPage, Program } from "./program.mjs";

const look = "Look at where it ended";

// The lab opens at the program's last snapshot, and simulates from there.
async function looksAtTheEnd(page, program, expect) {
  const button = program.button(look);
  expect(!(await button.isVisible()), "a lab is offered before there was a run");
  await program.run();
  await button.click();
  const lab = page.locator("#example-fall-ended[data-live]");
  await lab.waitFor();
  expect(!(await button.isVisible()), "the lab is offered twice");
  const time = lab.locator(".lab-time");
  expect((await time.innerText()) === "0.500 s", `the lab is at ${await time.innerText()}`);
  const chosen = await lab.getByLabel("Snapshot").locator("option:checked").innerText();
  expect(chosen === "end", `it shows the snapshot ${chosen}`);
  expect((await colours(lab)) > 10, "nothing is seen in it");
  await lab.getByRole("button", { name: "One step", exact: true }).click();
  await time.filter({ hasText: "0.502 s" }).waitFor();
  return lab;
}

// How many there are in what is drawn.
function colours(lab) {
  return lab.locator("canvas").evaluate(async (canvas) => {
    await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });
}

async function opensState(page, lab, name, expect) {
  await lab.getByRole("button", { name: "copy", exact: true }).click();
  await lab.getByRole("button", { name: "Open the state as a program" }).click();
  const program = new Program(page, `program-${name}`);
  await program.says("Ready to run.");
  const text = await program.text();
  expect(text.includes('load_model("ball")'), `it is of another model:\n${text}`);
  return { program, text };
}

async function comesFromTheEnd(page, lab, expect) {
  const name = "state_of_example_fall_ended";
  const { program, text } = await opensState(page, lab, name, expect);
  expect(text.includes("data->time = 0.502"), `it begins at another time:\n${text}`);
  const said = await program.run();
  expect(said === "It ran to the end.", said);
  const printed = await program.printed();
  expect(/^t = 1\.50[24] s\nqpos\[0\] = 0\n/.test(printed), `it prints ${printed}`);
  expect(await program.button(look).isVisible(), "its end cannot be looked at");
  await program.button("Close").click();
}

// The next run is not beside the former one's end.
async function goesWithTheRun(page, program, expect) {
  await program.run();
  expect((await page.locator("#example-fall-ended").count()) === 0, "the former run's lab stays");
}

// Of a model that is no file, but a text of the program.
async function looksAtAMadeModel(page, program, expect) {
  await program.write(`#include <mjcourse/mjcourse.hpp>

int main() {
  const mjcourse::Model model = mjcourse::load_model_xml(
      "<mujoco><worldbody><body><joint type='slide'/><geom size='0.3'/></body></worldbody></mujoco>");
  const mjcourse::Data data = mjcourse::make_data(model);
  for (int i = 0; i < 50; ++i) mj_step(model, data);
  mjcourse::snapshot("made", model, data);
  data->qpos[0] = std::nan("");
  mjcourse::snapshot("broken", model, data);
}
`);
  await program.run();
  await program.button(look).click();
  await program.says("Left out: “broken”, which has numbers that are not finite");
  const lab = page.locator("#example-fall-ended[data-live]");
  await lab.waitFor();
  const time = await lab.locator(".lab-time").innerText();
  expect(time === "0.100 s", `the lab of the made model is at ${time}`);
  await program.button("Reset to the lesson’s").click();
}

async function comesFromALab(page, expect) {
  const lab = page.locator("sim-lab[data-module]");
  await lab.getByRole("button", { name: "Play" }).first().click();
  await lab.getByRole("button", { name: "Pause" }).first().click();
  await lab.getByRole("button", { name: "Back to the start" }).click();
  await lab.getByRole("button", { name: "Push", exact: true }).click();
  const id = await lab.getAttribute("id");
  const name = `state_of_${id.replaceAll("-", "_")}`;
  const { program } = await opensState(page, lab, name, expect);
  await program.run();
  const printed = await program.printed();
  expect(/^t = 1\.00[02] s\nqpos\[0\] = 1\.50?3?\n/.test(printed), `it prints ${printed}`);
  await program.write('#include <cstdio>\n\nint main() { std::puts("mine"); }\n');
  await program.run();
  expect((await program.printed()) === "mine\n", `then it prints ${await program.printed()}`);
  await program.button("Reset to the lab’s").click();
  await program.says("This is the lab’s program again.");
}

await testPrograms(async (visitor) => {
  await visitor.visit(fallPage, {}, async (page) => {
    const expect = (good, what) => visitor.expect(good, fallPage, what);
    const program = await Program.open(page);
    const lab = await looksAtTheEnd(page, program, expect);
    await comesFromTheEnd(page, lab, expect);
    await goesWithTheRun(page, program, expect);
    await looksAtAMadeModel(page, program, expect);
    await comesFromALab(page, expect);
  });
});
