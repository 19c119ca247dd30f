// html-validate finds nothing, in any file of HTML.

import { readFileSync } from "node:fs";

import {
  HtmlValidate,
  formatterFactory,
} from "../../../site/node_modules/html-validate/dist/esm/index.js";

const config = new URL("../../../site/.htmlvalidate.json", import.meta.url);
const validator = new HtmlValidate(JSON.parse(readFileSync(config, "utf8")));
const asText = formatterFactory("text");

async function source(page, { path, html, expect }) {
  const report = await validator.validateString(html, path);
  if (!report.valid || report.warningCount > 0) expect(false, asText(report.results));
}

export const kinds = ["page", "document", "moved", "missing"];
export const looks = { source };
// What decides beside this file.
export const settings = [config];
