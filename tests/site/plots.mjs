// Plots, on wide and narrow screens, light and dark, with and without JavaScript: each shows one
// drawing, whose text can be read, is in the site's sans and stays inside; its colours are the
// page's; no two ids are the same; the numbers can be downloaded.
//
//   node tests/site/plots.mjs SITE

import { pages, testSite } from "./browser.mjs";

const smallest = 11; // CSS pixels of a letter's size, as it is shown

// What is wrong with the plots of this page, and of their colours those that follow its scheme.
function look(smallest) {
  const wrong = [];
  const { scrollWidth, clientWidth } = document.documentElement;
  if (scrollWidth > clientWidth) wrong.push(`the page is ${scrollWidth} pixels wide`);
  const ids = [...document.querySelectorAll("[id]")].map(({ id }) => id);
  const twice = ids.filter((id, i) => ids.indexOf(id) !== i);
  if (twice.length > 0) wrong.push(`several have the id ${twice}`);
  const strokes = [];
  for (const plot of document.querySelectorAll(".plot")) {
    const shown = [...plot.querySelectorAll("svg")].filter((svg) => svg.checkVisibility());
    if (shown.length !== 1) wrong.push(`${plot.id} shows ${shown.length} drawings`);
    for (const svg of shown) lookAt(svg, plot.id);
  }
  return {
    wrong,
    strokes,
    plots: document.querySelectorAll(".plot").length,
  };

  function lookAt(svg, id) {
    const box = svg.getBoundingClientRect();
    const scale = box.width / svg.viewBox.baseVal.width;
    if (box.height < 100) wrong.push(`${id} is ${box.height} pixels high`);
    for (const text of svg.querySelectorAll("text")) {
      const { left, right, top, bottom } = text.getBoundingClientRect();
      const inside = left > box.left - 1 && right < box.right + 1;
      if (!inside || top < box.top - 1 || bottom > box.bottom + 1) {
        wrong.push(`${id}: "${text.textContent}" sticks out`);
      }
      const { fontSize, fontFamily } = getComputedStyle(text);
      if (parseFloat(fontSize) * scale < smallest)
        wrong.push(`${id}: "${text.textContent}" is small`);
      if (!fontFamily.startsWith('"Source Sans 3"')) wrong.push(`${id}: is set in ${fontFamily}`);
    }
    for (const part of svg.querySelectorAll('[stroke^="var(--data-"]')) {
      strokes.push(getComputedStyle(part).stroke);
    }
    const named = svg.innerHTML.matchAll(/url\(#([^)]*)\)/g);
    for (const [, name] of named) {
      if (svg.querySelector(`[id="${name}"]`) === null) wrong.push(`${id}: has no ${name}`);
    }
  }
}

await testSite(async (visitor) => {
  const drawings = { light: [], dark: [] };
  let plots = 0;
  for (const path of pages) {
    for (const scheme of ["light", "dark"]) {
      for (const javaScript of [true, false]) {
        await visitor.visit(path, { scheme, javaScript }, async (page) => {
          for (const width of [1440, 1000, 360]) {
            await page.setViewportSize({ width, height: 900 });
            const found = await page.evaluate(look, smallest);
            for (const wrong of found.wrong) {
              visitor.complain(`${path} (${scheme}, ${width} px)`, wrong);
            }
            drawings[scheme].push(...found.strokes);
            plots += found.plots;
          }
        });
      }
    }
    await visitor.visit(path, {}, async (page) => {
      for (const link of await page.locator(".plot-numbers a").all()) {
        const href = await link.getAttribute("href");
        const answer = await page.request.get(new URL(href, page.url()).href);
        const [names, ...rows] = (await answer.text()).trimEnd().split("\r\n");
        const columns = names.split(",").length;
        const whole = rows.length > 0 && rows.every((row) => row.split(",").length === columns);
        visitor.expect(answer.ok() && whole, path, `${href} is no table`);
      }
    });
  }
  visitor.expect(plots > 0, "the site", "has no plot");
  const { light, dark } = drawings;
  visitor.expect(new Set(light).size >= 4, "the site", `has lines in ${[...new Set(light)]} alone`);
  const same = light.length === dark.length && light.every((colour, i) => colour !== dark[i]);
  visitor.expect(same, "the site", "has lines whose colour does not follow the scheme");
});
