// Of a shared store into which many may write, a machine takes nothing but what a key that it trusts
// has signed.
//
//   node tests/store/remote_signed.mjs MJCOURSE [CASE]

import { spawnSync } from "node:child_process";
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";

import { sealOnItsWay } from "./sealed.mjs";
import {
  all,
  check,
  expect,
  expectRight,
  finish,
  home,
  machine,
  mjcourse,
  test,
} from "./shared_machines.mjs";
import { strange } from "./servers.mjs";

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
    const seal = sealOnItsWay(name, content);
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
      "note: no shared store is used: MJCOURSE_STORE_TRUSTED_KEYS has a word that is no public key, which has 64 hexadecimal digits",
    ],
    [
      { MJCOURSE_STORE_SIGNING_KEY: "/none" },
      "note: no shared store is used: MJCOURSE_STORE_SIGNING_KEY does not name a file that can be read",
    ],
  ]) {
    const where = { url: "", environment: { ...environment, MJCOURSE_STORE_URL: server.url } };
    const { notes } = await check(machine(), where);
    expect(notes.join("\n") === says, `a wrong key: ${notes}`);
  }
  await server.stop();
});

finish();
