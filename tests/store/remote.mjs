// Machines that share a store: what one has found out, the other does not do again, whichever server
// it is behind. And whatever a server does instead, each check ends as it would without one, with one
// note.
//
//   node tests/store/remote.mjs MJCOURSE [CASE]

import { spawn, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import {
  appendFileSync,
  cpSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";

import { lighttpd, nginx, nginxAtSocket, nginxWithToken, strange, token } from "./servers.mjs";

const [mjcourse, asked = ""] = process.argv.slice(2);
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
let failed = 0;
let cases = 0;

function expect(good, what) {
  if (good) return;
  ++failed;
  console.error(what);
}

function write(folder, path, text) {
  mkdirSync(dirname(join(folder, path)), { recursive: true });
  writeFileSync(join(folder, path), text);
}

const course = join(home, "course");
write(
  course,
  "content/course.yaml",
  "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b]}\n",
);
write(
  course,
  "models/ball.xml",
  '<mujoco><worldbody><light pos="0 0 3"/><body name="ball" pos="0 0 1"><freejoint/>' +
    '<geom size="0.1"/></body></worldbody></mujoco>\n',
);
write(
  course,
  "content/1-a/1.1-b.md",
  `---
title: B
---

The ball has \`{ball} model.nv :.0f\` degrees of freedom.

\`\`\`figure
{"model": "ball", "alt": "A ball.", "size": [160, 100]}
\`\`\`

\`\`\`lab simlab
{
  "title": "A ball",
  "model": "ball",
  "alt": "A ball in the air",
  "controls": [{"type": "button", "label": "Kick", "run": "data.qvel[0] = 1"}]
}
\`\`\`
`,
);
// What takes long, and depends on hundreds of headers.
const program = `
\`\`\`cpp snippet model=ball
std::cout << model->nq << '\\n';
\`\`\`

\`\`\`text
7
\`\`\`
`;

// A machine has a place of its own for the course and for its store.
let machines = 0;
function machine(more = "") {
  const folder = join(home, `machine-${++machines}`);
  const place = join(folder, "x".repeat(machines), "course");
  cpSync(course, place, { recursive: true });
  appendFileSync(join(place, "content/1-a/1.1-b.md"), more);
  return { folder, place, store: join(folder, "store") };
}

// Checks the course there; gives what was worked out, and what was said.
async function check(there, server, ...more) {
  const trace = join(there.folder, "trace.json");
  const words = ["check", "--course", there.place, "--store", there.store, "--trace", trace];
  if (server?.url) words.push("--store-url", server.url);
  const environment = { ...process.env, ...server?.environment };
  const child = spawn(mjcourse, [...words, ...more], { env: environment });
  let said = "";
  for (const stream of [child.stdout, child.stderr]) stream.on("data", (bytes) => (said += bytes));
  const begin = Date.now();
  const status = await new Promise((done) => child.on("close", done));
  const seconds = (Date.now() - begin) / 1000;
  const { traceEvents } = JSON.parse(readFileSync(trace, "utf8"));
  const anew = traceEvents.filter((event) => event.cat === "worked").map((event) => event.name);
  const notes = said.split("\n").filter((line) => line.startsWith("note: "));
  return { status, said, anew: anew.sort(), notes, seconds };
}

const all = (await check(machine(), undefined)).anew;
const allOf = (more) =>
  more === "" ? all : [...all, "compile and run the snippets of 1.1"].sort();
expect(all.length > 3, `only ${all} is worked out`);

async function test(name, run) {
  if (!name.includes(asked)) return;
  ++cases;
  try {
    await run();
  } catch (error) {
    expect(false, `${name}: ${error.stack}`);
  }
}

// A check that ends as without a server.
async function expectRight(name, there, server, ...more) {
  const run = await check(there, server, ...more);
  expect(run.status === 0, `${name}: the check ends with ${run.status}: ${run.said}`);
  expect(!run.said.includes(token), `${name}: the token is told: ${run.said}`);
  return run;
}

for (const start of [nginx, nginxAtSocket, nginxWithToken, lighttpd]) {
  await test(start.name, async () => {
    const server = await start(join(home, start.name));
    const more = start === nginx ? program : "";
    const one = await expectRight("the first", machine(more), server);
    expect(one.anew.join() === allOf(more).join(), `the first works out ${one.anew}`);
    expect(one.notes.length === 0, `the first says ${one.notes}`);
    const names = server.entries();
    expect(names.length > all.length, `the store has ${names}`);

    const two = await expectRight("the second", machine(more), server);
    expect(two.anew.length === 0, `the second works out ${two.anew}`);
    expect(two.notes.length === 0, `the second says ${two.notes}`);
    expect(server.entries().join() === names.join(), "the second has put something");

    const other = machine(more);
    write(
      other.place,
      "models/ball.xml",
      readFileSync(join(course, "models/ball.xml"), "utf8").replace("0.1", "0.2"),
    );
    const third = await expectRight("the third", other, server, "--store-read-only");
    expect(third.anew.length > 0, "another model has the former results");
    expect(server.entries().join() === names.join(), "a reader has put something");
    await server.stop();
  });
}

// The first line of an entry, as base/store_entry.cpp has it: what stands in an address under ac/ may
// be a result or a list.
function sealOf(name, content) {
  const parts = (...all) => {
    const hash = createHash("sha256");
    for (const part of all) hash.update(`${part.length}:`).update(part);
    return hash.digest("hex");
  };
  return `mjcourse-store 2 ${parts(Buffer.from(name), content)}\n`;
}

// What another command says there, as [exit code, lines of stdout and stderr].
function say(there, server, ...words) {
  const where = ["--store", there.store, ...(server ? ["--store-url", server.url] : [])];
  const ran = spawnSync(mjcourse, [...words, ...where], {
    encoding: "utf8",
    env: { ...process.env, ...server?.environment },
  });
  return [ran.status, (ran.stdout + ran.stderr).trim().split("\n")];
}

for (const start of [nginx, nginxWithToken, lighttpd]) {
  await test(`doctor, ${start.name}`, async () => {
    const server = await start(join(home, `doctor-${start.name}`));
    const line = (more, environment = {}) => {
      const asked = { ...server, environment: { ...server.environment, ...environment } };
      const [, lines] = say(machine(), asked, "doctor", ...more);
      return lines[lines.findIndex((one) => / shared +/.test(one))].replace(/[\d.]+ ms/, "N ms");
    };
    const protocol = start === nginxWithToken ? "HTTP/2" : "HTTP/1.1";
    const begin = `shared    ${server.url}: ${protocol}, answers in N ms; is read`;
    const whole = `ok    ${begin} and written, 33.6 MB at once and perhaps more`;
    expect(line([]) === whole, `doctor says ${line([])}`);
    const names = server.entries();
    const reads = line(["--store-read-only"]);
    expect(reads === `ok    ${begin}, and nothing is put there`, `doctor says ${reads}`);
    expect(server.entries().join() === names.join(), "doctor leaves more each time");
    await server.stop();
  });
}

await test("doctor, faults", async () => {
  const faults = {
    "it answers with 403": () => ({ status: 403 }),
    "it answers with 200 to what nobody has put there": () => ({ status: 200 }),
    "takes nothing: it answers with 507": ({ method, usual }) =>
      method === "PUT" ? { status: 507 } : usual,
    "takes nothing: what is put there is not there then": ({ method, usual }) =>
      method === "PUT" ? usual : { status: 404 },
    "takes no more than 1.05 MB at once: it answers with 413": ({ sent, usual }) =>
      sent.length > 2e6 ? { status: 413 } : usual,
    "does not answer HEAD, so all is put again": ({ method, usual }) =>
      method === "HEAD" ? { status: 405 } : usual,
  };
  for (const [says, answer] of Object.entries(faults)) {
    const server = await strange(answer);
    const child = spawn(mjcourse, [
      "doctor",
      "--store",
      join(home, "d"),
      "--store-url",
      server.url,
    ]);
    let said = "";
    child.stdout.on("data", (bytes) => (said += bytes));
    await new Promise((done) => child.on("close", done));
    const line = said.split("\n").find((one) => / shared +/.test(one));
    expect(line?.endsWith(says), `doctor says ${line}, and not ${says}`);
    await server.stop();
  }
});

await test("push and pull", async () => {
  const server = await nginx(join(home, "push"));
  const one = machine();
  await expectRight("before the push", one);
  const course = (there) => ["--course", there.place];
  const [pushed, said] = say(one, server, "store", "push", ...course(one));
  const put =
    /^put (\d+) entries \(.*\) into (\S+); the disk has (\d+) of (\d+) results of this course$/;
  const [, entries, url, kept, results] = put.exec(said[0]) ?? [];
  expect(pushed === 0 && url === server.url && kept === results, `push: ${pushed} ${said}`);
  expect(server.entries().length === Number(entries), `${entries} entries are ${server.entries()}`);

  // Of another model, the same recipes: their lists are joined.
  const other = machine();
  write(
    other.place,
    "models/ball.xml",
    readFileSync(join(other.place, "models/ball.xml"), "utf8").replace(
      "<worldbody>",
      '<include file="more.xml"/><worldbody>',
    ),
  );
  write(other.place, "models/more.xml", "<mujoco><option/></mujoco>\n");
  await expectRight("another, before the push", other);
  say(other, server, "store", "push", ...course(other));

  for (const [before, name] of [
    [one, "one"],
    [other, "the other"],
  ]) {
    const there = machine();
    cpSync(before.place, there.place, { recursive: true });
    const [explained, lines] = say(
      { ...there, store: `${there.store}-e` },
      server,
      "explain",
      ...course(there),
    );
    const origin = /: kept in the shared store as ac\/[0-9a-f]{64}$/;
    expect(
      explained === 0 && lines.filter((line) => origin.test(line)).length === Number(results),
      `${name}: explain says ${lines.join("\n")}`,
    );
    const [pulled, got] = say(there, server, "store", "pull", ...course(there));
    const from =
      /^got \d+ entries \(.*\) from (\S+); the disk has (\d+) of (\d+) results of this course$/;
    const found = from.exec(got[0]) ?? [];
    expect(pulled === 0 && found[2] === results && found[3] === results, `${name}: pull: ${got}`);
    const { anew } = await expectRight("after the pull", there);
    expect(anew.length === 0, `${name}: after a pull, ${anew} is worked out`);
    const [, again] = say(there, undefined, "explain", ...course(there));
    expect(
      again.every((line) => /: kept$|kept$/.test(line)),
      `${name}: explain says ${again}`,
    );
  }
  await server.stop();
  const [down, why] = say(machine(), server, "store", "pull", ...course(one));
  expect(down === 1 && why[1].startsWith("note: the shared store at "), `down: ${down} ${why}`);
  const [none, cure] = say(machine(), undefined, "store", "push", ...course(one));
  expect(
    none === 2 &&
      cure.join("\n") ===
        "mjcourse: store push needs a shared store\n" +
          "  cure: name it: `--store-url URL`, MJCOURSE_STORE_URL in the environment, or `store: URL` in ~/.config/mjcourse/config.yaml",
    `no server: ${none} ${cure}`,
  );
});

await test("signed", async () => {
  const key = (name) => {
    const file = join(home, `key-${name}`);
    const ran = spawnSync(mjcourse, ["store", "key", file], { encoding: "utf8" });
    const [said, , digits] = ran.stdout.split("\n");
    const good = ran.status === 0 && /^[0-9a-f]{64}$/.test(digits);
    expect(good && said.startsWith(`wrote ${file}: `), `store key says ${ran.stdout}${ran.stderr}`);
    expect((statSync(file).mode & 0o777) === 0o600, "others may read a key");
    return { file, digits };
  };
  const [ours, theirs] = [key("ours"), key("theirs")];
  const again = spawnSync(mjcourse, ["store", "key", ours.file], { encoding: "utf8" });
  const refused = `mjcourse: ${ours.file}: File exists\n  cure: name a new file; a key is never replaced\n`;
  expect(again.status === 2 && again.stderr === refused, `a key twice: ${again.stderr}`);

  const server = await strange(({ usual }) => usual);
  const as = (environment) => ({ ...server, environment });
  const signing = ({ file }) => as({ MJCOURSE_STORE_SIGNING_KEY: file });
  const trusting = (...keys) =>
    as({ MJCOURSE_STORE_TRUSTED_KEYS: keys.map(({ digits }) => digits).join(",") });
  const reads = async (name, where, anew, says) => {
    const run = await expectRight(name, machine(), where, "--store-read-only");
    expect(run.anew.join() === anew.join(), `${name}: works out ${run.anew}`);
    const good =
      says === "" ? run.notes.length === 0 : run.notes.length === 1 && says.test(run.notes[0]);
    expect(good, `${name}: says ${run.notes}`);
    expect(!run.said.includes(readFileSync(ours.file, "utf8").split(" ")[1].trim()), "told a key");
  };
  const none =
    /has entries, such as ac\/[0-9a-f]{64}, that none of MJCOURSE_STORE_TRUSTED_KEYS has signed; they are made again$/;

  await expectRight("one who signs", machine(), signing(ours));
  await reads("one who trusts", trusting(ours, theirs), [], "");
  await reads("one who trusts another", trusting(theirs), all, none);
  await reads("one who trusts all", as({}), [], "");

  // Under each name lies what was signed for another, in the same words.
  const kept = new Map(server.kept);
  const entries = [...kept.keys()].filter((name) => name.startsWith("ac/"));
  entries.forEach((name, i) => server.kept.set(name, kept.get(entries[(i + 1) % entries.length])));
  await reads("exchanged", trusting(ours), all, /gave another content than/);

  // Made up by somebody who knows how: the seal is right, and the signature is of the former one.
  for (const name of entries) {
    const bytes = kept.get(name);
    const begin = bytes.indexOf("mjcourse-store ");
    const end = bytes.lastIndexOf("\x3a\x80\x01"); // field 7, of 128 bytes
    const content = Buffer.from(bytes.subarray(bytes.indexOf("\n", begin) + 1, end));
    content[content.length - 1] ^= 1;
    const seal = sealOf(name, content);
    server.kept.set(
      name,
      Buffer.concat([bytes.subarray(0, begin), Buffer.from(seal), content, bytes.subarray(end)]),
    );
  }
  await reads("made up", trusting(ours), all, none);

  server.kept.clear();
  await expectRight("one who does not sign", machine(), as({}));
  await reads("unsigned", trusting(ours), all, none);
  for (const [environment, says] of [
    [
      { MJCOURSE_STORE_TRUSTED_KEYS: "abc" },
      "note: no shared store is used: MJCOURSE_STORE_URL: MJCOURSE_STORE_TRUSTED_KEYS has a word that is no public key, which has 64 hexadecimal digits",
    ],
    [
      { MJCOURSE_STORE_SIGNING_KEY: "/none" },
      "note: no shared store is used: MJCOURSE_STORE_URL: MJCOURSE_STORE_SIGNING_KEY: /none cannot be read",
    ],
  ]) {
    const where = { url: "", environment: { ...environment, MJCOURSE_STORE_URL: server.url } };
    const { notes } = await check(machine(), where);
    expect(notes.join("\n") === says, `a wrong key: ${notes}`);
  }
  await server.stop();
});

await test("no token", async () => {
  const server = await nginxWithToken(join(home, "no-token"));
  const without = { ...server, environment: { ...server.environment, MJCOURSE_STORE_TOKEN: "x" } };
  const { notes, anew } = await expectRight("no token", machine(), without);
  expect(anew.join() === all.join(), `no token: works out ${anew}`);
  const said = `note: the shared store at ${server.url} is not used from here on: it answers with 401; is MJCOURSE_STORE_TOKEN, or ~/.netrc, right?`;
  expect(notes.join("\n") === said, `no token: says ${notes}`);
  expect(server.entries().length === 0, "without the token, something was put");
  await server.stop();
});

await test("down", async () => {
  const server = await nginx(join(home, "down"));
  await server.stop();
  const { notes } = await expectRight("down", machine(), server);
  expect(notes.length === 1 && notes[0].includes("is not used from here on: "), `down: ${notes}`);
});

await test("killed", async () => {
  const server = await nginx(join(home, "killed"));
  const running = expectRight("killed", machine(), server);
  await pause(300);
  await server.stop();
  const { notes } = await running;
  expect(notes.length <= 1, `killed: ${notes}`);
});

// A server that has all, and one fault. `says` is what its note has.
const flip = (bytes) => {
  const other = Buffer.from(bytes);
  other[Math.floor(other.length * 0.7)] ^= 4;
  return other;
};
const faults = {
  flipped: {
    of: ({ found, usual }) => (found ? { status: 200, bytes: flip(found) } : usual),
    says: "gave another content than",
  },
  truncated: {
    of: ({ found, usual, method }) =>
      found && method === "GET"
        ? { status: 200, bytes: found.subarray(0, found.length / 2), length: found.length }
        : usual,
    says: "is not used from here on",
  },
  shortened: {
    of: ({ found, usual }) =>
      found ? { status: 200, bytes: found.subarray(0, found.length / 2) } : usual,
    says: "gave another content than",
  },
  exchanged: {
    of: ({ found, usual, kept, name }) => {
      const others = [...kept.keys()].filter((one) => one.slice(0, 2) === name.slice(0, 2)).sort();
      const next = others[(others.indexOf(name) + 1) % others.length];
      return found ? { status: 200, bytes: kept.get(next) } : usual;
    },
    says: "gave another content than",
  },
  "a page for all": {
    of: ({ method }) => ({
      status: 200,
      bytes: method === "GET" ? Buffer.from("<html>") : undefined,
    }),
    says: "gave another content than",
  },
  silent: { of: () => undefined, says: "is not used from here on" },
  "500 at random": { of: ({ usual }, n) => (n % 3 === 0 ? { status: 500 } : usual), says: "" },
  "always 500": { of: () => ({ status: 500 }), says: "not used from here on: it answers with 500" },
  forbidden: { of: () => ({ status: 403 }), says: "not used from here on: it answers with 403" },
  slow: { of: async ({ usual }) => (await pause(30_000), usual), says: "is not used from here on" },
};
for (const [name, { of, says }] of Object.entries(faults)) {
  await test(name, async () => {
    let broken = false;
    const server = await strange((request, n) => (broken ? of(request, n) : request.usual));
    await expectRight(`${name}, before`, machine(), server);
    broken = true;
    const { notes, seconds } = await expectRight(name, machine(), server);
    const good = says === "" ? notes.length === 0 : notes.length === 1 && notes[0].includes(says);
    expect(good, `${name}: says ${notes}`);
    expect(seconds < 60, `${name}: takes ${seconds} s`);
    broken = false;
    const { notes: after } = await expectRight(`${name}, after`, machine(), server);
    expect(after.length === 0, `${name}, after: says ${after}`);
    await server.stop();
  });
}

// A server of which one may read, and which does not take what is put.
for (const [status, why] of [
  [403, "it answers with 403"],
  [405, "it answers with 405"],
  [507, "it answers with 507"],
]) {
  await test(`put ${status}`, async () => {
    const server = await strange(({ method, usual }) => (method === "PUT" ? { status } : usual));
    const { notes, anew } = await expectRight(`put ${status}`, machine(), server);
    expect(anew.join() === all.join(), `put ${status}: works out ${anew}`);
    const good =
      notes.length === 1 && notes[0].includes(`is read and not written from here on: ${why}`);
    expect(good, `put ${status}: says ${notes}`);
    await server.stop();
  });
}

rmSync(home, { recursive: true });
console.log(`${cases} cases, ${failed} problems`);
process.exitCode = failed === 0 ? 0 : 1;
