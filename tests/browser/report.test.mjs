// Every control of a report, by mouse and by keys.
import assert from "node:assert/strict";
import test from "node:test";
import { made_up, picture_check, reports, with_page } from "./browser.mjs";

const report = reports("carla-typical-mistakes/report.html");
const focused = (page) => page.evaluate(() => document.activeElement.id || document.activeElement.className);

/** Colour of the page's own pixel at a place, from a screenshot. */
async function pixel(page, x, y) {
  const shot = await page.screenshot({ clip: { x, y, width: 1, height: 1 } });
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d");
    canvas.drawImage(image, 0, 0);
    return [...canvas.getImageData(0, 0, 1, 1).data].slice(0, 3).join();
  }, shot.toString("base64"));
}

test("the first key reaches the skip link, and the skip link the results", async () => {
  await with_page(report, {}, async (page) => {
    await page.keyboard.press("Tab");
    assert.equal(await focused(page), "skip");
    assert.ok((await page.locator(".skip").boundingBox()).y >= 0, "it is seen when it has the focus");
    await page.keyboard.press("Enter");
    assert.equal(await focused(page), "main");
  });
});

test("j, k and the buttons go from check to check", async () => {
  await with_page(report, { reducedMotion: "reduce" }, async (page) => {
    await page.keyboard.press("j");
    assert.equal(await focused(page), "u1-c1");
    await page.keyboard.press("j");
    assert.equal(await focused(page), "u1-c2");
    assert.match(await page.locator("#position").textContent(), /^2 \/ \d+$/);
    const top = (await page.locator("#u1-c2").boundingBox()).y;
    assert.ok(top >= 40 && top < 140, `below the bar, not under it: ${top}`);
    await page.keyboard.press("k");
    assert.equal(await focused(page), "u1-c1");
    await page.getByRole("button", { name: "Next check" }).click();
    assert.match(await page.locator("#position").textContent(), /^2 \//);
    await page.getByRole("button", { name: "Previous check" }).click();
    assert.match(await page.locator("#position").textContent(), /^1 \//);
  });
  await with_page(reports("elena-does-not-compile/report.html"), {}, async (page) => {
    await page.keyboard.press("j");
    assert.equal(await focused(page), "u1-title", "a unit without checks counts as well");
    await page.keyboard.press("k");
    assert.equal(await focused(page), "u2-title", "round to the last");
  });
});

test("the wipe follows the mouse", async () => {
  await with_page(made_up("worst.html"), { reducedMotion: "reduce" }, async (page) => {
    const wiper = picture_check(page).locator(".wiper");
    await wiper.scrollIntoViewIfNeeded();
    const box = await wiper.boundingBox();
    const frame = await picture_check(page).locator(".stage figure.reference .frame").boundingBox();
    assert.ok(Math.abs(box.x - frame.x) < 1 && Math.abs(box.width - frame.width) < 1 && Math.abs(box.height - frame.height) < 1, "it lies on the picture");
    await page.mouse.move(box.x + box.width / 2, box.y + 20);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.9, box.y + 20, { steps: 4 });
    await page.mouse.up();
    assert.ok(Math.abs(Number(await wiper.inputValue()) - 90) < 2, await wiper.inputValue());
    // A place where the two differ: left of the line it shows yours, right of it the reference.
    const place = [box.x + box.width * 0.6, box.y + box.height * 0.5];
    const of_yours = await pixel(page, ...place);
    await page.mouse.click(box.x + box.width * 0.2, box.y + 20);
    assert.ok(Math.abs(Number(await wiper.inputValue()) - 20) < 2);
    assert.notEqual(await pixel(page, ...place), of_yours);
  });
});

test("the wipe follows the arrow keys and says where it is", async () => {
  await with_page(made_up("worst.html"), {}, async (page) => {
    const wiper = picture_check(page).locator(".wiper");
    await wiper.focus();
    assert.equal(await wiper.inputValue(), "50");
    for (const [key, value] of [["ArrowRight", 52], ["ArrowLeft", 50], ["PageDown", 40], ["Home", 0], ["ArrowLeft", 0], ["End", 100], ["ArrowRight", 100]]) {
      await page.keyboard.press(key);
      assert.equal(Number(await wiper.inputValue()), value, key);
    }
    assert.match(await wiper.getAttribute("aria-valuetext"), /yours .* 100 %/);
  });
});

test("the wipe follows a finger", async () => {
  await with_page(made_up("worst.html"), { hasTouch: true, width: 400 }, async (page) => {
    const wiper = picture_check(page).locator(".wiper");
    await wiper.scrollIntoViewIfNeeded();
    const box = await wiper.boundingBox();
    await page.touchscreen.tap(box.x + box.width * 0.25, box.y + box.height / 2);
    assert.ok(Math.abs(Number(await wiper.inputValue()) - 25) < 3, await wiper.inputValue());
  });
});

test("blink changes the pictures, and stops by button, by key and by Escape", async () => {
  await with_page(made_up("worst.html"), { reducedMotion: "no-preference" }, async (page) => {
    const article = picture_check(page);
    const blink = article.getByRole("button", { name: "Blink" });
    const second = () => article.locator(".stage").evaluate((stage) => stage.classList.contains("second"));
    const changes = async () => {
      const before = await second();
      for (let i = 0; i < 20; ++i) {
        await page.waitForTimeout(100);
        if (await second() !== before) return true;
      }
      return false;
    };
    await blink.click();
    assert.equal(await blink.getAttribute("aria-pressed"), "true");
    assert.ok(await changes(), "it blinks");
    await page.keyboard.press("Escape");
    assert.equal(await changes(), false, "Escape stops it");
    await article.getByRole("button", { name: "Wipe" }).click();
    await page.keyboard.press("b");
    assert.ok(await changes(), "b begins");
    await page.keyboard.press("b");
    assert.equal(await changes(), false, "b ends");
    assert.equal(await article.getByRole("button", { name: "Wipe" }).getAttribute("aria-pressed"), "true");
    await blink.click();
    await blink.click();
    assert.equal(await changes(), false, "the button ends");
  });
});

test("nothing moves by itself where less motion is asked for", async () => {
  await with_page(made_up("worst.html"), { reducedMotion: "reduce" }, async (page) => {
    const article = picture_check(page);
    const blink = article.getByRole("button", { name: "Blink" });
    const second = () => article.locator(".stage").evaluate((stage) => stage.classList.contains("second"));
    await blink.click();
    assert.equal(await second(), false);
    await page.waitForTimeout(1800);
    assert.equal(await second(), false, "time changes nothing");
    await blink.click();
    assert.equal(await second(), true, "a press does");
    await blink.click();
    assert.equal(await second(), false);
  });
});

test("side by side shows both pictures whole", async () => {
  await with_page(made_up("worst.html"), { width: 1900 }, async (page) => {
    const article = picture_check(page);
    await article.getByRole("button", { name: "Side by side" }).click();
    const yours = await article.locator(".pictures figure.yours").boundingBox();
    const reference = await article.locator(".pictures figure.reference").boundingBox();
    assert.ok(yours.x + yours.width <= reference.x + 1 || yours.y + yours.height <= reference.y + 1, "beside or below each other");
    assert.equal(await article.locator(".wiper").isVisible(), false);
  });
});

test("light and dark by the button and by key", async () => {
  await with_page(report, { colorScheme: "light" }, async (page) => {
    const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await ground();
    await page.locator("#theme").click();
    const dark = await ground();
    assert.notEqual(dark, light);
    await page.keyboard.press("t");
    assert.equal(await ground(), light);
  });
  await with_page(report, { colorScheme: "dark" }, async (page) => {
    const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const dark = await ground();
    await page.locator("#theme").click();
    assert.notEqual(await ground(), dark, "the first press changes what is seen, whatever the system says");
  });
});

test("magnified pixels tell both values, by mouse and by keys", async () => {
  await with_page(made_up("worst.html"), {}, async (page) => {
    const box = picture_check(page).locator(".magnified");
    const readout = box.locator("[data-readout]");
    await box.scrollIntoViewIfNeeded();
    const frame = await box.locator(".frame").first().boundingBox();
    const [x, y, columns] = await box.evaluate((element) => [element.dataset.x, element.dataset.y, element.dataset.columns].map(Number));
    await page.mouse.move(frame.x + frame.width * 2.5 / columns, frame.y + frame.width * 3.5 / columns);
    assert.match(await readout.textContent(), new RegExp(`^pixel \\(${x + 2}, ${y + 3}\\): yours \\(.*\\) +reference \\(.*\\)`));
    await box.locator(".panels").focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowDown");
    assert.match(await readout.textContent(), new RegExp(`^pixel \\(${x + 3}, ${y + 4}\\)`));
    for (let i = 0; i < 40; ++i) await page.keyboard.press("ArrowLeft");
    assert.match(await readout.textContent(), new RegExp(`^pixel \\(${x}, `), "it stops at the edge");
    // What the readout says is what the picture shows.
    const shown = await box.evaluate(async (element) => {
      const image = element.querySelector("figure.yours img");
      const canvas = Object.assign(document.createElement("canvas"), { width: image.naturalWidth, height: image.naturalHeight }).getContext("2d");
      canvas.drawImage(image, 0, 0);
      return [...canvas.getImageData(0, 4, 1, 1).data];
    });
    assert.ok((await readout.textContent()).includes(`yours (${shown.join(", ")})`), `${shown} in ${await readout.textContent()}`);
  });
});

test("the table of pixels opens and closes", async () => {
  await with_page(made_up("worst.html"), {}, async (page) => {
    const details = picture_check(page).locator("details");
    assert.equal(await details.getAttribute("open"), null, "closed at first where scripts run");
    await details.locator("summary").focus();
    await page.keyboard.press("Enter");
    assert.ok(await details.locator("table.pixels").isVisible());
  });
});

test("every stop of the Tab key is seen", async () => {
  await with_page(report, {}, async (page) => {
    let stops = 0;
    for (; stops < 60; ++stops) {
      await page.keyboard.press("Tab");
      const stop = await page.evaluate(() => {
        const element = document.activeElement;
        const style = getComputedStyle(element);
        return { name: element.tagName, about: element.outerHTML.slice(0, 80), width: parseFloat(style.outlineWidth), style: style.outlineStyle };
      });
      if (stop.name === "BODY") break;  // round
      assert.ok(stop.style !== "none" && stop.width >= 2, `no outline: ${stop.about}`);
    }
    assert.ok(stops > 15, `only ${stops} stops`);
  });
});

test("every kind of evidence is there", async () => {
  await with_page(made_up("worst.html"), {}, async (page) => {
    for (const selector of ["table.rows mark", "table.matrix mark", "table.lines .missing", "table.lines .extra", "table.lines .changed", "table.lines .omitted", ".fragments img", "pre.sketch",
                            ".plot .curve.of-yours", ".legend rect", ".scale", ".times", ".metrics"])
      assert.ok(await page.locator(selector).count() > 0, selector);
  });
});
