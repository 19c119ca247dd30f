// The script of every page. The site is complete without it; it is loaded in the head, so that the
// reader's theme is set before anything is painted.

import { followContents } from "./contents.js";
import { upgradeLabs } from "./lab-loader.js";
import { upgradeQuizzes } from "./quiz/quiz.js";
import { reachScrollers } from "./scrollers.js";
import { addThemeButton, applyTheme } from "./theme.js";

applyTheme();
document.addEventListener("DOMContentLoaded", () => {
  addThemeButton();
  followContents();
  reachScrollers();
  upgradeQuizzes();
  upgradeLabs();
});
