// Two machines that are alike but for all that must not matter: the course's path, the user, the time
// zone, the language, the umask, the number of cores, the order of a folder's entries. Each has a
// network of its own, and both have one store: what one has found out, the other finds there.
//
//   node tests/store/machines.mjs MJCOURSE     as root, who may make networks; skipped otherwise, and where
//                                              other users cannot read the checkout

import { spawnSync } from "node:child_process";
import {
  chmodSync,
  copyFileSync,
  globSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";

import { nginxAt } from "./servers.mjs";

const mjcourse = resolve(process.argv[2]);
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
chmodSync(home, 0o755);
let failed = 0;
function expect(good, what) {
  if (good) return;
  ++failed;
  console.error(what);
}

function ip(...words) {
  const ran = spawnSync("ip", words, { encoding: "utf8" });
  if (ran.status !== 0) throw new Error(`ip ${words.join(" ")}: ${ran.error ?? ran.stderr}`);
}

const course = join(home, "course");
const begun = spawnSync(mjcourse, ["init", course, "A course"], { encoding: "utf8" });
if (begun.status !== 0) throw new Error(begun.stderr);

// `number` is 1 or 2; the network is 10.231.NUMBER.0/24, of which this machine is the first.
class Machine {
  constructor(number, { path, user, umask, cores, environment, order }) {
    this.name = `mjcourse-${process.pid}-${number}`;
    this.link = `mjc${process.pid % 10000}${number}`;
    this.server = `10.231.${number}.1`;
    Object.assign(this, { number, user, umask, cores, environment });
    this.home = join(home, `home-${number}`);
    this.place = join(home, path);
    const files = globSync("**", { cwd: course, dot: true }).filter((file) =>
      statSync(join(course, file)).isFile(),
    );
    for (const file of order(files.sort())) {
      mkdirSync(dirname(join(this.place, file)), { recursive: true });
      copyFileSync(join(course, file), join(this.place, file));
    }
    mkdirSync(this.home);
    for (const owned of [this.home, join(home, path.split("/")[0])]) {
      spawnSync("chown", ["-R", `${user}:${user}`, owned]);
    }
  }

  // After a failure, remove() takes back what was made.
  connect() {
    ip("netns", "add", this.name);
    ip("link", "add", `${this.link}a`, "type", "veth", "peer", "name", `${this.link}b`);
    ip("link", "set", `${this.link}b`, "netns", this.name);
    ip("address", "add", `${this.server}/24`, "dev", `${this.link}a`);
    ip("link", "set", `${this.link}a`, "up");
    ip("-n", this.name, "address", "add", `10.231.${this.number}.2/24`, "dev", `${this.link}b`);
    ip("-n", this.name, "link", "set", `${this.link}b`, "up");
    ip("-n", this.name, "link", "set", "lo", "up");
    const open = spawnSync(mjcourse, ["--version"], { uid: this.user, gid: this.user, cwd: "/" });
    if (open.error) throw open.error;
  }

  // The tasks that were worked out, and what was said.
  run(port, command, ...more) {
    const url = `http://${this.server}:${port}`;
    const words = [mjcourse, command, "--course", this.place, "--store-url", url, ...more];
    const shell = `umask ${this.umask}; exec "$@"`;
    const user = ["setpriv", `--reuid=${this.user}`, `--regid=${this.user}`, "--clear-groups"];
    const inside = [
      ...user,
      "taskset",
      "--cpu-list",
      this.cores,
      "sh",
      "-c",
      shell,
      "sh",
      ...words,
    ];
    return spawnSync("ip", ["netns", "exec", this.name, ...inside], {
      encoding: "utf8",
      env: { PATH: process.env.PATH, HOME: this.home, ...this.environment },
      maxBuffer: 1 << 28,
    });
  }

  check(port) {
    const trace = join(this.home, "trace.json");
    const ran = this.run(port, "check", "--trace", trace);
    expect(ran.status === 0, `${this.name}: ${ran.stdout}${ran.stderr}`);
    const { traceEvents } = JSON.parse(readFileSync(trace, "utf8"));
    const anew = traceEvents.filter((event) => event.cat === "worked").map((event) => event.name);
    return { anew, said: ran.stderr };
  }

  remove() {
    spawnSync("ip", ["netns", "delete", this.name]);
    spawnSync("ip", ["link", "delete", `${this.link}a`]);
  }
}

const last = spawnSync("nproc", { encoding: "utf8" }).stdout.trim() - 1;
const kinds = [
  {
    path: "a/course",
    user: 20001,
    umask: "022",
    cores: `0-${last}`,
    environment: { TZ: "UTC", LC_ALL: "C.UTF-8" },
    order: (files) => files,
  },
  {
    path: "b/of a user's/own course",
    user: 20002,
    umask: "077",
    cores: "0",
    environment: { TZ: "Asia/Kathmandu", LC_ALL: "C", LANGUAGE: "de", TERM: "dumb" },
    order: (files) => files.reverse(),
  },
];

const machines = [];
let server;
try {
  try {
    for (const [i, kind] of kinds.entries()) {
      machines.push(new Machine(i + 1, kind));
      machines[i].connect();
    }
  } catch (error) {
    console.log(`no machines can be made here: ${error.message}`);
    process.exitCode = 77;
  }
  if (process.exitCode !== 77) {
    server = await nginxAt("0.0.0.0", join(home, "server"));
    const [one, other] = machines;
    const first = one.check(server.port);
    expect(first.anew.length > 5, `the first works out ${first.anew}`);
    expect(first.said === "", `the first says ${first.said}`);

    const told = one.run(server.port, "explain", "--json");
    const file = join(home, "one.json");
    writeFileSync(file, told.stdout);
    const against = other.run(server.port, "explain", "--against", file);
    expect(
      against.status === 0 && /^\d+ tasks with the same dependencies\n$/.test(against.stdout),
      `the machines differ: ${against.stdout}${against.stderr}`,
    );
    const second = other.check(server.port);
    expect(second.anew.length === 0, `the second works out ${second.anew}`);
    expect(second.said === "", `the second says ${second.said}`);

    // Of another architecture, on which the C library's sines may be rounded otherwise.
    const changed = told.stdout.replaceAll(/("arithmetic",\s+)"[^"]*"/g, '$1"another"');
    writeFileSync(file, changed);
    const differs = other.run(server.port, "explain", "--against", file);
    expect(
      /^arithmetic: .* here, another there\n {2}content\/.*, and \d+ other tasks\n0 tasks with the same dependencies\n$/.test(
        differs.stdout,
      ),
      `against another architecture: ${differs.stdout}${differs.stderr}`,
    );
  }
} finally {
  for (const machine of machines) machine.remove();
  await server?.stop();
  rmSync(home, { recursive: true });
}
if (process.exitCode !== 77) {
  console.log(`${failed} problems`);
  process.exitCode = failed > 0 ? 1 : 0;
}
