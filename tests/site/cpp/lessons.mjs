// What the build has proved of the course's programs holds in a browser: of each lesson, one or more
// print there what the lesson's run printed, as exactly as the lesson states it.
//
//   node tests/site/cpp/lessons.mjs SITE
//
// The site is the repository's own, of whose lessons one third is done, which the commit chooses
// (sample.mjs). Programs of 5.1 are among those that take longest to compile; one
// that measures times, as 1.3 has it, may print others in a browser, whose clock is coarse.

import { sampleOf } from "../../sample.mjs";
import { testPrograms } from "./compiler.mjs";
import { Program } from "./program.mjs";

const programs = {
  "0-first-steps/0.1-a-first-simulation.html": ["example-l0_1_first_simulation"],
  "0-first-steps/0.2-reading-mjcf.html": ["example-l0_2_inertia-hand", "snippet_0_2_1"],
  "1-state/1.1-model-and-data.html": [
    "example-l1_1_threads-rollout",
    "example-l1_1_copy_state-copies",
  ],
  "1-state/1.2-generalized-coordinates.html": ["example-l1_2_generalized_coordinates"],
  "1-state/1.3-inside-mj-step.html": ["example-l1_3_by_hand"],
  "1-state/1.4-forces-and-where-they-enter.html": ["example-l1_4_bag"],
  "1-state/1.5-energy-as-a-lie-detector.html": ["example-l1_5_energy_audit"],
  "1-state/1.6-contact-first-sight.html": ["example-l1_6_contact_forces"],
  "4-learning/4.1-rotations-done-properly.html": [
    "example-l4_1_helpers-compare",
    "example-l4_1_descent-steps",
  ],
  "5-manipulation/5.1-pick-and-place.html": ["example-l5_1_reach-step"],
};

const lessons = Object.keys(programs);
const sample = sampleOf(3);
const chosen = lessons.filter((_, i) => sample.all || i % 3 === sample.share);

// Solutions are folded away.
const unfold = () => document.querySelectorAll("details").forEach((one) => (one.open = true));

await testPrograms(async (visitor) => {
  // One reader, who keeps the headers from lesson to lesson.
  await visitor.visit(chosen[0], {}, async (page) => {
    for (const path of chosen) {
      await page.goto(visitor.address(path));
      await page.evaluate(unfold);
      for (const id of programs[path]) {
        const program = await Program.open(page, id);
        const said = await program.run();
        const same = /^It ran to the end\. It printed what the lesson’s printed\./.test(said);
        visitor.expect(same, path, `${id}: ${said}`);
        await program.button("Close").click();
      }
    }
  });
});
