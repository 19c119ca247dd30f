// What a stranger's lesson could put into a page does nothing in its reader's browser: the page's policy
// lets no script run that is not the site's, no address begin elsewhere, and no form go elsewhere.

import { globSync, readFileSync } from "node:fs";
import { join } from "node:path";

import { folder, pages, testSite } from "./browser.mjs";

// Gives what came of each attack.
async function attack() {
  const refused = [];
  document.addEventListener("securitypolicyviolation", ({ effectiveDirective }) =>
    refused.push(effectiveDirective),
  );
  const put = (html) => {
    const place = document.createElement("div");
    place.innerHTML = html;
    document.body.append(place);
    return place.firstElementChild;
  };
  put('<base href="https://elsewhere.invalid/">');
  put('<a href="javascript:globalThis.attacked = true">here</a>').click();
  put('<img src="nowhere.png" onerror="globalThis.attacked = true">');
  put('<form action="https://elsewhere.invalid/"><input name="a"></form>').submit();
  const script = document.createElement("script");
  script.text = "globalThis.attacked = true";
  document.body.append(script);
  await new Promise((resolve) => setTimeout(resolve, 300));
  return {
    attacked: globalThis.attacked === true,
    base: document.baseURI === location.href,
    refused: [...new Set(refused)].sort().join(" "),
  };
}

const policy = /<meta http-equiv="Content-Security-Policy" content="([^"]*)">/;

await testSite(async (visitor) => {
  // Also those that nobody can stay on, that are shown for others, or printed.
  for (const path of globSync("**/*.html", { cwd: folder })) {
    const said = policy.exec(readFileSync(join(folder, path), "utf8"))?.[1] ?? "";
    for (const rule of ["default-src 'self'", "script-src 'self'", "base-uri 'none'"]) {
      visitor.expect(said.includes(rule), path, `its policy has no ${rule}`);
    }
  }
  // One page of each folder, as the policy is its template's.
  const kinds = new Map(pages.map((path) => [path.replace(/[^/]*$/, ""), path]));
  for (const path of kinds.values()) {
    await visitor.visit(path, {}, async (page) => {
      page.removeAllListeners(); // the browser says aloud what it refuses
      const left = () => ({ refused: "no form, which leads elsewhere" });
      const { attacked, base, refused } = await page.evaluate(attack).catch(left);
      visitor.expect(!attacked, path, "a foreign script runs");
      visitor.expect(base, path, "a foreign address is its base");
      const all = "base-uri form-action script-src-attr script-src-elem";
      visitor.expect(refused === all, path, `only refuses ${refused}`);
    });
  }
});
