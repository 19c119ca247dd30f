// A machine whose disk has nothing yet, and a store that has all: how long it builds the whole course,
// and what goes over the net.
//
//   node tests/bench/shared_store.mjs MJCOURSE COURSE [DELAY]
//
// The store is nginx on loopback; a proxy in front of it delays what it answers by DELAY milliseconds
// (1). The first build fills the store, and takes as long as one without. Beside the others, the same
// build from its own disk. The last line is the JSON that tests/bench/run keeps.

import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { connect, createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { nginx } from "../store/servers.mjs";
import { measure, median } from "./measure.mjs";

const [mjcourse, course, delay = "1"] = process.argv.slice(2);
const home = mkdtempSync(join(tmpdir(), "mjcourse-bench-"));

// Passes on what comes, and what goes back a little later, in its order.
async function delaying(url) {
  const { port } = new URL(url);
  const server = createServer((client) => {
    const behind = connect(Number(port), "127.0.0.1");
    client.setNoDelay(true);
    behind.setNoDelay(true);
    client.on("data", (bytes) => behind.write(bytes));
    behind.on("data", (bytes) => setTimeout(() => client.write(bytes), Number(delay)));
    for (const [one, other] of [
      [client, behind],
      [behind, client],
    ]) {
      one.on("error", () => other.destroy()).on("close", () => other.destroy());
    }
  });
  server.listen(0, "127.0.0.1");
  await new Promise((done) => server.on("listening", done));
  return { url: `http://127.0.0.1:${server.address().port}`, stop: () => server.close() };
}

function words(name, url) {
  const out = ["--out", join(home, `site-${name}`), "--store", join(home, `store-${name}`)];
  return ["build", "--course", course, ...out, "--store-url", url];
}

if (process.env.MJCOURSE_BENCH_PROXY) {
  // The proxy is a process of its own: what measures waits for its children.
  const proxy = await delaying(process.env.MJCOURSE_BENCH_PROXY);
  console.log(proxy.url);
} else {
  const server = await nginx(join(home, "server"));
  const child = spawn(process.execPath, process.argv.slice(1), {
    env: { ...process.env, MJCOURSE_BENCH_PROXY: server.url },
    stdio: ["ignore", "pipe", "inherit"],
  });
  const url = await new Promise((done) => {
    child.stdout.once("data", (line) => done(String(line).trim()));
  });
  try {
    const cold = measure(mjcourse, words("first", server.url));
    const warm = [],
      own = [];
    for (let i = 0; i < 5; ++i) {
      warm.push(measure(mjcourse, words(`warm-${i}`, url)));
      own.push(measure(mjcourse, words(`warm-${i}`, "none")));
    }
    const told = spawnSync(mjcourse, [...words("told", url), "--timings"], { encoding: "utf8" });
    const net = /.*for the shared store.*/.exec(told.stdout)[0].trim();
    const [shared, disk] = [median(warm), median(own)];
    console.log(
      `cold ${cold.wall} s; from the shared store ${shared.wall} s, from the disk ${disk.wall} s`,
    );
    console.log(net);
    console.log(
      JSON.stringify({ name: "shared_store", delay: Number(delay), cold, shared, disk, net }),
    );
  } finally {
    child.kill();
    await server.stop();
    rmSync(home, { recursive: true });
  }
}
