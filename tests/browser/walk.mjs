// Walks through pages in Chromium and reports their faults:
//
//   walk.mjs [--shots DIR] [--fits SELECTOR] [--pages N] [--parts N] PAGE...     PAGE a file or a URL
//
// Each page is opened 1300 and 390 px wide, in light and dark colours, and as it is printed, with everything unfolded.
// Prints one line with counts for each page, and one line for each fault: an error or a warning on the console, a
// request that fails or leaves the machine, a page wider than the screen, an issue that axe-core calls serious or
// critical. Exit code 1 if there is a fault. Before anything is unfolded, --shots keeps pictures and the PDF. The
// elements that --fits matches have to fit into 1300 x 1600 px, and the page has to print on at most --pages pages.
// --parts examines the colours of a long page only in so many parts of 800 elements, which are spread over the page.

import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { chromium } from "playwright-core";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const { values: options, positionals: pages } = parseArgs({
  allowPositionals: true,
  options: {
    shots: { type: "string" }, fits: { type: "string" },
    pages: { type: "string", default: "Infinity" }, parts: { type: "string", default: "Infinity" },
  },
});
for (const name of ["pages", "parts"]) if (!(options[name] >= 1)) throw new Error(`--${name} needs a number from 1`);
if (options.shots) mkdirSync(options.shots, { recursive: true });

const isLocal = (url) => /^(file|data|blob|about|devtools):|^https?:\/\/(localhost|127\.0\.0\.1)[:/]/.test(url);

/**
 * Runs in the page: returns the findings of axe-core. A report has 100 000 elements. Half of them are inside formulas;
 * these have the colour of their formula, so formulas become text first. The cost of the rules on colours grows with
 * everything that is laid out. Therefore these rules examine parts of 800 elements; each element is in one part, and
 * the other parts are out of the page. Of more than `most` parts, `most` are examined. Drawings are examined only by the
 * other rules, which examine the page as a whole, once for each width.
 */
async function violations({ withoutColours, most }) {
  document.querySelectorAll("math").forEach((math) => { math.textContent = math.textContent; });
  const run = async (rules) => (await axe.run(document, { ...rules, resultTypes: ["violations"], elementRef: false })).violations;
  const colours = ["color-contrast", "link-in-text-block"];
  const found = withoutColours ? await run({ rules: Object.fromEntries(colours.map((rule) => [rule, { enabled: false }])) }) : [];
  document.querySelectorAll("svg > *").forEach((part) => part.remove());

  const size = (element) => element.querySelectorAll("*").length + 1, large = 800, parts = [];
  let room = 0;
  (function divide(element) {
    if (size(element) > large && element.children.length) return [...element.children].forEach(divide);
    if (size(element) > room) room = parts.push([]) && large;
    room -= size(element);
    parts.at(-1).push(element);
  })(document.body);
  const empty = (element) => Object.assign(element.cloneNode(false), { style: "display: none" });
  const out = new Map(parts.flat().map((element) => [element, empty(element)]));
  out.forEach((instead, element) => element.replaceWith(instead));
  const count = Math.min(most, parts.length);
  for (const part of Array.from({ length: count }, (_, i) => parts[Math.floor((i * parts.length) / count)])) {
    part.forEach((element) => out.get(element).replaceWith(element));
    found.push(...(await run({ runOnly: colours })));
    part.forEach((element) => element.replaceWith(out.get(element)));
  }
  return found;
}

/** Returns the issues that axe-core calls serious or critical: one line for each rule, with the first places. */
async function issues(page, withoutColours) {
  await page.evaluate(axe);
  const rules = new Map();
  for (const { id, impact, nodes } of await page.evaluate(violations, { withoutColours, most: Number(options.parts) })) {
    if (impact !== "serious" && impact !== "critical") continue;
    const places = nodes.map(({ target, any }) => `${target.join(" ")} ${any[0]?.message ?? ""}`.trim());
    rules.set(`axe ${impact} ${id}`, [...(rules.get(`axe ${impact} ${id}`) ?? []), ...places]);
  }
  return [...rules].map(([rule, places]) => `${rule}, ${places.length} times: ${places.slice(0, 3).join(" | ")}`);
}

/** Returns the outermost elements that reach beyond the right edge of the page. */
const tooWide = () => {
  const edge = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth <= edge) return [];
  const beyond = [...document.body.querySelectorAll("*")].filter((e) => e.getBoundingClientRect().right > edge + 1);
  return beyond.slice(0, 3).map((e) => `wider than ${edge} px: ${e.tagName.toLowerCase()}#${e.id}.${e.className}`);
};

async function walk(browser, address) {
  const url = /^[a-z]+:\/\//.test(address) ? address : pathToFileURL(resolve(address)).href;
  const name = basename(new URL(url).pathname).replace(/\.\w+$/, "") || "index";
  const faults = new Set();
  let height = 0;
  let printed = 0;
  for (const [width, tall, colorScheme, media] of [[1300, 1600, "light"], [1300, 1600, "dark"], [390, 844, "light"],
    [390, 844, "dark"], [1300, 1600, "light", "print"]]) {
    const context = await browser.newContext({ viewport: { width, height: tall }, colorScheme });
    const page = await context.newPage();
    page.on("console", (message) => {
      if (["error", "warning"].includes(message.type())) faults.add(`console ${message.type()}: ${message.text()}`);
    });
    page.on("pageerror", (error) => faults.add(`uncaught: ${error.message}`));
    page.on("requestfailed", (request) => faults.add(`failed: ${request.url()}`));
    page.on("request", (request) => { if (!isLocal(request.url())) faults.add(`leaves the machine: ${request.url()}`); });
    await page.goto(url, { waitUntil: "load" });
    await page.waitForTimeout(300);
    if (options.fits && width === 1300 && !media) {
      for (const element of await page.locator(options.fits).all()) {
        const box = await element.boundingBox();
        const fits = box.width <= width && box.height <= tall;
        if (!fits) faults.add(`${options.fits} does not fit the screen: ${box.width} x ${box.height} px`);
      }
    }
    height ||= await page.evaluate(() => document.documentElement.scrollHeight);
    if (media) {
      const path = options.shots ? `${options.shots}/${name}.pdf` : undefined;
      const pdf = await page.pdf({ path, preferCSSPageSize: true });
      printed = (pdf.toString("latin1").match(/\/Type ?\/Page[^s]/g) ?? []).length;
      if (printed > Number(options.pages)) faults.add(`prints more than ${options.pages} pages`);
      await page.emulateMedia({ media, colorScheme });
    } else if (options.shots) {
      await page.screenshot({ path: `${options.shots}/${name}-${width}-${colorScheme}.png` });
    }
    await page.evaluate(() => document.querySelectorAll("details").forEach((fold) => { fold.open = true; }));
    const wide = media ? [] : await page.evaluate(tooWide);
    for (const fault of [...wide, ...(await issues(page, !media && colorScheme === "light"))])
      faults.add(`${media ?? `${width} px`}, ${colorScheme}: ${fault}`);
    await context.close();
  }
  console.log(`${address}: ${height} px high at 1300, ${printed} pages printed, ${faults.size} faults`);
  for (const fault of faults) console.log(`  ${fault}`);
  return faults.size;
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"],
});
let faults = 0;
for (const page of pages) faults += await walk(browser, page);
await browser.close();
process.exit(faults === 0 ? 0 : 1);
