// The class's page: sort, filter, links.
import assert from "node:assert/strict";
import test from "node:test";
import { existsSync } from "node:fs";
import { made_up, reports, with_page } from "./browser.mjs";

const names = (page) => page.locator("table.class tbody tr:visible th").evaluateAll((list) => list.map((one) => one.dataset.sort));

test("columns sort, and say how", async () => {
  await with_page(reports("index.html"), {}, async (page) => {
    const all = await names(page);
    assert.deepEqual(all, [...all].sort());
    const total = page.getByRole("button", { name: "Total" });
    await total.click();
    assert.equal((await names(page))[0], "ana-all-right", "the most points first");
    assert.equal(await page.locator("th", { has: total }).getAttribute("aria-sort"), "descending");
    await total.focus();
    await page.keyboard.press("Enter");
    assert.equal((await names(page)).at(-1), "ana-all-right");
    assert.equal(await page.locator("th[aria-sort]").count(), 1);
    await page.getByRole("button", { name: "Submission" }).click();
    assert.deepEqual(await names(page), all);
  });
});

test("the filter keeps what holds every word", async () => {
  await with_page(reports("index.html"), {}, async (page) => {
    const filter = page.getByLabel("Show only");
    await filter.fill("COMPILE");
    assert.deepEqual(await names(page), ["elena-does-not-compile"]);
    assert.equal(await page.locator("#shown").textContent(), "1 of 4");
    await filter.fill("carla partly");
    assert.deepEqual(await names(page), ["carla-typical-mistakes"]);
    await filter.fill("jtk");
    assert.deepEqual(await names(page), [], "letters in the box are letters, not commands");
    await filter.fill("");
    assert.equal((await names(page)).length, 4);
  });
});

test("every link leads to a file", async () => {
  await with_page(reports("index.html"), {}, async (page) => {
    const links = await page.locator("main a").evaluateAll((list) => list.map((one) => one.getAttribute("href")));
    assert.ok(links.length > 15);
    for (const link of links) assert.ok(existsSync(reports(link.split("#")[0])), link);
    await page.locator("table.class a[href='carla-typical-mistakes/report.html#u2']").click();
    assert.equal(await page.locator("h1").textContent(), "carla-typical-mistakes");
    assert.ok(page.url().endsWith("#u2"));
  });
});

test("the class knows who made which mistake", async () => {
  await with_page(reports("index.html"), {}, async (page) => {
    const clusters = await page.locator(".clusters").allTextContents();
    assert.equal(clusters.length, 2, "one list a unit");
    for (const list of clusters) assert.ok(list.includes("carla-typical-mistakes"), list);
    assert.ok(await page.locator("table.statistics tbody tr").count() === 2);
  });
});

for (const units of [1, 8, 46])
  for (const width of [1280, 800])
    test(`all of ${units} units can be reached at ${width} pixels, under their names and beside the students'`, async () => {
      await with_page(made_up(`class-${units}.html`), { width }, async (page) => {
        const seen = await page.evaluate(() => {
          const frame = document.querySelector("table.class").parentElement;
          frame.scrollTo(1e6, 1e6);
          const box = frame.getBoundingClientRect();
          const of = (selector) => document.querySelector(selector).getBoundingClientRect();
          return {
            sideways: document.documentElement.scrollWidth - document.documentElement.clientWidth,
            left: box.left, right: innerWidth - box.right,
            last: box.right - of("table.class tbody tr:last-child td:last-child").right,
            below: box.bottom - of("table.class tbody tr:last-child td:last-child").bottom,
            name: of("table.class tbody tr:last-child th").left - box.left,
            head: of("table.class thead th:last-child").top - box.top,
            corner: of("table.class thead th:first-child").left - box.left,
          };
        });
        assert.ok(seen.sideways <= 0, "the page itself does not scroll sideways");
        assert.ok(seen.left >= 0 && seen.right >= 0, "the frame lies in the window");
        assert.ok(seen.last >= 0 && seen.below >= 0, "the last cell can be scrolled into the frame");
        for (const edge of ["name", "head", "corner"]) assert.ok(Math.abs(seen[edge]) <= 2, `${edge}: stays at the frame's edge, ${seen[edge]}`);
      });
    });
