// What proves who asks a shared store is told to nobody but its server: no name, password, token or
// key is in what a command prints or leaves, whatever is wrong with them, and wherever they stand.
//
//   node tests/store/secrets.mjs MJCOURSE [CASE]

import { spawn } from "node:child_process";
import { globSync, mkdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { freePort, strange } from "./servers.mjs";
import { expect, finish, machine, mjcourse, test } from "./shared_machines.mjs";

// Each part by itself, as a wrong reader may find one.
const secrets = ["zaphod", "beeble", "brox", "heartofgold", "slartibart", "fast"];
const address = (scheme, slash, place) => `${scheme}://zaphod:beeble${slash}brox@${place}`;

// What a command ends with, what it says on both streams, and in which files it left a secret.
async function ran(words, environment = {}) {
  const there = machine();
  const settings = join(there.folder, "settings");
  const left = join(there.folder, "left");
  for (const folder of [left, join(settings, "mjcourse")]) mkdirSync(folder, { recursive: true });
  const { SETTINGS, ...others } = environment;
  if (SETTINGS) writeFileSync(join(settings, "mjcourse", "config.yaml"), SETTINGS);
  const env = { ...process.env, XDG_CONFIG_HOME: settings, ...others };
  const all = words(there, left);
  const child = spawn(mjcourse, all, { env, cwd: there.folder });
  let out = "";
  let err = "";
  child.stdout.on("data", (bytes) => (out += bytes));
  child.stderr.on("data", (bytes) => (err += bytes));
  const status = await new Promise((done) => child.on("close", done));
  const told = secrets.filter((one) => (out + err).includes(one));
  const files = globSync("{left,store}/**", { cwd: there.folder }).filter((file) => {
    const path = join(there.folder, file);
    const text = statSync(path).isFile() ? readFileSync(path, "latin1") : "";
    return secrets.some((one) => (file + text).includes(one));
  });
  const what = `${all.join(" ")}: ${JSON.stringify(environment)}`;
  expect(told.length === 0, `${what} says ${told}: ${out}${err}`);
  expect(files.length === 0, `${what} leaves a secret in ${files}`);
  return { status, out, err: err.replaceAll(settings, "SETTINGS") };
}

const places = (there) => ["--course", there.place, "--store", there.store];
const commands = {
  check: (there, left) => [
    ...["check", ...places(there), "--timings", "--trace", join(left, "trace.json")],
    ...["--report", join(left, "report")],
  ],
  json: (there) => ["check", "--format", "json", ...places(there)],
  junit: (there) => ["check", "--format", "junit", ...places(there)],
  github: (there) => ["check", "--format", "github", ...places(there)],
  sarif: (there) => ["check", "--format", "sarif", ...places(there)],
  explain: (there) => ["explain", ...places(there)],
  "explain --json": (there) => ["explain", "--json", ...places(there)],
  push: (there) => ["store", "push", ...places(there)],
  pull: (there) => ["store", "pull", ...places(there)],
};
const doctor = (there) => ["doctor", "--store", there.store];
const notes = ({ err }) =>
  err
    .split("\n")
    .filter((line) => line.startsWith("note: "))
    .join();
const shared = ({ out }) => out.split("\n").find((line) => / shared +/.test(line));

const otherAt =
  "the address of a shared store has no @ but the one that ends its name and password: write any other as %40, and in these two / as %2F, ? as %3F and # as %23, or put them into ~/.netrc, or a token into MJCOURSE_STORE_TOKEN";

await test("written as it should be", async () => {
  const seen = new Set();
  const server = await strange(({ headers }) => {
    seen.add(headers.authorization);
    return { status: 401 };
  });
  const place = server.url.slice("http://".length);
  const environment = { MJCOURSE_STORE_URL: address("http", "%2F", `${place}/`) };
  const refused = "it answers with 401; is MJCOURSE_STORE_TOKEN, or ~/.netrc, right?";
  const said = `note: the shared store at ${server.url} is not used from here on: ${refused}`;
  for (const [name, words] of Object.entries(commands)) {
    const told = notes(await ran(words, environment));
    if (name === "push") continue; // there is nothing to be put
    expect(told === said, `${name} says ${told}`);
  }
  const line = shared(await ran(doctor, environment));
  expect(line === `note  shared    ${server.url}: it answers with 401`, `doctor says ${line}`);
  const basic = `Basic ${Buffer.from("zaphod:beeble/brox").toString("base64")}`;
  expect([...seen].join() === basic, `the server got ${[...seen]}`);
  seen.clear();
  await ran(doctor, {
    MJCOURSE_STORE_URL: server.url,
    MJCOURSE_STORE_TOKEN: "heartofgold",
  });
  expect([...seen].join() === "Bearer heartofgold", `the server got ${[...seen]}`);
  await server.stop();
});

for (const slash of ["/", "?", "#", "@", "/@"]) {
  await test(`not written so, ${slash}`, async () => {
    const url = address("https", slash, "127.0.0.1:1/");
    for (const [name, words] of Object.entries(commands)) {
      if (name === "push" || name === "pull" || (slash !== "/" && name !== "explain")) continue;
      const told = notes(await ran(words, { MJCOURSE_STORE_URL: url }));
      expect(told === `note: no shared store is used: ${otherAt}`, `${name} says ${told}`);
    }
    const transfer = await ran(commands.pull, { MJCOURSE_STORE_URL: url });
    const cure = "set it right, or unset it";
    expect(
      transfer.status === 2 && transfer.err === `mjcourse: ${otherAt}\n  cure: ${cure}\n`,
      `pull says ${transfer.err}`,
    );
    const line = shared(await ran(doctor, { MJCOURSE_STORE_URL: url }));
    expect(line === `note  shared    ${otherAt}`, `doctor says ${line}`);
    const option = await ran((there) => [...doctor(there), "--store-url", url]);
    expect(
      option.status === 2 &&
        option.err ===
          `mjcourse: --store-url: ${otherAt}\n\`mjcourse doctor --help\` shows what it takes\n`,
      `--store-url: ${option.err}`,
    );
    const settings = await ran(doctor, { SETTINGS: `store: "${url}"\n` });
    expect(
      settings.err.startsWith(
        `SETTINGS/mjcourse/config.yaml:1: error: ${otherAt} [E-user-config]\n  cure: write it as https://store.example/course\n`,
      ),
      `the settings: ${settings.err}`,
    );
  });
}

await test("in another place", async () => {
  const url = address("https", "/", "127.0.0.1:1/");
  for (const [words, says] of [
    [["doctor", "--store", url], "--store takes a folder, not an address; --store-url takes one"],
    [["check", "--course", url], "--course takes a folder, not an address"],
    [["check", url], "check takes only options, not https://…@127.0.0.1:1/"],
    [
      ["check", `--store_url=${url}`],
      "check has no option --store_url; did you mean `--store-url`?",
    ],
  ]) {
    const { status, err } = await ran(() => words);
    const more = `\`mjcourse ${words[0]} --help\` shows what it takes`;
    expect(status === 2 && err === `mjcourse: ${says}\n${more}\n`, `${words}: ${err}`);
  }
  const { err } = await ran(doctor, { SETTINGS: `${url}: 1\n` });
  expect(
    err.startsWith(
      "SETTINGS/mjcourse/config.yaml:1: error: the settings file has no key `https://…@127.0.0.1:1/` [E-user-config]\n",
    ),
    `the settings: ${err}`,
  );
});

// libcurl repeats the whole of an address that it cannot read.
await test("proxies", async () => {
  const port = await freePort();
  const wrong =
    "does not hold the address of a proxy: in a name or password, write / as %2F, ? as %3F, # as %23 and @ as %40";
  for (const [variable, scheme, proxy] of [
    ["https_proxy", "https", address("http", "/", "127.0.0.1:1")],
    ["HTTPS_PROXY", "https", address("http", "/", "[127.0.0.1:1")],
    ["http_proxy", "http", "http://zaphod:12/brox@127.0.0.1:1"],
    ["all_proxy", "http", "zaphod:beeble@br@ox"],
    ["ALL_PROXY", "https", address("sock", "%2F", "127.0.0.1:1")],
  ]) {
    const { out } = await ran(doctor, {
      MJCOURSE_STORE_URL: `${scheme}://127.0.0.1:${port}`,
      [variable]: proxy,
    });
    const says = `note  shared    ${scheme}://127.0.0.1:${port}: ${variable} ${wrong}`;
    expect(shared({ out }) === says, `${variable}: ${shared({ out })}`);
  }
  // One that is written as it should be is told of by its place.
  const { out } = await ran(doctor, {
    MJCOURSE_STORE_URL: "http://store.example",
    http_proxy: address("http", "%2F", `127.0.0.1:${port}`),
  });
  const says = new RegExp(
    `^note  shared    http://store.example: Failed to connect to 127.0.0.1 port ${port} after \\d+ ms: Couldn't connect to server$`,
  );
  expect(says.test(shared({ out })), `a proxy that is down: ${shared({ out })}`);
});

// What a variable should name a file of may stand in it instead.
await test("what is no file", async () => {
  for (const name of ["CERTIFICATE", "KEY", "AUTHORITIES", "SIGNING_KEY"]) {
    const variable = `MJCOURSE_STORE_${name}`;
    for (const value of ["slartibart-fast", "-----BEGIN KEY-----\nslartibart\nfast\n"]) {
      const environment = { MJCOURSE_STORE_URL: "http://127.0.0.1:1", [variable]: value };
      const says = `${variable} does not name a file that can be read`;
      const { err } = await ran(commands.explain, environment);
      expect(err === `note: no shared store is used: ${says}\n`, `${variable}: ${err}`);
      const line = shared(await ran(doctor, environment));
      expect(line === `note  shared    ${says}`, `${variable}: ${line}`);
    }
  }
});

finish();
