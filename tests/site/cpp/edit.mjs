// A reader edits a lesson's program and runs it: what it prints beside what the lesson's printed, values
// of the text that follow, errors and warnings at their places, and a loop without end that is stopped.
//
//   node tests/site/cpp/edit.mjs SITE
//
// The site is that of tests/site/cpp/course.

import { testPrograms } from "./compiler.mjs";
import { fallPage, Program, wordsPage } from "./program.mjs";

const values = (page) => page.locator("p .value").allInnerTexts();

async function runsAsTheLesson(page, expect) {
  const program = await Program.open(page);
  const said = await program.run();
  expect(said === "It ran to the end. It printed what the lesson’s printed.", said);
  const printed = await program.printed();
  expect(printed === "time: 0.500 s\nheight: 0.769 m\n", `it prints ${printed}`);
  expect((await page.locator(".value.yours").count()) === 0, "the lesson’s values are marked");
  return program;
}

async function differs(page, program, expect) {
  await program.replace("seconds = 0.5", "seconds = 0.25");
  const said = await program.run();
  expect(
    /^It ran to the end\. 2 lines of its output are not the lesson’s\. 2 values/.test(said),
    said,
  );
  const marked = await program.root.locator(".output.yours mark").allInnerTexts();
  expect(marked.map((line) => line.trim()).join() === "time: 0.250 s,height: 1.691 m", `${marked}`);
  const [height, steps, bodies] = await values(page);
  expect([height, steps, bodies].join() === "1.69,125,2", `the text has ${height} and ${steps}`);
  const title = await page.locator(".value.yours").first().getAttribute("title");
  expect(title === "from your run of fall.cpp; the lesson’s has 0.77", title);
  await page.locator(".plot.yours").getByText("Computed by your run.").waitFor();
  expect(!(await plotTexts(page)).includes("0.4"), "the plot's time goes on to 0.5 s");
}

// What stands in the drawing of the plot that is seen: the numbers of its axes.
function plotTexts(page) {
  return page
    .locator(".plot svg[role]:visible")
    .evaluate((drawing) => [...drawing.querySelectorAll("text")].map((text) => text.textContent));
}

async function resets(page, program, expect) {
  await program.button("Reset to the lesson’s").click();
  await program.says("This is the lesson’s program again.");
  expect((await values(page)).join() === "0.77,250,2", "the lesson’s values do not come back");
  expect((await page.locator(".value.yours, .plot.yours").count()) === 0, "marks stay");
  expect((await plotTexts(page)).includes("0.4"), "the plot is not the lesson’s again");
  expect((await program.printed()) === "", "what was printed stays");
  expect((await program.text()).includes("seconds = 0.5;"), "the text is not the lesson’s");
}

async function complains(page, program, expect) {
  await program.replace("mj_step(model, data);", "mj_step(model, undeclared);");
  const said = await program.run();
  expect(said === "It does not compile: 1 error.", said);
  const marked = () => program.root.locator(".cm-lintRange-error").allInnerTexts();
  expect((await marked()).join() === "undeclared", `${await marked()} is marked`);
  const printed = await program.printed();
  expect(/^fall\.cpp:\d+:\d+: error: .*undeclared/.test(printed), printed);
  await program.button("Reset to the lesson’s").click();
  expect((await marked()).length === 0, "the mark stays when the error is gone");
}

async function warns(page, program, expect) {
  await program.replace("int main() {", "int main() {\n  int unused = 7;");
  const said = await program.run();
  expect(said === "It ran to the end. It printed what the lesson’s printed.", said);
  const marked = await program.root.locator(".cm-lintRange-warning").allInnerTexts();
  expect(marked.join() === "unused", `${marked} is marked`);
}

// What came before stays, and the next run is as good as the first.
async function stops(page, program, expect) {
  await program.replace("int unused = 7;", 'std::puts("begins");\n  while (true) mju_sin(1);');
  await page.keyboard.press("Control+Enter");
  await program.root.locator(".output.yours").getByText("begins").waitFor();
  await program.says("Running…");
  expect(await program.button("Run").isDisabled(), "it can be run twice at once");
  await program.button("Stop").click();
  await program.says("Stopped.");
  expect(
    (await program.printed()) === "begins\n",
    `then it has printed ${await program.printed()}`,
  );
  await program.button("Reset to the lesson’s").click();
  const said = await program.run();
  expect(
    said === "It ran to the end. It printed what the lesson’s printed.",
    `after a stop: ${said}`,
  );
}

// The line where it was ended is marked, and its own warnings stay.
async function crashes(page, program, expect) {
  await program.replace("int main() {", 'int main() {\n  int unused;\n  mju_error("too far");');
  const said = await program.run();
  expect(/^MuJoCo ended it \(line \d+\): too far\. 2 lines of the lesson/.test(said), said);
  const marked = (kind) => program.root.locator(`.cm-lintRange-${kind}`).allInnerTexts();
  expect((await marked("error")).join() === 'mju_error("too far");', `${await marked("error")}`);
  expect((await marked("warning")).join() === "unused", `${await marked("warning")} is marked`);
  await program.replace('mju_error("too far");', "while (true) mju_malloc(1 << 24);");
  const full = await program.run();
  expect(/^It wants more memory than a program has in a page \(line \d+\)/.test(full), full);
  await program.button("Reset to the lesson’s").click();
}

// Two bytes at a time, up to the bound; its page marks some of the lines and says what came of it.
async function floods(page, program, expect) {
  const flood = 'setvbuf(stdout, nullptr, _IONBF, 0);\n  while (true) std::puts("x");';
  await program.replace("int main() {", `int main() {\n  ${flood}`);
  const said = await program.run();
  expect(
    /^It was ended, since it prints without end\. \d+ lines of its output are/.test(said),
    said,
  );
  const { length } = await program.printed();
  expect(length === 1 << 20, `it shows ${length} characters`);
  const marked = await program.root.locator(".output.yours mark").count();
  expect(marked === 1000, `${marked} lines are marked`);
  await program.button("Reset to the lesson’s").click();
}

// Of a part of the program, all of it is edited; one editor at a time.
async function edits(page, expect) {
  const part = new Program(page, "example-fall-falling");
  await part.button(/^Edit and run/).click();
  await part.says("Ready to run.");
  expect((await part.text()).includes("int main()"), "only a part is edited");
  expect(!(await part.text()).includes("#region"), "its marks are shown");
  expect((await page.getByRole("textbox").count()) === 1, "there are two editors of one program");
  await part.button("Close").click();
  const name = await page.evaluate(() => document.activeElement.ariaLabel);
  expect(name === "Edit and run: examples/fall.cpp", `the focus is on ${name}`);
  expect(await part.root.locator(".code").isVisible(), "the listing does not come back");
}

// Of a snippet, too: with the lines that the lesson hides, and from its own first line on.
async function editsSnippet(page, expect) {
  const snippet = await Program.open(page, "snippet_1_1_1");
  const text = await snippet.text();
  expect(text.includes("  const double seconds = 0.1;\n  while (data->time"), `it edits ${text}`);
  const same = await snippet.run();
  expect(same === "It ran to the end. It printed what the lesson’s printed.", same);
  await snippet.replace("seconds = 0.1;", "seconds = 0.3;");
  const other = await snippet.run();
  expect(other === "It ran to the end. 1 line of its output is not the lesson’s.", other);
  expect((await snippet.printed()) === "0.30 s\n", `it prints ${await snippet.printed()}`);
  await comparesAsTheBuild(snippet, expect);
}

// With what stands for any text, and a unit of the last place; and a line may be missing.
async function comparesAsTheBuild(snippet, expect) {
  await snippet.replace("seconds = 0.3;", "seconds = 0.11;");
  const same = await snippet.run();
  expect((await snippet.printed()) === "0.11 s\n", `it prints ${await snippet.printed()}`);
  expect(same === "It ran to the end. It printed what the lesson’s printed.", same);
  await snippet.replace('std::printf("%.2f s\\n", data->time);', "");
  const none = await snippet.run();
  expect(none === "It ran to the end. 1 line of the lesson’s output is missing.", none);
}

await testPrograms(async (visitor) => {
  await visitor.visit(fallPage, {}, async (page) => {
    const expect = (good, what) => visitor.expect(good, fallPage, what);
    const program = await runsAsTheLesson(page, expect);
    await differs(page, program, expect);
    await resets(page, program, expect);
    await complains(page, program, expect);
    await warns(page, program, expect);
    await stops(page, program, expect);
    await crashes(page, program, expect);
    await floods(page, program, expect);
    await edits(page, expect);
    await editsSnippet(page, expect);
  });
  await visitor.visit(wordsPage, {}, async (page) => {
    const program = await Program.open(page, "example-words");
    const said = await program.run();
    visitor.expect(
      said.startsWith("It ended with exit code 3, as in the lesson."),
      wordsPage,
      said,
    );
    const printed = await program.printed();
    visitor.expect(printed === "1: one\n2: two\n", wordsPage, `it prints ${printed}`);
    const buttons = await page.locator(".edit-program").count();
    visitor.expect(buttons === 1, wordsPage, `${buttons} programs can be edited`);
  });
});
