// What a program that draws found is kept. Mesa looks at more of the disk than other libraries do:
// the program's own folder and those that it is in, which change all the time.
//
//   node tests/store/drawing.mjs MJCOURSE

import { cleanUp, worked, write } from "./harness.mjs";
import { withPageHalves } from "./page_halves.mjs";

const mjcourse = process.argv[2];

const program = `#include <GL/gl.h>
#include <GL/osmesa.h>

#include <cstdio>

int main() {
  unsigned char picture[4 * 4 * 4];
  OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, nullptr);
  if (!OSMesaMakeCurrent(context, picture, GL_UNSIGNED_BYTE, 4, 4)) return 1;
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glFinish();
  std::printf("%d %d\\n", picture[0], picture[1]);
  OSMesaDestroyContext(context);
}
`;
write("content/course.yaml", "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b]}\n");
write("examples/red.cpp", program);
write(
  "content/1-a/1.1-b.md",
  `---
title: B
---

\`\`\`cpp file=examples/red.cpp
${program}\`\`\`

\`\`\`text
255 0
\`\`\`
`,
);

const failures = [];
for (const expected of [withPageHalves(["compile and run red"], mjcourse).join("; "), ""]) {
  const { anew, notes } = worked(mjcourse);
  if (anew.join("; ") !== expected) failures.push(`worked out [${anew}], not [${expected}]`);
  if (notes !== "") failures.push(notes);
}
cleanUp();
for (const failure of failures) console.error(failure);
console.log(`${2 - failures.length} passed, ${failures.length} failed`);
process.exit(failures.length === 0 ? 0 : 1);
