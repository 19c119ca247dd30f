/** highlight.js with the languages of the course: `highlight(code, language)` gives HTML. */
import hljs from "highlight.js/lib/core";
import bash from "highlight.js/lib/languages/bash";
import c from "highlight.js/lib/languages/c";
import cmake from "highlight.js/lib/languages/cmake";
import cpp from "highlight.js/lib/languages/cpp";
import javascript from "highlight.js/lib/languages/javascript";
import json from "highlight.js/lib/languages/json";
import markdown from "highlight.js/lib/languages/markdown";
import plaintext from "highlight.js/lib/languages/plaintext";
import python from "highlight.js/lib/languages/python";
import xml from "highlight.js/lib/languages/xml";
import yaml from "highlight.js/lib/languages/yaml";

import { compiled } from "../compiled-grammar.js";
import { HtmlEmitter } from "../html-emitter.js";
import { lesson } from "../lesson-language.js";

const languages = {
  bash,
  c,
  cmake,
  cpp,
  javascript,
  json,
  lesson,
  markdown,
  plaintext,
  python,
  xml,
  yaml,
};
hljs.configure({ __emitter: HtmlEmitter });
for (const [name, language] of Object.entries(languages)) {
  hljs.registerLanguage(name, compiled(language));
}

/** A language that is not here gives the code escaped and plain. */
function highlight(code: string, language: string): string {
  const known = hljs.getLanguage(language) === undefined ? "plaintext" : language;
  return hljs.highlight(code, { language: known, ignoreIllegals: true }).value;
}

Object.assign(globalThis, { highlight });
