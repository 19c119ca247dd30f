// What a reader takes along builds and runs: each zip is unpacked, built as its README says, with nothing
// set, and prints what the page shows. That takes seconds for each, so one that did is not built again
// before it, what is shown of it, a tool, a library or this test changes.
//
//   node tests/site/programs-to-build.mjs SITE [SHARES]
//
// With SHARES, one of so many shares is built (sample.mjs), and each zip that has changed since one of its
// name was built here.

import { execFileSync, spawnSync } from "node:child_process";
import { globSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";

import { sampleOf } from "../sample.mjs";
import { Stamps } from "../stamps.mjs";
import { folder, pagesWith, testSite } from "./browser.mjs";

const stamps = new Stamps("built");
const ask = (...words) => execFileSync(words[0], words.slice(1), { encoding: "utf8" });
const packages = ["libmujoco-dev", "libeigen3-dev", "libosmesa6-dev", "libc6-dev"];
const tools = [
  ...["c++", "cmake"].map((tool) => ask(tool, "--version")),
  ask("dpkg-query", "--show", ...packages),
  readFileSync(import.meta.filename),
];

// The listings with a zip, and what is printed below them, if anything is.
function listings() {
  return [...document.querySelectorAll(".example:has(figcaption a[href$='.zip'])")].map(
    (figure) => ({
      zip: new URL(figure.querySelector("a[href$='.zip']").href).pathname,
      label: figure.querySelector(".output-label")?.textContent,
      printed: [...figure.querySelectorAll("samp")].map((part) => part.textContent).join(""),
    }),
  );
}

// Below it there is nothing but rounding, which every optimiser does otherwise.
const noise = 1e-12;

// What is no number must be the same, and numbers to one unit in their last place: the reader's program is
// optimised, and the lesson's is not.
function agree(printed, shown) {
  const number = /-?\d+\.(\d+)(?:e([+-]\d+))?/g;
  if (printed.replace(number, "#") !== shown.replace(number, "#")) return false;
  const stated = [...shown.matchAll(number)];
  return (printed.match(number) ?? []).every((text, i) => {
    const [wanted, decimals, exponent = 0] = stated[i];
    const unit = 10 ** (Number(exponent) - decimals.length);
    return Math.abs(Number(text) - Number(wanted)) < Math.max(1.5 * unit, noise);
  });
}

const environment = { PATH: process.env.PATH, HOME: process.env.HOME };

// Unpacks, builds and runs it; gives what came of it.
function tryOut(zip, place) {
  const run = (...words) => execFileSync(words[0], words.slice(1), { cwd: place, stdio: "pipe" });
  run("unzip", "-q", join(folder, zip));
  const inside = join(place, basename(zip, ".zip"));
  const readme = readFileSync(join(inside, "README.txt"), "utf8").trimEnd().split("\n");
  if (readme.length !== 3) throw new Error(`README.txt has ${readme.length} lines`);
  const [build, start] = readme[2].split(", then ");
  const options = { cwd: inside, env: environment, encoding: "utf8" };
  execFileSync("sh", ["-ec", build], { ...options, stdio: "pipe" });
  return spawnSync("sh", ["-c", start], options);
}

// Says whether the starter of an exercise ends by itself, with words about its checks alone.
function failsACheck(zip, complaints, status, visitor) {
  const others = complaints.replace(/^(?:\[[ x]\] | {4}).*\n/gm, "");
  const fails = /^\[ \] /m.test(complaints);
  return [
    visitor.expect(status === 0, zip, `ends with ${status}`),
    visitor.expect(others === "", zip, others),
    visitor.expect(fails, zip, "its starter fails no check"),
  ].every(Boolean);
}

// Says whether it prints what each page shows of it.
function compare(zip, outputs, visitor) {
  const place = mkdtempSync(join(tmpdir(), "mjcourse-"));
  try {
    const { stdout, stderr, status } = tryOut(zip, place);
    // A lesson may show how a simulation breaks.
    const complaints = stderr.replace(/^(?:MuJoCo|model\.xml:) warning: .*\n+/gm, "");
    if (zip.startsWith("exercises/")) return failsACheck(zip, complaints, status, visitor);
    // A solution's checks hold.
    const others = complaints.replace(/^\[x\] .*\n/gm, "");
    let good = visitor.expect(others === "", zip, others);
    for (const { path, label, printed } of outputs) {
      const code = Number(/exits with code (\d+)/.exec(label)?.[1] ?? 0);
      const where = `${zip} of ${path}`;
      good = visitor.expect(status === code, where, `ends with ${status}`) && good;
      good = visitor.expect(agree(stdout, printed), where, `prints\n${stdout}`) && good;
    }
    return good;
  } finally {
    rmSync(place, { recursive: true });
  }
}

await testSite(async (visitor) => {
  const shown = new Map();
  for (const path of pagesWith('.zip"')) {
    await visitor.visit(path, { javaScript: false }, async (page) => {
      for (const { zip, label, printed } of await page.evaluate(listings)) {
        const [, file] = /\/((?:examples|snippets|exercises)\/.*)$/.exec(zip);
        const known = shown.get(file) ?? [];
        shown.set(file, label ? [...known, { path, label, printed }] : known);
      }
    });
  }
  const zips = globSync("{examples,snippets,exercises}/**/*.zip", { cwd: folder }).sort();
  visitor.expect(zips.length > 0, folder, "there is no program to build");
  const lost = zips.filter((zip) => !shown.has(zip));
  visitor.expect(lost.length === 0, folder, `${lost} have no links`);
  const dead = [...shown.keys()].filter((zip) => !zips.includes(zip));
  visitor.expect(dead.length === 0, folder, `${dead} are not there`);
  const sample = sampleOf(Number(process.argv[3] ?? 1));
  let built = 0;
  for (const zip of zips) {
    const outputs = shown.get(zip) ?? [];
    const bytes = readFileSync(join(folder, zip));
    const stamp = Stamps.of(...tools, bytes, JSON.stringify(outputs));
    const former = Stamps.of(...tools, zip);
    if (stamps.has(stamp) || !(sample.has(zip) || stamps.has(former))) continue;
    if (compare(zip, outputs, visitor)) for (const good of [stamp, former]) stamps.put(good, zip);
    ++built;
  }
  const proved = [...shown.values()].flat().length;
  visitor.expect(proved > 0, folder, "no output was compared");
  console.log(`${zips.length} programs, ${built} built; ${proved} outputs compared`);
});
