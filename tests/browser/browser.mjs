// What all browser tests share: one browser, pages that notice every error and every request, and rules that hold for every page.
import assert from "node:assert/strict";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import path from "node:path";
import { chromium } from "playwright-core";

let browser;
before(async () => {
  browser = await chromium.launch({
    executablePath: process.env.UMBRAL_BROWSER,
    args: ["--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--no-first-run",
           "--disable-default-apps", "--disable-dev-shm-usage"],
  });
});
after(() => browser.close());

export const made_up = (name) => path.join(process.env.UMBRAL_PAGES, "made-up", name);
export const reports = (name) => path.join(process.env.UMBRAL_PAGES, "reports", name);

/** The made-up page's first check that compares pictures in colour; intermediate buffers stand before it. */
export const picture_check = (page) => page.getByRole("article", { name: "picture/colours" }).first();

/** Opens a page from the disk, runs `work`, and fails if the page logged, threw, or asked for anything but itself. */
export async function with_page(file, options, work) {
  const { width = 1200, height = 900, ...context_options } = options;
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: false, ...context_options });
  context.setDefaultTimeout(120_000);  // a busy machine is slow, not wrong
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => complaints.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => complaints.push(`error: ${error.message}`));
  page.on("dialog", (dialog) => { complaints.push(`dialog: ${dialog.message()}`); void dialog.dismiss(); });
  page.on("request", (request) => {
    if (!request.url().startsWith("data:") && !request.url().startsWith("file:")) complaints.push(`request: ${request.url()}`);
    if (request.url().startsWith("file:") && !request.isNavigationRequest()) complaints.push(`request: ${request.url()}`);
  });
  try {
    await page.goto(pathToFileURL(file).href);
    await work(page);
  } finally {
    await context.close();
  }
  assert.deepEqual(complaints, []);
}

/** What a reader without eyes or mouse needs; checked in the page. Returns sentences, one a fault. */
export function faults_of_access() {
  const faults = [];
  const seen = (element) => element.checkVisibility?.() ?? true;
  const about = (element) => element.outerHTML.slice(0, 90);
  const ids = [...document.querySelectorAll("[id]")].map((element) => element.id);
  for (const id of new Set(ids)) if (ids.filter((other) => other === id).length > 1) faults.push(`id twice: ${id}`);
  for (const element of document.querySelectorAll("[aria-labelledby]"))
    for (const id of element.getAttribute("aria-labelledby").split(" ")) if (!ids.includes(id)) faults.push(`labelled by nothing: ${id}`);

  for (const image of document.images) {
    if (!image.getAttribute("alt")?.trim()) faults.push(`no alt: ${about(image)}`);
    if (!image.complete || image.naturalWidth === 0) faults.push(`not shown: ${about(image)}`);
  }
  for (const svg of document.querySelectorAll("svg"))
    if (svg.getAttribute("aria-hidden") !== "true" && !svg.getAttribute("aria-label")) faults.push(`a drawing without a name: ${about(svg)}`);

  const name_of = (element) => (element.getAttribute("aria-label") ?? element.labels?.[0]?.textContent ?? element.textContent).trim();
  for (const control of document.querySelectorAll("a[href], button, input, summary, [tabindex='0']:not(pre)"))
    if (seen(control) && !name_of(control)) faults.push(`no name: ${about(control)}`);
  for (const link of document.querySelectorAll("a[href^='#']")) if (!document.getElementById(link.getAttribute("href").slice(1))) faults.push(`leads nowhere: ${about(link)}`);

  let level = 0;
  const headings = [...document.querySelectorAll("h1, h2, h3, h4, h5, h6")];
  if (document.querySelectorAll("h1").length !== 1) faults.push("not one h1");
  for (const heading of headings) {
    const next = Number(heading.tagName[1]);
    if (next > level + 1) faults.push(`h${level} is followed by h${next}: ${heading.textContent.slice(0, 40)}`);
    if (!heading.textContent.trim()) faults.push("an empty heading");
    level = next;
  }
  for (const table of document.querySelectorAll("table:not(.matrix)")) if (!table.querySelector("th[scope]")) faults.push(`a table without headers: ${about(table)}`);
  for (const landmark of ["main", "header", "footer"]) if (!document.querySelector(landmark)) faults.push(`no ${landmark}`);
  if (document.documentElement.lang === "" || document.title === "") faults.push("no language or title");
  return faults;
}

/** Contrast of every visible text against its ground, by WCAG 2: returns what is below 4.5 (3 for large text). */
export function faults_of_contrast() {
  // Colours in any notation, as bytes: the browser itself draws one pixel of each.
  const canvas = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });
  const bytes_of = (colour) => {
    canvas.clearRect(0, 0, 1, 1);
    canvas.fillStyle = colour;
    canvas.fillRect(0, 0, 1, 1);
    return [...canvas.getImageData(0, 0, 1, 1).data];
  };
  const luminance = ([r, g, b]) => {
    const light = (value) => value <= 0.04045 * 255 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4;
    return 0.2126 * light(r) + 0.7152 * light(g) + 0.0722 * light(b);
  };
  const ground_of = (element) => {
    for (let one = element; one; one = one.parentElement) {
      const colour = bytes_of(getComputedStyle(one).backgroundColor);
      if (colour[3] > 200) return colour;
    }
    return [255, 255, 255, 255];
  };
  const faults = new Set();
  for (const element of document.querySelectorAll("body *")) {
    const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim() !== "");
    if (!own || !element.checkVisibility() || element.closest("svg, .aside, .skip, header.bar, .none")) continue;
    const style = getComputedStyle(element);
    const [a, b] = [luminance(bytes_of(style.color)), luminance(ground_of(element))].sort((x, y) => y - x);
    const ratio = (a + 0.05) / (b + 0.05);
    const large = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.66 && Number(style.fontWeight) >= 600);
    if (ratio < (large ? 3 : 4.5)) faults.add(`${ratio.toFixed(2)} ${element.tagName}.${element.className}: ${element.textContent.trim().slice(0, 30)}`);
  }
  return [...faults];
}
