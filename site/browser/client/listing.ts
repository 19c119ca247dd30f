// What listings get of a script. It comes by itself, as pages without code have no need of it, and none
// has before it is read.

import { addCopyButtons } from "./copying.js";
import { leadToLines, numberLines } from "./lines.js";
import { startParts } from "./parts.js";
import { offerMadePrograms, offerPrograms, openLinked } from "./programs.js";

startParts(addCopyButtons, numberLines, leadToLines, offerPrograms, offerMadePrograms, openLinked);
