// What a reader wrote stays: over a reload, in a link, in the zip that they take along.
//
//   node tests/site/cpp/keep.mjs SITE

import { execFileSync } from "node:child_process";

import { testPrograms } from "./compiler.mjs";
import { fallPage, Program } from "./program.mjs";

const options = { permissions: ["clipboard-read", "clipboard-write"] };
const mine = "seconds = 0.25;";

async function survivesAReload(page, expect) {
  let program = await Program.open(page);
  await program.replace("seconds = 0.5;", mine);
  await program.button("Close").click();
  await page.reload();
  program = new Program(page, "example-fall");
  await program.button("Edit and run your version: examples/fall.cpp").waitFor();
  program = await Program.open(page);
  expect((await program.text()).includes(mine), "a reload loses the text");
  expect(await program.button("Reset to the lesson’s").isEnabled(), "it cannot be reset");
  return program;
}

// Also what was typed a moment ago, with the characters that are the site's keys elsewhere.
async function keepsEachCharacter(page, program, expect) {
  await program.editor.focus();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("// a[0] ? 1/2");
  await page.reload();
  const again = await Program.open(page);
  const [first] = (await again.text()).split("\n");
  expect(first.startsWith("// a[0] ? 1/2"), `the first line is ${first}`);
  return again;
}

async function copiesALink(page, program, expect) {
  await program.button("Copy link").click();
  await program.says("The link is copied.");
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(/#run:examples\/fall\.cpp:1[\w-]+$/.test(link), `the link is ${link}`);
  return link;
}

async function takesAlong(page, program, expect) {
  const download = page.waitForEvent("download");
  await program.root.getByRole("link", { name: "Zip to build" }).click();
  const file = await (await download).path();
  execFileSync("unzip", ["-tq", file]);
  const inside = (name) =>
    execFileSync("unzip", ["-p", file, `fall/${name}`], { encoding: "utf8" });
  expect(inside("fall.cpp").includes(mine), "the zip has the lesson’s text");
  expect(inside("models/ball.xml").includes("<freejoint/>"), "the zip lacks the model");
  expect(inside("CMakeLists.txt").includes("fall.cpp"), "the zip cannot be built");
  expect((await download).suggestedFilename() === "fall.zip", "the zip has another name");
}

async function forgets(page, program, expect) {
  await program.button("Reset to the lesson’s").click();
  await page.reload();
  const name = await program.button(/^Edit and run/).textContent();
  expect(name === "Edit and run", `after a reset it is “${name}”`);
}

// Another reader opens the link: nothing runs before they say so, also where they thought it over.
async function opensLinked(page, expect) {
  const program = new Program(page, "example-fall");
  const words =
    /^The link brought a text of this program, packed in \d\.\d kB, that somebody else may have written\. To run/;
  await program.root.getByText(words).waitFor();
  await program.button("Not now").click();
  await program.button(/^Edit and run/).click();
  await program.button("Fetch the compiler").click();
  await program.says("Ready to run. This is the text that the link brought.");
  expect((await program.text()).includes(mine), "a link does not bring its text");
  expect((await program.printed()) === "", "a link runs a program");
  await program.button("Close").click();
  const name = await program.button(/^Edit and run/).textContent();
  expect(name === "Edit and run", "a link’s text is taken for the reader’s own");
}

// Where the compiler is here already, nothing is fetched, and the link's text is asked for all the same.
async function asksBeforeItOpens(page, address, expect) {
  await page.evaluate(async () => {
    const { llvm } = document.querySelector("#example-fall").dataset;
    const cache = await caches.open("a test's");
    await cache.put(new URL(llvm, document.baseURI).href, new Response(""));
  });
  await page.goto("about:blank");
  await page.goto(address);
  const program = new Program(page, "example-fall");
  await program.button("Open the link’s text").waitFor();
  await page.waitForLoadState("networkidle");
  expect((await program.editor.count()) === 0, "a link’s text is opened unasked");
  const focused = await page.evaluate(() => document.activeElement.localName);
  expect(focused === "body", `a link takes the focus to a ${focused}`);
  await page.evaluate(() => caches.delete("a test's"));
}

// In a tab that has nothing open.
async function openLink(page, address) {
  await page.goto("about:blank");
  await page.goto(address);
  const linked = new Program(page, "example-fall");
  const agree = linked.button("Fetch the compiler");
  await agree
    .or(linked.status.filter({ hasText: /./ }))
    .first()
    .waitFor();
  if (await agree.isVisible()) await agree.click();
  await linked.says("Ready to run. This is the text that the link brought.");
  return linked;
}

// A reader who has a text of their own keeps it; one without keeps what they make of the link's.
async function losesNothing(page, address, expect) {
  const own = await Program.open(page);
  await own.replace("seconds = 0.5;", "seconds = 0.75;");
  await own.button("Close").click();
  const linked = await openLink(page, address);
  await linked.says("as you have a text of your own");
  await linked.replace(mine, "seconds = 0.125;");
  await linked.button("Close").click();
  const again = await Program.open(page);
  expect((await again.text()).includes("seconds = 0.75;"), "a link takes one’s own text’s place");
  await again.button("Reset to the lesson’s").click();
}

async function becomesOnesOwn(page, address, expect) {
  const linked = await openLink(page, address);
  await linked.replace(mine, "seconds = 0.125;");
  await page.waitForURL((url) => url.hash === "");
  await page.reload();
  const again = await Program.open(page);
  expect((await again.text()).includes("seconds = 0.125;"), "the link’s text as changed is lost");
}

await testPrograms(async (visitor) => {
  const expect = (good, what) => visitor.expect(good, fallPage, what);
  let link = "";
  await visitor.visit(fallPage, options, async (page) => {
    const first = await survivesAReload(page, expect);
    const program = await keepsEachCharacter(page, first, expect);
    link = await copiesALink(page, program, expect);
    await takesAlong(page, program, expect);
    await forgets(page, program, expect);
  });
  const { hash } = new URL(link);
  await visitor.visit(fallPage, options, async (page) => {
    const address = page.url() + hash;
    await losesNothing(page, address, expect);
    await becomesOnesOwn(page, address, expect);
    await asksBeforeItOpens(page, address, expect);
  });
  await visitor.visit(fallPage + hash, options, (page) => opensLinked(page, expect));
  const broken = `${hash.slice(0, -9)}_`;
  await visitor.visit(fallPage + broken, options, async (page) => {
    const program = new Program(page, "example-fall");
    await program.button("Fetch the compiler").click();
    await program.says("Ready to run. The text of the link could not be read");
    expect((await program.text()).includes("seconds = 0.5;"), "a broken link spoils the program");
  });
});
