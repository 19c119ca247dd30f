// Whatever a server of a shared store does instead of what it should, each check ends as it would
// without one, with one note.
//
//   node tests/store/remote_faults.mjs MJCOURSE [CASE]
//
// A third of the cases, which the commit chooses (sample.mjs), or those whose names have CASE in them.

import { spawn, spawnSync } from "node:child_process";
import { mkdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";

import { sampleOf } from "../sample.mjs";
import {
  all,
  asked,
  expect,
  expectRight,
  finish,
  home,
  machine,
  mjcourse,
  test,
} from "./shared_machines.mjs";
import { haproxy, lighttpd, nginx, nginxWithToken, strange } from "./servers.mjs";

const sample = asked === "" ? sampleOf(3) : { has: () => true };
const trial = async (name, run) => sample.has(name) && (await test(name, run));

await trial("no token", async () => {
  const server = await nginxWithToken(join(home, "no-token"));
  const without = { ...server, environment: { ...server.environment, MJCOURSE_STORE_TOKEN: "x" } };
  const { notes, anew } = await expectRight("no token", machine(), without);
  expect(anew.join() === all.join(), `no token: works out ${anew}`);
  const said = `note: the shared store at ${server.url} is not used from here on: it answers with 401; is MJCOURSE_STORE_TOKEN, or ~/.netrc, right?`;
  expect(notes.join("\n") === said, `no token: says ${notes}`);
  expect(server.entries().length === 0, "without the token, something was put");
  await server.stop();
});

await trial("down", async () => {
  const server = await nginx(join(home, "down"));
  await server.stop();
  const { notes } = await expectRight("down", machine(), server);
  expect(notes.length === 1 && notes[0].includes("is not used from here on: "), `down: ${notes}`);
});

await trial("killed", async () => {
  const server = await nginx(join(home, "killed"));
  const running = expectRight("killed", machine(), server);
  await pause(300);
  await server.stop();
  const { notes } = await running;
  expect(notes.length <= 1, `killed: ${notes}`);
});

// Whatever lies there after a client was killed in the middle of what it put, nobody believes it.
for (const start of [nginx, lighttpd]) {
  await trial(`killed client, ${start.name}`, async () => {
    const server = await start(join(home, `killed-client-${start.name}`));
    for (let i = 0; i < 50; ++i) {
      const { place, store } = machine();
      const words = ["check", "--course", place, "--store", store, "--store-url", server.url];
      const child = spawn(mjcourse, words, { stdio: "ignore" });
      const gone = new Promise((done) => child.on("close", done));
      await pause(100 + Math.random() * 400);
      child.kill("SIGKILL");
      await gone;
    }
    await expectRight("after 50 clients were killed", machine(), server);
    const { anew, notes } = await expectRight("after that", machine(), server);
    expect(anew.length === 0 && notes.length === 0, `works out ${anew}, and says ${notes}`);
    await server.stop();
  });
}

await trial("haproxy", async () => {
  const behind = await nginx(join(home, "behind"));
  const proxy = await haproxy(join(home, "haproxy"), behind);
  for (let i = 0; i < 5; ++i) {
    const { notes, seconds } = await expectRight("by haproxy", machine(), proxy);
    expect(notes.length <= 1, `by haproxy: says ${notes}`);
    expect(seconds < 60, `by haproxy: takes ${seconds} s`);
  }
  await proxy.stop();
  const { notes } = await expectRight("after haproxy", machine(), behind);
  expect(notes.length === 0, `after haproxy: says ${notes}`);
  await behind.stop();
});

// Of a server whose disk is full, which takes root to make.
await trial("full disk", async () => {
  const folder = join(home, "full-disk");
  mkdirSync(folder);
  const words = ["-t", "tmpfs", "-o", "size=4m", "tmpfs", folder];
  if (spawnSync("mount", words).status !== 0)
    return console.log("full disk: nothing can be mounted");
  try {
    const server = await nginx(folder);
    const rest = join(folder, "rest");
    spawnSync("dd", ["if=/dev/zero", `of=${rest}`, "bs=4k"], { stdio: "ignore" });
    for (let i = 0; i < 2; ++i) {
      const { notes, anew } = await expectRight("full disk", machine(), server);
      expect(anew.join() === all.join(), `full disk: works out ${anew}`);
      const says = /is read and not written from here on: it answers with 5\d\d/;
      expect(notes.length === 1 && says.test(notes[0]), `full disk: says ${notes}`);
    }
    rmSync(rest);
    const { notes } = await expectRight("full disk, cleared", machine(), server);
    expect(notes.length === 0, `full disk, cleared: says ${notes}`);
    await server.stop();
  } finally {
    spawnSync("umount", [folder]);
  }
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
  endless: {
    of: ({ found }) => ({ status: 200, bytes: Buffer.alloc(1 << 20), length: found ? 1e12 : 0 }),
    says: "an answer of it is larger than any entry",
  },
  silent: { of: () => undefined, says: "is not used from here on" },
  "500 twice": { of: ({ usual }, n) => (n <= 2 ? { status: 500 } : usual), says: "" },
  "always 500": { of: () => ({ status: 500 }), says: "not used from here on: it answers with 500" },
  forbidden: { of: () => ({ status: 403 }), says: "not used from here on: it answers with 403" },
  slow: { of: async ({ usual }) => (await pause(30_000), usual), says: "is not used from here on" },
};
for (const [name, { of, says }] of Object.entries(faults)) {
  await trial(name, async () => {
    let broken = false;
    let answers = 0;
    const server = await strange((request) => (broken ? of(request, ++answers) : request.usual));
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

// Three such answers can come one after the other, since many are asked for at once.
await trial("every third 500", async () => {
  const server = await strange(({ usual }, n) => (n % 3 === 0 ? { status: 500 } : usual));
  for (let i = 0; i < 3; ++i) {
    const { notes } = await expectRight("every third 500", machine(), server);
    const known = / (not used|read and not written) from here on: it answers with 500$/;
    const good = notes.length === 0 || (notes.length === 1 && known.test(notes[0]));
    expect(good, `every third 500: says ${notes}`);
  }
  await server.stop();
});

// A server of which one may read, and which does not take what is put.
for (const [status, why] of [
  [403, "it answers with 403"],
  [405, "it answers with 405"],
  [507, "it answers with 507"],
]) {
  await trial(`put ${status}`, async () => {
    const server = await strange(({ method, usual }) => (method === "PUT" ? { status } : usual));
    const { notes, anew } = await expectRight(`put ${status}`, machine(), server);
    expect(anew.join() === all.join(), `put ${status}: works out ${anew}`);
    const good =
      notes.length === 1 && notes[0].includes(`is read and not written from here on: ${why}`);
    expect(good, `put ${status}: says ${notes}`);
    await server.stop();
  });
}

finish();
