// Two pictures on one spot: a wipe that follows mouse, finger and arrow keys, or one after the other.
const blinking = new Map();
const blink_milliseconds = 700;  // well under three changes a second

function stop_blinking(comparison) {
  for (const one of comparison ? [comparison] : [...blinking.keys()]) {
    clearInterval(blinking.get(one));
    blinking.delete(one);
  }
}

function set_view(comparison, view) {
  const pictures = comparison.querySelector(".pictures");
  const stage = comparison.querySelector(".stage");
  const status = comparison.querySelector(".status");
  const was_blink = pictures.classList.contains("blink");
  stop_blinking(comparison);
  pictures.classList.toggle("overlay", view !== "beside");
  pictures.classList.toggle("wipe", view === "wipe");
  pictures.classList.toggle("blink", view === "blink");
  for (const button of comparison.querySelectorAll(".controls button")) button.setAttribute("aria-pressed", String(button.dataset.view === view));
  status.textContent = "";
  if (view !== "blink") return stage.classList.remove("second");
  // Without motion each press changes the picture; otherwise time does.
  if (still.matches) {
    const other = comparison.querySelector("figure.reference figcaption").textContent;
    if (was_blink) stage.classList.toggle("second");
    status.textContent = stage.classList.contains("second") ? `${other}; press again to change` : "yours; press again to change";
  } else {
    status.textContent = "press Escape to stop";
    blinking.set(comparison, setInterval(() => stage.classList.toggle("second"), blink_milliseconds));
  }
}

// The comparison that a key means: the one with the focus, else the one nearest to the middle of the window.
function comparison_in_view() {
  const of_focus = document.activeElement?.closest("[data-check]")?.querySelector("[data-comparison]");
  if (of_focus) return of_focus;
  const distance = (element) => {
    const box = element.getBoundingClientRect();
    return Math.abs((box.top + box.bottom) / 2 - innerHeight / 2);
  };
  return [...document.querySelectorAll("[data-comparison]")].sort((a, b) => distance(a) - distance(b))[0];
}

function toggle_blink() {
  const comparison = comparison_in_view();
  if (!comparison) return;
  set_view(comparison, blinking.has(comparison) ? "wipe" : "blink");
}

function make_stage(comparison) {
  const stage = document.createElement("div");
  stage.className = "stage";
  const yours = comparison.querySelector("figure.yours");
  const reference = comparison.querySelector("figure.reference");
  yours.before(stage);
  stage.append(yours, reference);

  const wiper = document.createElement("input");
  Object.assign(wiper, { type: "range", min: "0", max: "100", step: "0.5", value: "50", className: "wiper" });
  const caption = reference.querySelector("figcaption").textContent;
  const other = caption === "reference" ? "the reference" : caption;
  wiper.setAttribute("aria-label", `Wipe between yours and ${other}`);
  const follow = () => {
    stage.style.setProperty("--cut", `${wiper.value}%`);
    wiper.setAttribute("aria-valuetext", `yours on the left ${Math.round(wiper.value)} %, ${other} on the rest`);
  };
  wiper.addEventListener("input", follow);
  // A step of half a percent is for the mouse; a key moves by two.
  wiper.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -2, ArrowDown: -2, ArrowRight: 2, ArrowUp: 2, PageDown: -10, PageUp: 10 }[event.key];
    if (step === undefined) return;
    wiper.value = String(Number(wiper.value) + step);
    follow();
    event.preventDefault();
  });
  follow();
  reference.querySelector(".frame").append(wiper);
  for (const button of comparison.querySelectorAll(".controls button")) button.addEventListener("click", () => {
    set_view(comparison, button.dataset.view === "blink" && blinking.has(comparison) ? "wipe" : button.dataset.view);
  });
  set_view(comparison, "wipe");
}

for (const comparison of document.querySelectorAll("[data-comparison]")) make_stage(comparison);
