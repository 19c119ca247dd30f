// The compiler of programs in the page: clang and its linker as one program of WebAssembly (the npm
// package @yowasp/clang), and a pack of all that programs are compiled of and linked with.
//
// Both are compressed with xz, which browsers do not know themselves (browser/cpp/download.ts): a
// server may compress a program of WebAssembly badly or not at all, and this one has 75 MB. Compressing
// it takes minutes and the pack one, so both are kept in the user's cache under a hash of all that they
// are made of. They wait for nothing else of the build, which begins with them (keep.mjs). Where
// something is missing, the site has no compiler, and its programs are only read.

import { execFile } from "node:child_process";
import { createHash } from "node:crypto";
import {
  chmod,
  copyFile,
  cp,
  mkdir,
  mkdtemp,
  readdir,
  readFile,
  rename,
  rm,
  symlink,
  writeFile,
} from "node:fs/promises";
import { homedir } from "node:os";
import path from "node:path";
import { promisify } from "node:util";

import { build } from "esbuild";

import { withLargerSteps } from "./allocation-step.mjs";
import { withImportedMemory } from "./imported-memory.mjs";
import { copyCompilerLicenses } from "./licenses.mjs";
import { forBrowsers, manifestOf } from "./manifest.mjs";

const run = promisify(execFile);

// As node/native-clang.ts has it.
const nativeCompiler = "/usr/lib/llvm-22/bin/clang";

// Builds into `out`: `public`, of which it returns the part of the manifest, and `cpp`, with which the
// build itself runs programs as the page does (node/run.ts). `engine` is the folder with MuJoCo for the
// browser.
export async function buildCpp(site, out, engine) {
  const missing = await firstMissing([path.join(engine, "engine.wasm"), ...sourcesOf(site)]);
  if (missing) return giveUp(`for want of ${missing}`);

  const folder = path.join(out, "cpp");
  await mkdir(folder, { recursive: true });
  await mkdir(path.join(out, "public/assets"), { recursive: true });
  const llvm = path.join(folder, "llvm.wasm");
  await writeCompiler(site, llvm);
  const compressed = await keptCompiler(llvm);
  // Another release of emscripten may have other sources.
  const pack = await keptPack(site, llvm).catch(({ message }) => giveUp(message));
  if (typeof pack !== "string") return {};
  await Promise.all([
    copyFile(path.join(pack, "cpp.pack"), path.join(folder, "cpp.pack")),
    copyFile(path.join(pack, "header.pch"), path.join(folder, "header.pch")),
    bundleForNode(site, "run", folder),
    copyNative(site, pack, llvm, path.join(folder, "native")),
    copyEngine(engine, path.join(folder, "engine")),
    copyProgram(process.execPath, path.join(folder, "node")),
  ]);
  const version = await hashOf(
    ["llvm.wasm", "cpp.pack", "header.pch", "run.mjs"].map((f) => path.join(folder, f)),
  );
  await writeFile(path.join(folder, "version"), `${version}-${process.version}\n`);

  const [worker, ...hashed] = await Promise.all([
    bundleWorker(site, path.join(out, "public")),
    copyHashed(path.join(compressed, "llvm.xz"), out, "llvm", "wasm.xz"),
    copyHashed(path.join(pack, "cpp.pack.xz"), out, "cpp", "pack.xz"),
    copyCompilerLicenses(site, path.join(out, "public/licenses/cpp")),
  ]);
  return { ...worker, "llvm.wasm.xz": hashed[0], "cpp.pack.xz": hashed[1] };
}

// As it runs in the page, and here.
export async function writeCompiler(site, llvm) {
  const original = await readFile(path.join(clangIn(site), "llvm.core.wasm"));
  await writeFile(llvm, withImportedMemory(withLargerSteps(original)));
}

// The folder of the cache with that compiler as browsers load it.
export function keptCompiler(llvm) {
  return keptFolder([llvm], (into) => compress(llvm, into, "llvm"));
}

// The folder of the cache with the pack, plain and compressed, and the precompiled header.
export function keptPack(site, llvm) {
  return inWorkFolder(async (work) => {
    const maker = await bundleForNode(site, "make-pack", work);
    const [, resources, ...others] = sourcesOf(site);
    return keptFolder([maker, llvm, resources, ...others], async (into) => {
      await run(process.execPath, [maker, path.dirname(site), llvm, resources, into]);
      await compress(path.join(into, "cpp.pack"), into, "cpp.pack");
    });
  });
}

// What Debian's clang needs to make the page's objects (node/native-clang.ts); nothing where there is none,
// or it makes others.
async function copyNative(site, pack, llvm, folder) {
  const version = await run(nativeCompiler, ["--version"]).catch(() => undefined);
  await rm(folder, { recursive: true, force: true });
  if (!version) return;
  const native = await inWorkFolder(async (work) => {
    const maker = await bundleForNode(site, "make-native", work);
    const about = path.join(work, "version");
    await writeFile(about, version.stdout);
    const parts = ["cpp.pack", "header.pch"].map((name) => path.join(pack, name));
    return keptFolder([maker, about, llvm, ...parts], async (into) => {
      const cpp = path.join(work, "cpp");
      await mkdir(cpp);
      for (const file of [llvm, ...parts]) await symlink(file, path.join(cpp, path.basename(file)));
      const { stdout } = await run(process.execPath, [maker, cpp, into]);
      if (stdout) console.warn(`mjcourse: ${stdout.trim()}`);
    });
  });
  if ((await readdir(native)).length === 0) return;
  await cp(native, folder, { recursive: true });
  await chmod(folder, 0o755); // a program that is confined may be another user
}

// A folder for the time of `work`, on the disk of what is kept.
export async function inWorkFolder(work) {
  const folder = await mkdtemp(path.join(await cacheFolder(), ".making-"));
  try {
    return await work(folder);
  } finally {
    await rm(folder, { recursive: true });
  }
}

function clangIn(site) {
  return path.join(site, "node_modules/@yowasp/clang/gen");
}

// Of the pack; the first is the compiler, the second its resources.
function sourcesOf(site) {
  return [
    path.join(clangIn(site), "llvm.core.wasm"),
    path.join(clangIn(site), "llvm-resources.tar"),
    "/usr/include/eigen3/Eigen",
    "/usr/include/mujoco",
    "/usr/share/emscripten/system/lib/libcxxabi",
    path.join(site, "browser/cpp/runtime"),
    path.join(site, "../examples/include/mjcourse"),
  ];
}

// Under its plain names: in `public` they have hashes.
async function copyEngine(engine, folder) {
  await mkdir(folder, { recursive: true });
  for (const name of ["engine.mjs", "engine.wasm"]) {
    await copyFile(path.join(engine, name), path.join(folder, name));
  }
}

// A program that runs cannot be written to; its place can have another.
async function copyProgram(from, to) {
  await rm(to, { force: true });
  await copyFile(from, to);
}

// Without the compiler, the manifest has nothing of it.
function giveUp(why) {
  console.warn(`mjcourse: warning: no program runs in the page: ${why}`);
  return {};
}

async function firstMissing(files) {
  for (const file of files) {
    const isThere = await readdir(file).catch(({ code }) => code === "ENOTDIR");
    if (!isThere) return file;
  }
}

async function compress(file, into, name) {
  const compressed = path.join(into, `${name}.xz`);
  await run("sh", ["-c", 'xz -9e -T1 -c "$0" > "$1"', file, compressed]);
}

// The folder of the cache that has what `make` makes of `inputs`. It is made aside and renamed, so a
// kill leaves nothing half done.
async function keptFolder(inputs, make) {
  const cache = await cacheFolder();
  const kept = path.join(cache, await hashOf(inputs));
  if (await readdir(kept).catch(() => undefined)) return kept;
  const work = await mkdtemp(path.join(cache, ".making-"));
  try {
    await make(work);
    await rename(work, kept);
  } catch (error) {
    await rm(work, { recursive: true });
    if (error.code !== "ENOTEMPTY") throw error; // somebody else was faster
  }
  return kept;
}

async function cacheFolder() {
  const root = process.env["XDG_CACHE_HOME"] || path.join(homedir(), ".cache");
  const folder = path.join(root, "mjcourse/cpp");
  await mkdir(folder, { recursive: true });
  return folder;
}

// Of files and of folders with all in them, by their names within.
async function hashOf(inputs) {
  const hash = createHash("sha256");
  for (const input of inputs) {
    const names = await readdir(input, { recursive: true }).catch(() => [""]);
    for (const name of names.sort()) {
      const content = await readFile(path.join(input, name)).catch(() => undefined);
      if (content) hash.update(`${name} ${content.length}\n`).update(content);
    }
  }
  return hash.digest("hex");
}

async function bundleForNode(site, name, outdir) {
  await build({
    absWorkingDir: site,
    entryPoints: [`node/${name}.ts`],
    outdir: path.resolve(outdir),
    outExtension: { ".js": ".mjs" },
    bundle: true,
    platform: "node",
    format: "esm",
    target: "node24",
    logLevel: "warning",
  });
  return path.join(outdir, `${name}.mjs`);
}

async function bundleWorker(site, out) {
  const { metafile } = await build({
    ...forBrowsers(site, out),
    entryPoints: [{ in: "browser/cpp/worker.ts", out: "cpp" }],
    entryNames: "assets/[name]-[hash]",
    metafile: true,
    format: "esm",
    legalComments: "none",
  });
  return manifestOf(metafile, site, out);
}

async function copyHashed(file, out, stem, ext) {
  const content = await readFile(file);
  const hash = createHash("sha256").update(content).digest("hex").slice(0, 8).toUpperCase();
  const hashed = `assets/${stem}-${hash}.${ext}`;
  await copyFile(file, path.join(out, "public", hashed));
  return hashed;
}
