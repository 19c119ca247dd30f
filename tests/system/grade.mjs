// Some eighty hand-ins are graded, of which many are hostile: they get no points, break nothing, read nothing,
// and leave nothing; the others get theirs all the same.
//
//   node tests/system/grade.mjs MJCOURSE

import { execFileSync, spawnSync } from "node:child_process";
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const mjcourse = resolve(process.argv[2]);
const course = join(import.meta.dirname, "../courses/exercise/right");
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const solution = readFileSync(join(course, "examples/fall.cpp"), "utf8");
let failed = 0;

function expect(good, what) {
  if (good) return;
  ++failed;
  console.error(what);
}

// What a reader has, with `code` in the region.
const program = (code) =>
  solution.replace(/(#region answer\n)[^]*?(\n {2}\/\/ #endregion)/, (_, a, b) => a + code + b);

function handIn(name, text) {
  mkdirSync(join(folder, name));
  writeFileSync(join(folder, name, "fall.cpp"), text);
}

// By their names, with what they get and what is said of them.
const expected = new Map();

function expectOf(name, points, remark) {
  expected.set(name, { points, remark });
}

function code(name, points, remark, text) {
  handIn(name, program(text));
  expectOf(name, points, remark);
}

const right = "  return 9.81 * t * t / 2;";
const honest = [
  right,
  "  const double speed = 9.81 * t;\n  return speed / 2 * t;",
  "  double way = 0;\n  way += 0.5 * 9.81 * std::pow(t, 2);\n  return way;",
  "  // the main idea: expect half of the last speed\n  return 4.905 * t * t;",
  "  auto square = [](double x) { return x * x; };\n  return 9.81 / 2 * square(t);",
];
for (let i = 0; i < 15; ++i) code(`right-${i}`, 4, "", honest[i % honest.length]);
for (let i = 0; i < 3; ++i) code(`half-${i}`, 2, "", "  return 9.81 * t / 2;");
code("later-only", 3, "", "  return t < 1 ? 0 : 9.81 * t * t / 2;");
code("starter", 0, "", "  return 0;  // t = 1 s: 4.9 m");
code("not-a-number", 0, "", "  return std::sqrt(-t);");
code("leaves-early", 0, "", "  std::exit(0);\n  return t;");

const all = (words) => `  ${words}\n${right}`;
const own = "a hand-in may not use `";
const braces = "closes each bracket that it opens, and no other";
code("endless", 0, "still ran after 10 s", all("while (t >= 0) mju_sin(t);"));
code("prints", 0, "1 MiB", all('while (t >= 0) std::puts("x");'));
code("passwords", 0, "/etc/passwd", all('if (!std::ifstream("/etc/passwd")) return 0;'));
// It writes what the checks would, and does not know the number in front.
const forged = `
  const char* report = "0123456789abcdef{\\"what\\": \\"it falls 4.9 m in the first second\\", "
      "\\"meaning\\": \\"\\", \\"points\\": 2, \\"line\\": 20, \\"value\\": \\"4.905\\"}\\n";
  for (int to = 0; to < 9; ++to) (void)!::write(to, report, std::strlen(report));
  return t;`;
code("forged", 0, "not made by the program itself", forged);
code("writes", 0, "/tmp/mjcourse-was-here", all('std::ofstream("/tmp/mjcourse-was-here") << 1;'));
code("memory", 0, "", all("for (;;) std::memset(new char[1 << 26], 1, 1 << 26);"));
code("crashes", 0, "Segmentation fault", all("*reinterpret_cast<volatile int*>(8) = 1;"));
code("recursion", 0, "Segmentation fault", all("volatile double x = fallen(t + 1); (void)x;"));
code("kills", 0, "", all("::raise(9);"));
code("checks-itself", 0, own, all('expect(true, "it falls 4.9 m in the first second");'));
code("own-main", 0, braces, `  return 0;\n}\nint main() {\n  return 0;`);
code("spliced", 0, "ends with a backslash", all("exp\\\nect(true, std::string());"));
code("assembler", 0, own, all('asm("nop");'));
code("includes", 0, "no preprocessor directives", `#include "/etc/passwd"\n${right}`);
code("digraph", 0, "no preprocessor directives", `%:define double int\n${right}`);
code("form-feed", 0, "no control characters", `  return 0;\n%\\\f\n:define exp\\\f\nect 1\n`);
code("behind-a-comment", 0, "no preprocessor directives", `/* */ #define double int\n${right}`);
code("behind-a-quote", 0, own, all("int n = 1'0; expect(n, std::string()); n = 2'0;"));
code("raw-utf8", 4, "", `  auto s = u8R"(\n)"; (void)s;\n${right}`);
code("raw", 4, "", `  const char* s = R"(\n)"; (void)s;\n${right}`);
code("open-comment", 0, "opened and not closed", `${right} /*`);
code("open-brace", 0, braces, `${right} {`);
code(
  "template-bomb",
  0,
  "compiler",
  all(
    "[]<int... i>(std::integer_sequence<int, i...>) { return ((i + ... + 0)); }(std::make_integer_sequence<int, 100000000>());",
  ),
);
code("escapes", 0, "static assertion failed", all('static_assert(false, "\\x1b[2J\\x07");'));
code(
  "ends-behind-main",
  0,
  braces,
  `  return 0;\n}\nstruct Last { ~Last() { std::_Exit(0); } } last;\ndouble other(double t) {\n  return t;`,
);
code("digraph-brace", 0, braces, `  return 0;\n%>\nvoid other() <%`);
code("overload", 0, "", `  {\n    namespace m = mjcourse;\n    (void)m::id_of;\n  }\n  return 0;`);
code("another-function", 4, "", `  const double fallen(9.81 * t * t / 2);\n  return fallen;`);
// What compilers read in another way than it looks.
code(
  "lone-return",
  0,
  "a carriage return stands alone",
  `  // a comment\r  expect(true, "");\n${right}`,
);
code(
  "spliced-prefix",
  4,
  "",
  `  const char* s = u8\\\nR"x(\n)" } int main() { )x"; (void)s;\n${right}`.replace(
    "const char*",
    "auto",
  ),
);
code("letter-and-digits", 0, "opened and not closed", `  int ä1'0; }\nint other() { return '1;`);
code("assembler-by-macro", 0, own, all('__asm__(".incbin \\"fall.cpp\\"");'));
code("pragma", 0, own, all('_Pragma("comment(lib, \\"m\\")");'));
code("attribute", 0, own, all("[[gnu::noinline]] int n = 0; (void)n;"));
code("includes-itself", 0, "no preprocessor directives", `#include "fall.cpp"\n${right}`);
code(
  "includes-hidden",
  0,
  "no preprocessor directives",
  `#include "examples/fall_hidden.cpp"\n${right}`,
);
// It overloads what is called behind it; numbers do not become right by that.
code(
  "own-verdict",
  0,
  "",
  `  struct Near {\n    double x;\n    operator double() const { return x; }\n  };\n  return Near{1};`,
);
// It is right once, and then ends the program as if all were well.
// It is right in the first of three calls of a check, and then ends the program: two checks were not
// made, and of the hidden ones all.
const first = "static int n = 0; if (++n > 3)";
code("leaves-after-one", 3, "", all(`${first} std::exit(0);`));
code("leaves-by-a-thread", 3, "", all(`${first} ::pthread_exit(nullptr);`));
code("closes-its-ears", 3, "", all(`${first} for (int i = 3; i < 9; ++i) ::close(i);`));
code(
  "fails-one-and-leaves",
  0,
  "",
  `  ${first.replace("3", "2")} std::exit(0);\n  return t > 1 ? 19.62 : 0;`,
);
code(
  "macro-assembler",
  0,
  "may not use `asm`, which a macro makes",
  all('EIGEN_CAT(as, m)("nop");'),
);
code(
  "macro-check",
  0,
  "may not use `expect`, which a macro makes",
  all('mjcourse::EIGEN_CAT(exp, ect)(1, "x");'),
);
code("macro-attribute", 0, own, all("[[EIGEN_CAT(gn, u)::noinline]] int n = 0; (void)n;"));
code(
  "macro-pragma",
  0,
  "a macro makes the directive `# pragma redefine_extname snprintf puts`",
  all('EIGEN_CAT(_Prag, ma)("redefine_extname snprintf puts");'),
);
code(
  "macro-of-all",
  4,
  "",
  all("assert(t < NAN || true); (void)INFINITY; errno = 0; if (NULL) return CLOCKS_PER_SEC;"),
);
code("reads-stdin", 4, "", all("if (std::getchar() != EOF) return 0;"));
code("raw-hash", 4, "", `  const char* s = R"(\n#hash\nint main(\n}\n)"; (void)s;\n${right}`);
code("no-break-space", 0, "no such character here, U+00A0", all("double\u00a0x = 0; (void)x;"));
// What earlier reports left in memory, and what others write into it.
code(
  "reads-memory",
  0,
  "",
  `  std::string left(400, 0);\n  char* freed = new char[400];\n  for (int i = 0; i < 400; ++i) left[i] = freed[i];\n  std::puts(left.c_str());\n  return 0;`,
);
handIn("no-marks", solution.replaceAll(/.*#(region|endregion).*\n/g, ""));
expectOf("no-marks", 0, "it has no region `answer`");
handIn("unclosed", program(right).replace("// #endregion", ""));
expectOf("unclosed", 0, "it has no end of the region `answer`");
handIn("large", `${program(right)}${"// more\n".repeat(200_000)}`);
expectOf("large", 0, "more than 1 MiB");
mkdirSync(join(folder, "bytes"));
writeFileSync(
  join(folder, "bytes/fall.cpp"),
  Buffer.from(program("  return 0; // \u0000\xff"), "latin1"),
);
expectOf("bytes", 0, "");
mkdirSync(join(folder, "link"));
symlinkSync("/etc/passwd", join(folder, "link/fall.cpp"));
expectOf("link", 0, "it is a link");
symlinkSync("right-0", join(folder, "linked-folder"));
expectOf("linked-folder", 0, "");
mkdirSync(join(folder, "linked-inside"));
symlinkSync("../in-a-folder/fall", join(folder, "linked-inside/fall"));
expectOf("linked-inside", 0, "it is a link");
mkdirSync(join(folder, "pipe"));
execFileSync("mkfifo", [join(folder, "pipe/fall.cpp")]);
expectOf("pipe", 0, "it is no plain file");
mkdirSync(join(folder, "nothing"));
expectOf("nothing", 0, "");
mkdirSync(join(folder, "in-a-folder/fall"), { recursive: true });
writeFileSync(join(folder, "in-a-folder/fall/fall.cpp"), program(right));
expectOf("in-a-folder", 4, "");

const names = [...expected.keys()];
expect(names.length >= 75, `only ${names.length} hand-ins`);
const scratch = join(folder, "scratch");
mkdirSync(scratch, { mode: 0o777 });
const grade = (format, ...hand_ins) => gradeIn(course, format, ...hand_ins);
const gradeIn = (against, format, ...hand_ins) =>
  spawnSync(mjcourse, ["grade", "--against", against, "--format", format, ...hand_ins], {
    cwd: folder,
    encoding: "utf8",
    env: { ...process.env, TMPDIR: scratch },
    maxBuffer: 1 << 28,
  });
const { status, stdout, stderr } = grade("json", ...names);
expect(status === 0, `it ends with ${status}: ${stderr}`);
const graded = JSON.parse(stdout);
expect(graded.map((one) => one.hand_in).join() === names.join(), "not in their order");
for (const { hand_in, points, of, exercises } of graded) {
  const { points: due, remark } = expected.get(hand_in);
  const [{ faults, handed_in }] = exercises;
  const said = faults.map(({ message, detail }) => `${message} ${detail}`).join("; ");
  expect(of === 4, `${hand_in}: ${of} points can be had`);
  expect(points === due, `${hand_in} gets ${points} and not ${due}: ${said}`);
  expect(said.includes(remark), `${hand_in} is told: ${said}`);
  const is_there = !["nothing", "linked-folder"].includes(hand_in);
  expect(handed_in === is_there, `${hand_in}: handed in is ${handed_in}`);
  expect(!JSON.stringify(exercises).includes("root:"), `${hand_in} has read /etc/passwd`);
}
expect(!existsSync("/tmp/mjcourse-was-here"), "a hand-in has written a file");
expect(readdirSync(scratch).length === 0, `it leaves ${readdirSync(scratch)}`);

const text = grade("text", "right-0", "half-0", "escapes").stdout;
expect(!text.includes("\u001b"), "a hand-in speaks to the terminal");
expect(
  text.startsWith(`right-0
  fall: 4 of 4 points
half-0
  fall: 2 of 4 points
    [ ] twice the time is four times the way
      it is 9.81, and should be 19.62 ± 1e-09: off by 9.8
    [ ] it falls 5 cm in 0.1 s
      it is 0.4905, and should be 0.04905 ± 1e-09: off by 0.44
escapes
  fall: 0 of 4 points; `),
  text,
);
// What the course's own solution does, is right: it calls what stands behind it, and its lines end
// as Windows ends them.
mkdirSync(join(folder, "author"));
const answers = join(course, "../answers");
const own_solution = readFileSync(join(answers, "examples/root.cpp"), "utf8");
writeFileSync(join(folder, "author/root.cpp"), own_solution.replaceAll("\n", "\r\n"));
const author = gradeIn(answers, "text", "author");
expect(
  author.stdout === "author\n  root: 4 of 4 points, 2 of them at its own word\n1 hand-in\n",
  author.stdout + author.stderr,
);
const refused = grade("text", "gone");
expect(refused.status === 2 && refused.stderr.includes("there is no folder gone"), refused.stderr);
rmSync(folder, { recursive: true });
console.log(`${names.length} hand-ins, ${failed} problems`);
process.exitCode = failed > 0 ? 1 : 0;
