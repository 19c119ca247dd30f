// What the tests of programs in the page share: they need a site whose programs can be run.

import { pagesWith, testSite } from "../browser.mjs";

// As testSite().
export async function testPrograms(test) {
  if (pagesWith("data-program=").length > 0) return testSite(test);
  console.log("the compiler for the browser was not built"); // then CTest skips the test
  process.exitCode = 1;
}
