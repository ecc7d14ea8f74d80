// The class's page: sort, filter, links.
import assert from "node:assert/strict";
import test from "node:test";
import { existsSync } from "node:fs";
import { reports, with_page } from "./browser.mjs";

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
