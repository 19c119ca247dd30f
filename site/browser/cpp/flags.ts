/**
 * How clang is called. The page and the build use the same flags, so that what the build has seen to
 * work does so in the page.
 *
 * clang's driver starts other processes, of which a page has none; so the compiler itself is called,
 * by -cc1, with all that the driver would have worked out.
 */

/** Where a program's own files lie. */
export const programFolder = "/program";
/** Where the pack has Eigen's, MuJoCo's and the helper header. */
export const packFolder = "/include";
/** What MJCOURSE_MODELS names. */
export const modelsFolder = "/models";

/** The precompiled header; bundle/cpp.mjs compiles what it defines, and the pack has that. */
export const preparedSource = "/prepared/header.hpp";
export const preparedHeader = "/prepared/header.pch";
export const preparedObject = "/prepared/header.o";
/** With what it declares and others define. */
export const preparedObjects = [preparedObject, "/runtime/eigen.o"];

/** Says in which sources clang puts no checks for null pointers: all but the program's own. Those in
 * others' templates would be a third of a program's code. */
export const uncheckedHeaders = "/prepared/unchecked.txt";
export const uncheckedHeadersText = `src:${packFolder}/*\nsrc:/usr/include/*\n`;

/** wasm's own exceptions: no other kind passes through a module that JavaScript does not see. */
const exceptions = [
  ...["exception-handling", "multivalue", "reference-types"].flatMap((feature) => [
    "-target-feature",
    `+${feature}`,
  ]),
  ...["-exception-model=wasm", "-mllvm", "-wasm-enable-eh"],
];

/** What clang's driver says where clang was not built to be tested itself. */
const released = ["-disable-llvm-verifier", "-discard-value-names"];

const target = [
  ...["-triple", "wasm32-unknown-wasip1", "-target-cpu", "generic"],
  ...["-resource-dir", "/usr", "-isysroot", "/usr"],
  ...["-mrelocation-model", "static", "-mframe-pointer=none", "-ffp-contract=on"],
  ...["-fno-rounding-math", "-mconstructor-aliases", "-fvisibility=hidden", "-disable-free"],
  ...["-clear-ast-before-backend", "-fgnuc-version=4.2.1", ...released, ...exceptions],
];

const systemHeaders = ["/usr/include", "/usr/include/wasm32-wasip1"].flatMap((folder) => [
  "-internal-isystem",
  folder,
]);

const cxx = [
  ...["clang++", "-cc1", ...target, "-std=c++20", "-fcxx-exceptions", "-fexceptions"],
  ...["-fdeprecated-macro", "-fskip-odr-check-in-gmf"],
  ...["-internal-isystem", "/usr/include/c++/v1", ...systemHeaders],
];

const c = ["clang", "-cc1", ...target, "-std=c17", "-fexceptions", ...systemHeaders];

const libraries = [
  ...["-isystem", `${packFolder}/eigen3`, "-isystem", packFolder],
  `-DMJCOURSE_MODELS="${modelsFolder}"`,
];

/** To compile a source of the reader's. `include` is the program's folder of headers. */
export const compileArguments = (
  source: string,
  object: string,
  how: { readonly include: string; readonly prepared: boolean; readonly withLines: boolean },
): string[] => [
  ...[...cxx, "-I", how.include, ...libraries, "-O0", "-ferror-limit", "19"],
  // a starter does not use what its reader is to use
  ...["-Wall", "-Wextra", "-Wno-unused-parameter"],
  // address 0 is memory like any other
  ...["-fsanitize=null", "-fsanitize-trap=null", `-fsanitize-ignorelist=${uncheckedHeaders}`],
  // a line for each of what diagnostics.ts reads
  ...["-fno-caret-diagnostics", "-fdiagnostics-print-source-range-info"],
  `-fmacro-prefix-map=${programFolder}/=`,
  ...(how.withLines ? ["-debug-info-kind=line-tables-only", "-dwarf-version=4"] : []),
  ...(how.prepared ? ["-include-pch", preparedHeader, "-fno-validate-pch"] : []),
  ...["-emit-obj", "-o", object, "-x", "c++", source],
];

/** To make the precompiled header. */
export const prepareArguments: readonly string[] = [
  ...[...cxx, ...libraries, "-O0", "-emit-pch", "-fno-pch-timestamp"],
  ...["-fpch-instantiate-templates", "-fmodules-codegen"],
  ...["-o", preparedHeader, "-x", "c++-header", preparedSource],
];

const optimized = ["-O2", "-ffunction-sections", "-fdata-sections", "-emit-obj"];

/** To compile what the precompiled header itself defines, once for all programs. */
export const prepareObjectArguments: readonly string[] = [
  ...["clang++", "-cc1", ...target, ...optimized, "-o", preparedObject, "-x", "ast"],
  preparedHeader,
];

/** To compile a source of the runtime. */
export const runtimeArguments = (
  source: string,
  object: string,
  more: readonly string[] = [],
): string[] => {
  const isC = source.endsWith(".c");
  const language = isC ? c : [...cxx, ...libraries];
  return [...language, ...more, ...optimized, "-o", object, "-x", isC ? "c" : "c++", source];
};
