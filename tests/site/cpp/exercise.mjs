// A reader solves an exercise: the starter, a mistake, a loop without end and the solution; the hints one
// by one; the solution beside what was written. What is solved stays, counts, and is exported.
//
//   node tests/site/cpp/exercise.mjs SITE

import { readFileSync } from "node:fs";

import { testPrograms } from "./compiler.mjs";
import { exercisePage, Program } from "./program.mjs";

const id = "exercise-fallen";
const starter = "  return 0;  // t = 1 s: 4.9 m\n";
const first = "it falls 4.9 m in the first second";
const second = "twice the time is four times the way";

const checks = async (page) => {
  const items = await page.locator(`#${id} .checks li`).allInnerTexts();
  return items.map((text) => text.replace(/\s+/g, " ").trim());
};

async function startsWithTheStarter(page, expect) {
  expect((await checks(page)).join() === [first, second].join(), `${await checks(page)}`);
  const program = await Program.open(page, id);
  expect((await program.text()).includes(starter), "the editor has no starter");
  expect((await program.text()).includes("// #region answer"), "nothing marks what to write");
  expect(!(await program.text()).includes("9.81"), "the editor has the solution");
  const said = await program.run("Run and check");
  const told = "0 of 2 checks hold. “it falls 4.9 m in the first second” does not: ";
  expect(said === `${told}its speed is 9.8 m/s at the end only.`, said);
  const [top, other] = await checks(page);
  const means = "its speed is 9.8 m/s at the end only";
  expect(top.startsWith(`✗ Fails: ${first} ${means} it is 0, and should be 4.905`), top);
  expect(other === `– Was not reached: ${second}`, other);
  return program;
}

// The one that fails comes first, whatever the order in which they are made.
async function toldOfAMistake(page, program, expect) {
  await program.replace("return 0;", "return 9.81 * t / 2;");
  const said = await program.run("Run and check");
  expect(said === `1 of 2 checks holds. “${second}” does not.`, said);
  const [top, other] = await checks(page);
  expect(top.startsWith(`✗ Fails: ${second}`), top);
  expect(other === `✓ Holds: ${first}`, other);
  expect((await page.locator(".value.yours").count()) === 0, "the lesson quotes the mistake");
}

async function stopsALoop(page, program, expect) {
  await program.replace("return 9.81 * t / 2;", "while (t > 0) mju_sin(t); return t;");
  await page.keyboard.press("Control+Enter");
  await program.says("Running…");
  await program.button("Stop").click();
  await program.says("Stopped.");
  expect((await checks(page)).join() === [first, second].join(), "marks stay after a stop");
}

async function showsTheSolution(page, program, expect) {
  await program.button("Compare with the solution").click();
  await program.says("The solution stands beside what you wrote.");
  const beside = program.root.locator(".solution-beside");
  const solution = beside.getByLabel("What you wrote and the lesson’s solution");
  await solution.waitFor();
  const text = (await solution.innerText()).trim();
  expect(text.includes("return 9.81 * t * t / 2;"), text);
  expect(!text.includes("#wrong") && !text.includes("main"), `more than the region: ${text}`);
  expect((await beside.locator(".cm-changedText").count()) > 0, "no difference is marked");
}

async function isSolved(page, program, expect) {
  await program.replace("while (t > 0) mju_sin(t); return t;", "return 9.81 * t * t / 2;");
  const said = await program.run("Run and check");
  expect(said === "Solved: all 2 checks hold.", said);
  expect(
    (await checks(page)).join() === [`✓ Holds: ${first}`, `✓ Holds: ${second}`].join(),
    `${await checks(page)}`,
  );
  expect(!(await program.root.locator(".solution-beside").isVisible()), "the comparison is old");
  await program.button("Close").click();
  await page.reload();
  await page.locator(`#${id} .solved`).getByText("Solved").waitFor();
  await program.button(/^Go on with your version/).waitFor();
}

async function hintsComeOneByOne(page, expect) {
  const hints = page.locator(".callout.hint");
  const seen = async () =>
    (await hints.evaluateAll((all) => all.map((one) => one.checkVisibility()))).join();
  expect((await seen()) === "true,false", `hints seen: ${await seen()}`);
  await hints.first().locator("summary").click();
  expect((await seen()) === "true,true", `then: ${await seen()}`);
}

// To another browser, with the text.
async function travels(visitor, page, expect) {
  await page.goto(new URL("../progress.html", page.url()).href);
  const row = page.locator("tr[data-lesson*='1.3-exercise'] .right-answers");
  expect((await row.innerText()) === "1 of 1", `progress counts ${await row.innerText()}`);
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Export" }).click();
  const file = await (await download).path();
  const { lessons } = JSON.parse(readFileSync(file, "utf8"));
  const { texts } = lessons[exercisePage];
  expect(texts["exercises/fallen.cpp"].includes("return 9.81 * t * t / 2;"), "the text stays here");
  await visitor.visit("progress.html", {}, async (other) => {
    await other.locator("input[type=file]").setInputFiles(file);
    await other.getByText("Imported: lessons 1.").waitFor();
    await other.goto(new URL(exercisePage, other.url()).href);
    await other.locator(`#${id} .solved`).getByText("Solved").waitFor();
    const program = await Program.open(other, id);
    expect((await program.text()).includes("return 9.81 * t * t / 2;"), "the text is lost");
  });
}

// A day later, by the reader's clock.
async function comesAgain(page, expect) {
  await page.clock.setFixedTime(Date.now() + 2 * 86_400_000);
  await page.goto(new URL("review.html", page.url()).href);
  await page.getByText("1 due today, 0 later.").waitFor();
  const link = page.locator(".exercise-again a");
  expect((await link.innerText()) === "How far it falls", await link.innerText());
  await page.getByRole("button", { name: "Not today" }).click();
  await page.getByText("Nothing is due today.").waitFor();
  await link.click();
  expect(page.url().endsWith(`#${id}`), `the card leads to ${page.url()}`);
}

await testPrograms(async (visitor) => {
  const expect = (good, what) => visitor.expect(good, exercisePage, what);
  await visitor.visit(exercisePage, {}, async (page) => {
    await hintsComeOneByOne(page, expect);
    const program = await startsWithTheStarter(page, expect);
    await toldOfAMistake(page, program, expect);
    await stopsALoop(page, program, expect);
    await showsTheSolution(page, program, expect);
    await isSolved(page, program, expect);
    await travels(visitor, page, expect);
    await comesAgain(page, expect);
  });
  // Without scripts it is the text, the zip, and what to do in a terminal.
  await visitor.visit(exercisePage, { javaScriptEnabled: false }, async (page) => {
    const listing = page.locator(`#${id}`);
    expect((await listing.locator("pre.code").innerText()).includes("return 0;"), "no starter");
    await listing.getByText("mjcourse try 1.3 fallen").waitFor();
    expect((await listing.locator("a.zip").count()) === 1, "there is no zip");
  });
});
