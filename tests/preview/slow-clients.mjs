// A client that opens connections to a preview and leaves them, sends a byte a second, or reads no
// answer, holds up nobody else; and Ctrl-C ends the preview all the same. One that sends without an
// end takes none of its memory.
//
//   node tests/preview/slow-clients.mjs MJCOURSE

import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const course = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const lesson = join(course, "content/0-a/0.1-x.md");
const seconds = 10; // of each wait; it takes a hundredth of that

const failures = [];
const expect = (good, what) => good || failures.push(what);

mkdirSync(join(course, "content/0-a"), { recursive: true });
writeFileSync(
  join(course, "content/course.yaml"),
  "title: C\nlevels:\n  - {folder: 0-a, title: A, lessons: [0.1-x]}\n",
);
const write = (word) => writeFileSync(lesson, `---\ntitle: T\n---\n\nThe word is ${word}.\n`);
write("before");

const words = ["preview", "--course", course, "--store", join(course, "store")];
const preview = spawn(resolve(process.argv[2]), words, { stdio: ["ignore", "pipe", "pipe"] });
let said = "";
for (const stream of [preview.stdout, preview.stderr]) {
  stream.on("data", (text) => (said += text));
}
const pause = (milliseconds) => new Promise((waited) => setTimeout(waited, milliseconds));
for (let i = 0; i < 600 && !/http:\/\/127\.0\.0\.1:\d+\//.test(said); ++i) await pause(50);
const root = /http:\/\/127\.0\.0\.1:\d+\//.exec(said)[0];
const { port } = new URL(root);

const clients = [];
function open(begin, later) {
  const client = connect(Number(port), "127.0.0.1");
  client.on("error", () => {}); // it is closed on us
  client.write(begin);
  const timer = later && setInterval(() => client.writable && client.write(later), 1000);
  clients.push(() => {
    clearInterval(timer);
    client.destroy();
  });
  return client;
}
const get = (path) => `GET /${path} HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\n`;

// The page, once it has `word`.
async function pageWith(word) {
  for (let i = 0; i < seconds * 20; ++i) {
    const answer = await fetch(`${root}0-a/0.1-x.html`, {
      signal: AbortSignal.timeout(seconds * 1000),
    });
    if ((await answer.text()).includes(`The word is ${word}.`)) return true;
    await pause(50);
  }
  return false;
}

const megabyte = Buffer.alloc(1 << 20, "x");
const megabytes = 300;
const peak = () =>
  Number(/VmHWM:\s+(\d+) kB/.exec(readFileSync(`/proc/${preview.pid}/status`, "utf8"))[1]) / 1024;

// Sends `head` and a body for as long as it is taken; gives the status of the answer.
async function flood(head, chunk = megabyte) {
  const client = connect(Number(port), "127.0.0.1");
  client.setMaxListeners(0);
  let answer = "";
  let over = false;
  client.on("data", (bytes) => (answer += bytes));
  for (const end of ["error", "close"]) client.on(end, () => (over = true));
  client.write(head);
  // What is not read by then comes to nobody.
  for (let i = 0; i < 20 && answer === ""; ++i) await pause(50);
  for (let i = 0; i < megabytes && !over; ++i) {
    if (client.write(chunk)) continue;
    await Promise.race([once(client, "drain"), once(client, "close"), pause(1000)]).catch(() => {});
  }
  client.destroy();
  return Number(/^HTTP\/1\.1 (\d+)/.exec(answer)?.[1]);
}

async function floods() {
  const before = peak();
  const length = `Content-Length: ${megabytes << 20}\r\n\r\n`;
  const head = (method) => get("").replace("GET", method);
  const foreign = `Origin: http://evil.example\r\n`;
  expect((await flood(head("POST") + foreign + length)) === 403, "a foreign body is not refused");
  for (const method of ["POST", "PUT", "PATCH", "DELETE"]) {
    expect((await flood(head(method) + length)) === 405, `${method} is not refused`);
  }
  const chunk = Buffer.concat([Buffer.from("100000\r\n"), megabyte, Buffer.from("\r\n")]);
  const chunked = "Transfer-Encoding: chunked\r\n\r\n";
  expect((await flood(head("POST") + chunked, chunk)) === 405, "chunks are not refused");
  expect((await flood(get("") + length)) === 200, "a page does not come to who sends a body");
  const grown = peak() - before;
  expect(grown < 100, `bodies took ${Math.round(grown)} MB`);
}

try {
  expect(await pageWith("before"), "there is no page");
  await floods();
  for (let i = 0; i < 100; ++i) {
    open(`${get(".preview/events")}\r\n`).pause(); // and nothing of it is read
    if (i < 30) open("");
    else if (i < 70) open(get(""), "X");
    else open(`${get("0-a/0.1-x.html")}\r\n`.repeat(200)).pause();
  }
  await pause(500);
  expect(await pageWith("before"), "the page does not come beside slow connections");
  const events = await fetch(`${root}.preview/events`);
  const reader = events.body.getReader();
  await reader.read(); // the version that is
  write("after");
  const news = await Promise.race([reader.read(), pause(seconds * 1000)]);
  expect(/^data: \d+/.test(Buffer.from(news?.value ?? []).toString()), "no news of the edit");
  expect(await pageWith("after"), "the edit does not show");
  await reader.cancel();
} catch (error) {
  failures.push(String(error));
}
// Those that send a byte a second are still there.
preview.kill("SIGINT");
const ended = once(preview, "exit").then(() => true);
expect(await Promise.race([ended, pause(seconds * 1000).then(() => false)]), "it does not end");
preview.kill("SIGKILL");
for (const close of clients) close();
rmSync(course, { recursive: true });
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exit(failures.length > 0 ? 1 : 0);
