// How links.mjs runs the generator on a course: as which user, in folders of its own; and what then lies
// in folders.

import { spawn, spawnSync } from "node:child_process";
import {
  lstatSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  readlinkSync,
} from "node:fs";
import { request } from "node:http";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { Course, secret } from "./linked-courses.mjs";

const mjcourse = resolve(process.argv[2]);
const mostSeconds = 60; // to an end; it takes a hundredth of that
const mostSilence = 120; // seconds, of a preview in which nothing is wrong

/** The folder of all that a test makes; the test removes it. */
export const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
let count = 0;

/** A new course, and the user whom it is to belong to. */
export function fresh(user) {
  const folder = join(home, `course-${++count}`);
  mkdirSync(folder);
  return { course: new Course(folder), user };
}

export function own(path, user) {
  if (user !== undefined) spawnSync("chown", ["-hR", `${user}:${user}`, path]);
}

// How the generator is started: as which user, with folders of its own.
function start(course, user) {
  const place = mkdtempSync(join(home, "own-"));
  own(place, user);
  own(course.folder, user);
  return {
    encoding: "utf8",
    cwd: "/",
    env: {
      PATH: process.env.PATH,
      TMPDIR: place,
      XDG_CACHE_HOME: place,
      TOKEN: secret,
    },
    ...(user === undefined ? {} : { uid: user, gid: user }),
  };
}

export function run(words, course, user) {
  const begin = Date.now();
  const came = spawnSync(mjcourse, [...words, "--course", course.folder], {
    ...start(course, user),
    timeout: 1000 * mostSeconds,
    killSignal: "SIGKILL",
  });
  return { ...came, seconds: (Date.now() - begin) / 1000 };
}

// The status of the answer to a request with this very path, which fetch() would make shorter.
const statusOf = (path, port) =>
  new Promise((tell) => {
    const asked = request({ host: "127.0.0.1", port, path }, (answer) => {
      answer.resume();
      tell(answer.statusCode);
    });
    asked.on("error", (error) => tell(error.message));
    asked.end();
  });

/** The same of a preview, which is asked for `pages` once it has counted the errors: its words, and the
 *  statuses of its answers. */
export async function preview(course, pages, user) {
  const words = ["preview", "--course", course.folder, "--store", join(home, `store-${count}`)];
  const shown = spawn(mjcourse, words, start(course, user));
  const said = { stdout: "", stderr: "" };
  await new Promise((counted) => {
    for (const name of ["stdout", "stderr"]) {
      shown[name].on("data", (text) => {
        said[name] += text;
        if (/^\d+ errors?$/mu.test(said.stderr) && said.stdout.includes("\n")) counted();
      });
    }
    shown.on("exit", counted);
    setTimeout(counted, 1000 * mostSilence).unref(); // where it has nothing to say
  });
  const port = /http:\/\/127\.0\.0\.1:(\d+)\//u.exec(said.stdout)?.[1];
  const statuses = [];
  for (const path of pages) statuses.push(await statusOf(path, port));
  shown.kill("SIGTERM");
  if (shown.exitCode === null && shown.signalCode === null)
    await new Promise((ended) => shown.on("exit", ended));
  return { ...said, statuses };
}

/** All that lies in folders and below them: paths with texts, and with the targets of links. */
export function everythingIn(...folders) {
  const all = new Map();
  for (const folder of folders) {
    for (const name of readdirSync(folder, { recursive: true })) {
      const path = join(folder, name);
      const status = lstatSync(path);
      if (status.isSymbolicLink()) all.set(path, readlinkSync(path));
      else all.set(path, status.isFile() ? readFileSync(path, "latin1") : "a folder");
    }
  }
  return all;
}

/** The paths of what `after` has otherwise than `before`. */
export const differences = (before, after) =>
  [...new Set([...before.keys(), ...after.keys()])].filter(
    (path) => before.get(path) !== after.get(path),
  );
