// A course of prose in any size, the same on every machine: for us, and the same Markdown for Hugo
// and Pandoc. Lessons have eight sections with a table and a code block in each, about 12 KB, and
// stand in levels of twenty.

import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

const lessonsOfLevel = 20;
const sectionsOfLesson = 8;

const words =
  `body joint hinge slide ball free inertia mass contact friction solver constraint force
  torque velocity position quaternion frame world tree chain link actuator motor gear damper spring
  tendon site geom mesh capsule sphere plane sensor gyro clock state control gain limit range step
  energy momentum impulse pressure margin gap soft hard stiff slow quick small large exact numeric
  moves holds falls slides turns rests pushes reads writes computes integrates measures returns`
    .split(/\s+/)
    .filter((word) => word !== "");

/** mulberry32: a generator of numbers in [0, 1) whose whole state is its seed. */
function numbersFrom(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

class Author {
  constructor(seed) {
    this.next = numbersFrom(seed);
  }
  below(limit) {
    return Math.floor(this.next() * limit);
  }
  word() {
    return words[this.below(words.length)];
  }
  name() {
    return `${this.word()}_${this.word()}`;
  }
  number() {
    return (this.next() * 10).toFixed(3);
  }
  phrase(count) {
    return Array.from({ length: count }, () => this.word()).join(" ");
  }
  sentence(marked = "") {
    const text = `${this.phrase(4 + this.below(4))}${marked}, ${this.phrase(3 + this.below(6))}`;
    return `${text[0].toUpperCase()}${text.slice(1)}.`;
  }
}

const codes = {
  cpp: (author) => `#include <mujoco/mujoco.h>

// ${author.sentence()}
double ${author.name()}(const mjModel* model, mjData* data) {
  double sum = ${author.number()};
  for (int i = 0; i < model->nv; ++i) {
    sum += data->qvel[i] * ${author.number()};  // ${author.phrase(3)}
  }
  if (sum > ${author.number()}) mj_step(model, data);
  return sum;
}
`,
  python: (author) => `import numpy as np

# ${author.sentence()}
def ${author.name()}(model, data, gain=${author.number()}):
    total = np.zeros(model.nv)
    for index in range(model.nv):
        total[index] = gain * data.qvel[index] - ${author.number()}
    print("${author.phrase(3)}", total.sum())
    return {"${author.word()}": total, "${author.word()}": ${author.below(99)}}
`,
  sh: (author) => `# ${author.sentence()}
export ${author.word().toUpperCase()}=${author.number()}
for name in ${author.phrase(4)}; do
  cmake -S . -B "build/$name" -D GAIN=${author.number()}
  cmake --build "build/$name" && ./build/$name/${author.name()} --steps ${author.below(1000)}
done
grep -c "${author.word()}" *.log | sort -n
`,
  yaml: (author) => `# ${author.sentence()}
${author.name()}:
  gain: ${author.number()}
  range: [-${author.number()}, ${author.number()}]
  joints:
    - {name: ${author.name()}, damping: ${author.number()}}
    - {name: ${author.name()}, damping: ${author.number()}}
  description: "${author.phrase(6)}"
`,
};

// `linkTo` writes the target of a link to a lesson of the same level, `fence` what opens a block.
function section(author, index, { linkTo, fence }) {
  const paragraph = () =>
    [
      author.sentence(),
      author.sentence(` **${author.phrase(2)}**`),
      author.sentence(` \`${author.name()}\``),
      author.sentence(` "${author.phrase(2)}"`),
      author.sentence(` *${author.word()}*`),
    ].join(" ");
  const rows = Array.from(
    { length: 4 },
    () =>
      `| ${author.phrase(2)} | \`${author.name()}\` | ${author.number()} | ${author.phrase(3)} |`,
  );
  const language = Object.keys(codes)[index % Object.keys(codes).length];
  const link = `[${author.phrase(3)}](${linkTo(author.below(lessonsOfLevel))})`;
  return `## ${author.phrase(4)}

${paragraph()}

${author.sentence()} ${author.sentence()} See ${link}.

| what | name | value | remark |
|---|---|---:|---|
${rows.join("\n")}

${author.sentence()}

- ${author.sentence()}
- ${author.sentence()}

${fence(language)}
${codes[language](author)}\`\`\`
`;
}

function lesson(level, index, dialect) {
  const author = new Author(level * lessonsOfLevel + index + 1);
  const front = `---
title: ${author.phrase(3)}
summary: ${author.sentence()}
tags: [${author.word()}, ${author.word()}]
---
`;
  const sections = Array.from({ length: sectionsOfLesson }, (_, s) => section(author, s, dialect));
  return [front, ...sections].join("\n");
}

const titleOf = (level) => `Level ${level + 1}`;
const folderOf = (level) => `${level + 1}-level`;
const slugOf = (level, index) => `${level + 1}.${index + 1}-lesson`;

function write(path, text) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, text);
}

function writeLessons(root, levels, dialectOf) {
  for (let level = 0; level < levels; ++level) {
    for (let index = 0; index < lessonsOfLevel; ++index) {
      const path = join(root, "content", folderOf(level), `${slugOf(level, index)}.md`);
      write(path, lesson(level, index, dialectOf(level)));
    }
  }
}

/** A course for `mjcourse build --course root`; gives the number of its lessons. */
export function writeCourse(root, lessons) {
  const levels = Math.ceil(lessons / lessonsOfLevel);
  const listed = Array.from({ length: levels }, (_, level) => {
    const slugs = Array.from({ length: lessonsOfLevel }, (_, index) => slugOf(level, index));
    return `  - {folder: ${folderOf(level)}, title: ${titleOf(level)}, lessons: [${slugs.join(", ")}]}\n`;
  });
  write(
    join(root, "content/course.yaml"),
    `title: Prose\ndescription: Nothing but text.\nlevels:\n${listed.join("")}`,
  );
  writeLessons(root, levels, (level) => ({
    linkTo: (index) => `${level + 1}.${index + 1}`,
    fence: (language) => `\`\`\`${language} unchecked because="it is prose"`,
  }));
  return levels * lessonsOfLevel;
}

/** The same Markdown below `root/content`, as Hugo and Pandoc take it, with Hugo's titles. */
export function writePlainLessons(root, lessons) {
  const levels = Math.ceil(lessons / lessonsOfLevel);
  for (let level = 0; level < levels; ++level) {
    const front = `---\ntitle: ${titleOf(level)}\nweight: ${level + 1}\n---\n`;
    write(join(root, "content", folderOf(level), "_index.md"), front);
  }
  writeLessons(root, levels, (level) => ({
    linkTo: (index) => `/${folderOf(level)}/${slugOf(level, index)}.html`,
    fence: (language) => `\`\`\`${language}`,
  }));
}
