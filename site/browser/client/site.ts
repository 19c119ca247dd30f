// The script of every page. The site is complete without it; it is loaded in the head, so that the
// reader's theme is set before anything is painted.

import { followContents } from "./contents.js";
import { localizeDates } from "./dates.js";
import { listenToKeys } from "./keys.js";
import { upgradeLabs } from "./lab-loader.js";
import { loadListing } from "./listing-loader.js";
import { loadOffline } from "./offline/loader.js";
import { askForFonts } from "./page-fonts.js";
import { startParts } from "./parts.js";
import { upgradeQuizzes } from "./quiz/quiz.js";
import { loadReading } from "./reading/loader.js";
import { claimPage } from "./root.js";
import { reachScrollers } from "./scrollers.js";
import { addSearchButton, loadWhereNeeded } from "./search/opener.js";
import { explainTerms } from "./terms.js";
import { addThemeButton, applyTheme } from "./theme.js";

function begin(): void {
  startParts(
    addSearchButton,
    addThemeButton,
    listenToKeys,
    loadWhereNeeded,
    followContents,
    loadListing,
    reachScrollers,
    explainTerms,
    localizeDates,
    upgradeQuizzes,
    upgradeLabs,
    loadReading,
    loadOffline,
  );
}

if (claimPage()) {
  document.addEventListener("DOMContentLoaded", begin);
  startParts(applyTheme, askForFonts);
}
