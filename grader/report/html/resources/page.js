"use strict";

// Everything here only eases what the page shows without it.
for (const element of document.querySelectorAll("[data-script]")) element.hidden = false;
for (const element of document.querySelectorAll("details[data-close]")) element.open = false;
addEventListener("beforeprint", () => { for (const element of document.querySelectorAll("details")) element.open = true; });

const still = matchMedia("(prefers-reduced-motion: reduce)");

// Light or dark: as the system says until the button is used. Kept in memory only; a page from the disk has nowhere else.
function change_theme() {
  const dark = document.documentElement.dataset.theme ? document.documentElement.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  document.documentElement.dataset.theme = dark ? "light" : "dark";
}
document.getElementById("theme").addEventListener("click", change_theme);

// From check to check; units without one count as well.
const stops = [...document.querySelectorAll("section.unit")].flatMap((unit) => {
  const checks = [...unit.querySelectorAll("[data-check]")];
  return checks.length > 0 ? checks : [unit.querySelector("h2")];
});
let current = -1;

function show_position() {
  const position = document.getElementById("position");
  if (position) position.textContent = `${current < 0 ? "–" : current + 1} / ${stops.length}`;
}

function go(step) {
  if (stops.length === 0) return;
  current = current < 0 && step < 0 ? stops.length - 1 : (current + step + stops.length) % stops.length;
  stops[current].focus({ preventScroll: true });
  stops[current].scrollIntoView({ block: "start", behavior: still.matches ? "auto" : "smooth" });
  show_position();
}

show_position();
document.getElementById("next")?.addEventListener("click", () => go(1));
document.getElementById("previous")?.addEventListener("click", () => go(-1));
document.addEventListener("focusin", (event) => {
  const found = stops.findIndex((stop) => stop.contains(event.target));
  if (found >= 0) { current = found; show_position(); }
});

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("input:not([type=range]), textarea, select")) return;
  if (event.key === "j") go(1);
  else if (event.key === "k") go(-1);
  else if (event.key === "t") change_theme();
  else if (event.key === "b") toggle_blink();
  else if (event.key === "Escape") stop_blinking();
  else return;
  event.preventDefault();
});
