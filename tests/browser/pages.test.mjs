// Rules that hold for every page, in both schemes, wide and narrow, with and without scripts.
import assert from "node:assert/strict";
import test from "node:test";
import { statSync } from "node:fs";
import { faults_of_access, faults_of_contrast, made_up, picture_check, reports, with_page } from "./browser.mjs";

const pages = {
  "every kind of evidence and the worst of texts": made_up("worst.html"),
  "the catalogue": made_up("catalogue.html"),
  "nothing at all": made_up("empty.html"),
  "the class": reports("index.html"),
  "all right": reports("ana-all-right/report.html"),
  "untouched": reports("bruno-untouched/report.html"),
  "mistakes": reports("carla-typical-mistakes/report.html"),
  "mistakes, for instructors": reports("carla-typical-mistakes/report.instructor.html"),
  "does not compile": reports("elena-does-not-compile/report.html"),
};

for (const [name, file] of Object.entries(pages))
  test(`${name}: read without eyes or mouse, in light and dark, at every width`, async () => {
    await with_page(file, {}, async (page) => {
      assert.deepEqual(await page.evaluate(faults_of_access), []);
      for (const colorScheme of ["light", "dark"]) {
        await page.emulateMedia({ colorScheme });
        assert.deepEqual(await page.evaluate(faults_of_contrast), [], colorScheme);
      }
      for (const width of [320, 360, 768, 1200, 1920]) {
        await page.setViewportSize({ width, height: 900 });
        const widest = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(widest <= width, `at ${width} pixels the page is ${widest} wide`);
      }
    });
  });

test("ten units fit into two megabytes", () => {
  const size = statSync(reports("carla-typical-mistakes/report.html")).size;
  // Two units that fail in all they can; what is right takes less.
  console.log(`${(size / 2 / 1024).toFixed(0)} KiB a failing unit`);
  assert.ok(5 * size < 2_000_000);
  assert.ok(statSync(reports("ana-all-right/report.html")).size < 200_000);
});

test("without scripts everything is there, and nothing that needs them", async () => {
  await with_page(made_up("worst.html"), { javaScriptEnabled: false }, async (page) => {
    for (const selector of ["figure.yours img", "figure.reference img", "figure.difference img", ".magnified img", "table.pixels", "table.rows", "table.matrix", "table.lines", ".sketch", ".plot"])
      assert.ok(await page.locator(selector).first().isVisible(), selector);
    assert.equal(await page.locator("button:visible").count(), 0, "buttons would do nothing");
    const boxes = await picture_check(page).locator(".pictures figure").evaluateAll((list) => list.map((one) => one.getBoundingClientRect()).map(({ x, y }) => `${Math.round(x)},${Math.round(y)}`));
    assert.equal(new Set(boxes).size, 3, "no picture lies on another");
    await page.locator("table.units a").first().click();
    assert.ok(page.url().endsWith("#u1"));
  });
});

test("on paper everything is there", async () => {
  await with_page(made_up("worst.html"), {}, async (page) => {
    await page.emulateMedia({ media: "print" });
    assert.equal(await page.locator("header.bar").isVisible(), false);
    assert.equal(await page.locator(".controls").first().isVisible(), false);
    const boxes = await picture_check(page).locator(".pictures figure").evaluateAll((list) => list.map((one) => `${one.getBoundingClientRect().x},${one.getBoundingClientRect().y}`));
    assert.equal(new Set(boxes).size, 3);
    assert.ok((await page.pdf()).length > 10_000);
  });
});

test("hidden values are in the instructor's edition only", async () => {
  const article = (page) => page.locator("article.check", { has: page.locator(".tag", { hasText: "hidden" }) });
  await with_page(reports("carla-typical-mistakes/report.html"), {}, async (page) => {
    for (const one of await article(page).all()) {
      assert.match(await one.innerText(), /practice inputs/, "shown for what practice inputs tell only");
      assert.equal(await one.locator("table, figure, .pictures").count(), 0, "without values that were graded");
    }
  });
  await with_page(reports("carla-typical-mistakes/report.instructor.html"), {}, async (page) => {
    assert.ok(await article(page).count() > 0);
    assert.ok(await article(page).locator("table").count() > 0, "with their values");
  });
});
