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
  await program.button("Edit and run yours: examples/fall.cpp").waitFor();
  program = await Program.open(page);
  expect((await program.text()).includes(mine), "a reload loses the text");
  expect(await program.button("Reset to the lesson’s").isEnabled(), "it cannot be reset");
  return program;
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

// Another reader opens the link: nothing runs, and nothing of their own is lost.
async function opensLinked(page, expect) {
  const program = new Program(page, "example-fall");
  await program.button("Fetch the compiler").click();
  await program.says("Ready to run.");
  expect((await program.text()).includes(mine), "a link does not bring its text");
  expect((await program.printed()) === "", "a link runs a program");
  await program.button("Close").click();
  const name = await program.button(/^Edit and run/).textContent();
  expect(name === "Edit and run", "a link’s text is taken for the reader’s own");
}

await testPrograms(async (visitor) => {
  const expect = (good, what) => visitor.expect(good, fallPage, what);
  let link = "";
  await visitor.visit(fallPage, options, async (page) => {
    const program = await survivesAReload(page, expect);
    link = await copiesALink(page, program, expect);
    await takesAlong(page, program, expect);
    await forgets(page, program, expect);
  });
  const { hash } = new URL(link);
  await visitor.visit(fallPage + hash, options, (page) => opensLinked(page, expect));
  const broken = `${hash.slice(0, -9)}_`;
  await visitor.visit(fallPage + broken, options, async (page) => {
    const program = new Program(page, "example-fall");
    await program.button("Fetch the compiler").click();
    await program.says("Ready to run.");
    expect((await program.text()).includes("seconds = 0.5;"), "a broken link spoils the program");
  });
});
