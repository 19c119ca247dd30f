// Where a result is from: what a machine took from a server without a signature is believed for as long
// as it trusts no keys, and never signed or sent on; nor is what it made of that.
//
//   node tests/store/origins.mjs MJCOURSE [CASE]

import { spawnSync } from "node:child_process";
import { globSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { readSealed, sealOnItsWay } from "./sealed.mjs";
import { nginx, strange } from "./servers.mjs";
import {
  all,
  allOf,
  expect,
  expectRight,
  finish,
  home,
  machine,
  mjcourse,
  program,
  say,
  test,
} from "./shared_machines.mjs";

function key(name) {
  const file = join(home, `key-${name}`);
  const ran = spawnSync(mjcourse, ["store", "key", file], { encoding: "utf8" });
  return { file, digits: ran.stdout.split("\n")[2] };
}
const [ours, theirs] = [key("ours"), key("theirs")];
const trusting = (...keys) => ({
  MJCOURSE_STORE_TRUSTED_KEYS: keys.map(({ digits }) => digits).join(","),
});
const signing = ({ file }) => ({ MJCOURSE_STORE_SIGNING_KEY: file });
const nowhere = (environment) => ({ url: "none", environment });
const usual = () => strange((request) => request.usual);

// What is said of entries that are not believed.
const doubt =
  /^note: the store has results, such as (ac|list)\/[0-9a-f]{64}, that came from elsewhere, or of which an earlier version does not say whence, and that no key has signed that is trusted; they are made again$/;

async function expectAnew(name, there, where, anew, says) {
  const run = await expectRight(name, there, where);
  expect(run.anew.join() === anew.join(), `${name}: works out ${run.anew}`);
  const good = says ? run.notes.length === 1 && says.test(run.notes[0]) : run.notes.length === 0;
  expect(good, `${name}: says ${run.notes}`);
}

const entriesOf = ({ store }) => globSync(join(store, "ac/*/*"));
// The words in which the results on a machine's disk say where they are from.
const originsOf = (there) => {
  const entries = entriesOf(there).map(readSealed);
  return [...new Set(entries.filter(({ name }) => /^ac/.test(name)).map(({ origin }) => origin))];
};

await test("taken without a signature", async () => {
  const server = await usual();
  await expectRight("one who does not sign", machine(), server);
  const there = machine();
  await expectAnew("before keys are trusted", there, server, [], undefined);
  await expectAnew("still", there, nowhere({}), [], undefined);
  const trusts = trusting(ours);
  await expectAnew("once they are", there, nowhere(trusts), all, doubt);
  await expectAnew("after that", there, nowhere(trusts), [], undefined);
  await server.stop();
});

await test("taken with a signature", async () => {
  const server = await usual();
  await expectRight("one who signs", machine(), { ...server, environment: signing(theirs) });
  const there = machine();
  const trusts = { ...server, environment: trusting(ours, theirs) };
  await expectAnew("who trusts it", there, trusts, [], undefined);
  await expectAnew("still", there, nowhere(trusting(theirs)), [], undefined);
  await expectAnew("who trusts it no more", there, nowhere(trusting(ours)), all, doubt);
  await server.stop();
});

// Nobody who signs believes what others did not sign; so those who trust it find all that it has.
await test("a signer", async () => {
  const server = await usual();
  await expectRight("one who does not sign", machine(), server);
  const there = machine();
  await expectAnew("takes it", there, server, [], undefined);
  const signs = { ...server, environment: signing(ours) };
  const { anew } = await expectRight("signs", there, signs);
  expect(anew.join() === all.join(), `who signs works out ${anew}`);
  const trusts = { ...server, environment: trusting(ours) };
  await expectAnew("who trusts it", machine(), trusts, [], undefined);
  await server.stop();
});

await test("pushed", async () => {
  const from = await usual();
  const to = await nginx(join(home, "pushed")); // push is waited for
  await expectRight("one", machine(), from);
  const there = machine();
  await expectAnew("another", there, from, [], undefined);
  const push = (environment) =>
    say(there, { ...to, environment }, "store", "push", "--course", there.place);
  const [status, [said]] = push({});
  const kept =
    /^put \d+ entries? \(.*\) into (\S+); the disk has (\d+) of (\d+) results of this course; (\d+) came from elsewhere, or an earlier version does not say whence, and are not put$/;
  const [, url, has, of, not] = kept.exec(said) ?? [];
  expect(
    status === 0 && url === to.url && has === of && not === of,
    `push says ${status}: ${said}`,
  );
  const results = () => to.entries().filter((name) => name.startsWith("ac/"));
  expect(results().length === 0, `push puts ${results()}`);
  const [, signed] = push(signing(ours));
  expect(results().length === 0, `push signs ${results()}`);
  expect(signed[0] === "mjcourse: the disk has no result of this course", `push says ${signed}`);

  // Once they are made here, they are sent.
  await expectRight("made anew", there, nowhere(signing(ours)));
  const [good, line] = push(signing(ours));
  expect(good === 0 && !line[0].includes("elsewhere"), `push says ${line}`);
  expect(results().length > all.length, `push puts ${results()}`);
  await expectAnew("pulled", machine(), { ...to, environment: trusting(ours) }, [], undefined);
  for (const server of [from, to]) await server.stop();
});

// The server has lost the results of tasks, and still has those of the program's compiling and running:
// what is made of these is as good as they are.
await test("made of what was taken", async () => {
  const server = await usual();
  await expectRight("one", machine(program), server);
  const isOfTask = (bytes) =>
    /\["mjcourse","sources [0-9a-f]{16}"\]/.test(bytes.toString("latin1"));
  for (const [name, bytes] of server.kept) if (isOfTask(bytes)) server.kept.delete(name);
  const there = machine(program);
  await expectAnew("another", there, server, allOf(program), undefined);
  const programs = allOf(program).filter((name) => !all.includes(name));
  const results = entriesOf(there)
    .map(readSealed)
    .filter(({ bytes }) => isOfTask(bytes));
  const taken = results.filter(({ origin }) => origin === "unsigned");
  expect(
    results.length === allOf(program).length && taken.length === programs.length,
    `of ${results.length} results, ${taken.length} are made of what was taken`,
  );
  const trusts = await expectRight("once keys are trusted", there, nowhere(trusting(ours)));
  expect(
    programs.every((name) => trusts.anew.includes(name)),
    `works out ${trusts.anew}`,
  );
  await server.stop();
});

// Such a one does not say where it is from.
await test("of an earlier version", async () => {
  const there = machine();
  await expectRight("before", there);
  expect(originsOf(there).join() === "made", `made here are ${originsOf(there)}`);
  for (const file of entriesOf(there)) {
    const { name, bytes } = readSealed(file);
    writeFileSync(file, Buffer.concat([Buffer.from(sealOnItsWay(name, bytes)), bytes]));
  }
  await expectAnew("without keys", there, undefined, [], undefined);
  await expectAnew("with keys", there, nowhere(trusting(ours)), all, doubt);
  await expectAnew("after that", there, nowhere(trusting(ours)), [], undefined);
});

// Nobody is believed by mistake.
await test("wrong keys", async () => {
  const server = await usual();
  await expectRight("one", machine(), server);
  const there = machine();
  await expectAnew("another", there, server, [], undefined);
  const { anew, notes } = await expectRight(
    "a list that is none",
    there,
    nowhere({ MJCOURSE_STORE_TRUSTED_KEYS: "" }),
  );
  expect(anew.join() === all.join(), `works out ${anew}`);
  expect(
    notes[0] ===
      "note: no result from elsewhere is used: MJCOURSE_STORE_TRUSTED_KEYS lists no key; unset it to trust everybody" &&
      doubt.test(notes[1]),
    `says ${notes}`,
  );
  await server.stop();
});

finish();
