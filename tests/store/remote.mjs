// Machines that share a store: what one has found out, the other does not do again, whichever server
// it is behind; and the commands that tell of such a store, or exchange results with it.
//
//   node tests/store/remote.mjs MJCOURSE [CASE]

import { spawn } from "node:child_process";
import { cpSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

import {
  all,
  allOf,
  course,
  expect,
  expectRight,
  finish,
  home,
  machine,
  mjcourse,
  program,
  say,
  test,
  write,
} from "./shared_machines.mjs";
import { lighttpd, nginx, nginxAtSocket, nginxWithToken, strange } from "./servers.mjs";

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

// The program that talks to the server, while that keeps it waiting: what the kernel says of it.
await test("confined", async () => {
  let seen;
  const mark = `no_proxy=${process.pid}.example`; // others' programs of that name may run
  const secret = { MJCOURSE_STORE_TOKEN: "a-token", MJCOURSE_TEST_SECRET: "x" };
  const read = (id, file) => readFileSync(`/proc/${id}/${file}`, "utf8");
  const server = await strange(({ usual }) => {
    const id = readdirSync("/proc").find((name) => {
      try {
        return read(name, "comm") === "mjcourse-net\n" && read(name, "environ").includes(mark);
      } catch {
        return false; // it is no process, or has ended
      }
    });
    const variables = read(id, "environ").split("\0").filter(Boolean);
    seen ??= {
      status: read(id, "status"),
      variables: variables.map((one) => one.split("=")[0]).sort(),
    };
    return usual;
  });
  const [name, place] = mark.split("=");
  const environment = { ...secret, [name]: place };
  await expectRight("confined", machine(), { ...server, environment });
  const value = (name) => new RegExp(`^${name}:\\s+(\\S+)`, "m").exec(seen.status)[1];
  expect(value("NoNewPrivs") === "1" && value("Seccomp") === "2", seen.status);
  expect(value("Seccomp_filters") === "2", `it gave up nothing itself: ${seen.status}`);
  expect(/^0+$/.test(value("CapEff")), `it has capabilities: ${seen.status}`);
  expect(value("Uid") !== "0", `it is root: ${seen.status}`);
  const variables = "GLIBC_TUNABLES HOME LC_ALL PATH TMPDIR no_proxy";
  expect(seen.variables.join(" ") === variables, `it knows ${seen.variables}`);
  await server.stop();
});

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

finish();
