// A stylesheet that is edited where it is. Loading it anew would have the browser work out each
// element's style again, and load all fonts; so only the rules that are others are replaced.

type Rules = CSSStyleSheet | CSSGroupingRule;

// To write them out takes longer than to compare them.
const written = new WeakMap<Rules, readonly string[]>();

function textsOf(rules: Rules): readonly string[] {
  const known = written.get(rules);
  if (known) return known;
  const texts = [...rules.cssRules].map(({ cssText }) => cssText);
  written.set(rules, texts);
  return texts;
}

/** Two blocks of rules that are the same but for what is in them. */
function isSameBlock(a: CSSRule, b: CSSRule): boolean {
  const head = (rule: CSSRule): string => rule.cssText.slice(0, rule.cssText.indexOf("{"));
  return a instanceof CSSGroupingRule && a.constructor === b.constructor && head(a) === head(b);
}

/** Gives `sheet`, which has the rules of `old`, those of `young`. Throws where one cannot be put in
 *  its place. What was `young` once can be `old` later, as long as nobody changes it. */
export function giveRules(sheet: Rules, old: Rules, young: Rules): void {
  const before = textsOf(old);
  const after = textsOf(young);
  const most = Math.min(before.length, after.length);
  let head = 0;
  while (head < most && before[head] === after[head]) head++;
  let tail = 0;
  while (tail < most - head && before.at(-1 - tail) === after.at(-1 - tail)) tail++;
  const gone = before.length - tail;
  const come = after.length - tail;
  for (let at = head; at < Math.max(gone, come); at++) {
    const now = sheet.cssRules[at];
    if (at < gone && at < come && isSameBlock(now!, young.cssRules[at]!)) {
      const [a, b, c] = [now, old.cssRules[at], young.cssRules[at]];
      giveRules(a as CSSGroupingRule, b as CSSGroupingRule, c as CSSGroupingRule);
      continue;
    }
    if (at < gone) sheet.deleteRule(Math.min(at, come));
    if (at < come) sheet.insertRule(after[at]!, at);
  }
}
