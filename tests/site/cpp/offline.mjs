// The compiler is fetched once, when the reader asks for it, and programs run without a network then. Who
// keeps the whole course has it only when they ask for it, too.
//
//   node tests/site/cpp/offline.mjs SITE

import { folder, pagesWith } from "../browser.mjs";
import { launch } from "../chromium.mjs";
import { serve } from "../server.mjs";
import { until } from "../until.mjs";
import { fallPage, Program } from "./program.mjs";

const problems = [];

function expect(good, what) {
  if (!good) problems.push(what);
}

async function newReader(browser, options = {}) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  page.on("pageerror", (error) => expect(false, `script: ${error.stack}`));
  return page;
}

const hasWorker = (page) => until(page, () => navigator.serviceWorker.ready.then(() => true));
const keepsCompiler = (page) =>
  page.evaluate(async () => {
    const { llvm } = document.querySelector("[data-llvm]").dataset;
    return (await caches.match(new URL(llvm, document.baseURI).href)) !== undefined;
  });

async function worksOffline(browser) {
  const server = await serve(folder);
  const page = await newReader(browser);
  await page.goto(server.root + fallPage);
  await hasWorker(page);
  expect(!(await keepsCompiler(page)), "the compiler comes unasked");
  let program = await Program.open(page);
  const online = await program.run();
  await until(page, async () => {
    const { dataset } = document.querySelector("[data-llvm]");
    const loaded = performance.getEntriesByType("resource").map(({ name }) => name);
    const names = ["worker", "llvm", "pack", "engine", "wasm"].map((name) => dataset[name]);
    const addresses = [...loaded, ...names].map((name) => new URL(name, document.baseURI).href);
    const wanted = addresses.filter((name) => !/\/(sw\.js|edition-)/.test(name));
    const kept = await Promise.all(wanted.map((address) => caches.match(address)));
    return kept.every((response) => response !== undefined);
  });
  server.close();

  await page.reload();
  program = new Program(page, "example-fall");
  await program.button(/^Edit and run/).click();
  await program.says("Ready to run.");
  const offline = await program.run();
  expect(offline === online, `without a network: ${offline}`);
  await page.context().close();
}

async function isKeptWhenAskedFor(browser) {
  const server = await serve(folder);
  const page = await newReader(browser);
  const asked = [];
  page.context().on("request", (request) => asked.push(request.url()));
  await page.goto(`${server.root}offline.html`);
  await page.getByRole("button", { name: /^Keep the whole course/ }).click();
  await page.getByText("The whole course is kept on this device.").waitFor();
  expect(!asked.some((address) => address.includes("/llvm-")), "the compiler comes unasked");
  const button = page.getByRole("button", { name: /^Keep the C\+\+ compiler.*\(\d+\.\d MB\)$/ });
  await button.click();
  await page.getByText("Keeping the C++ compiler.").waitFor({ state: "hidden" });
  expect(await button.isHidden(), "a compiler that is kept is offered again");
  server.close();

  await page.goto(server.root + fallPage);
  const program = new Program(page, "example-fall");
  await program.button(/^Edit and run/).click();
  await program.says("Ready to run.");
  const said = await program.run();
  expect(said.startsWith("It ran to the end."), `of the whole course without a network: ${said}`);
  await page.context().close();
}

// What a reader hears who is without a network too early, and has no worker.
async function refuses(browser) {
  const server = await serve(folder);
  const page = await newReader(browser, { serviceWorkers: "block" });
  await page.context().route(/\/llvm-/, (route) => route.abort());
  await page.goto(server.root + fallPage);
  const program = new Program(page, "example-fall");
  await program.button(/^Edit and run/).click();
  await program.button("Fetch the compiler").click();
  await program.says("The compiler could not be loaded. Check the connection, then press Run.");
  await page.context().unrouteAll();
  const said = await program.run();
  expect(said.startsWith("It ran to the end."), `once there is a network again: ${said}`);
  server.close();
}

if (pagesWith("data-program=").length === 0) {
  console.log("the compiler for the browser was not built"); // then CTest skips the test
  process.exit(1);
}
const browser = await launch();
try {
  await worksOffline(browser);
  await isKeptWhenAskedFor(browser);
  await refuses(browser);
} catch (error) {
  problems.push(`the test was broken off: ${error.stack}`);
} finally {
  await browser.close();
}
for (const problem of problems) console.error(problem);
console.log(`${problems.length} problems`);
process.exit(problems.length > 0 ? 1 : 0);
