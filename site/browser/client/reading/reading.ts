// The script that every page loads once it is shown: what was read is marked, and what is being read
// followed.

import { startParts } from "../parts.js";
import { followReading } from "./follow.js";
import { showSigns } from "./signs.js";

const lesson = document.querySelector<HTMLElement>("article.lesson");
const foot = lesson?.querySelector("footer.lesson-foot");
startParts(() => {
  if (lesson && foot) followReading(lesson, foot);
}, showSigns);
