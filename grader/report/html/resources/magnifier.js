// Values of both sides at the pixel under the mouse, or where the arrow keys moved to.
function make_magnifier(box) {
  const data = box.dataset;
  const columns = Number(data.columns);
  const rows = Number(data.rows);
  const texts = data.texts.split("|");
  const list = (text) => text.split(" ").map(Number);
  const yours = list(data.yours);
  const reference = list(data.reference);
  const levels = list(data.levels);
  const panels = box.querySelector(".panels");
  const readout = box.querySelector("[data-readout]");
  const cursors = [];
  let at = { x: columns >> 1, y: rows >> 1 };

  for (const frame of panels.querySelectorAll(".frame")) {
    const drawing = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    drawing.setAttribute("viewBox", `0 0 ${columns} ${rows}`);
    drawing.setAttribute("class", "mark");
    drawing.setAttribute("aria-hidden", "true");
    const cursor = document.createElementNS("http://www.w3.org/2000/svg", "rect");
    for (const [name, value] of [["class", "cursor"], ["width", "1"], ["height", "1"], ["visibility", "hidden"]]) cursor.setAttribute(name, value);
    drawing.append(cursor);
    frame.append(drawing);
    cursors.push(cursor);
    frame.addEventListener("pointermove", (event) => {
      const area = frame.getBoundingClientRect();
      show(Math.floor((event.clientX - area.left) / area.width * columns), Math.floor((event.clientY - area.top) / area.height * rows));
    });
  }

  function piece(name, text) {
    const element = document.createElement(name);
    element.textContent = text;
    return element;
  }

  function show(x, y) {
    at = { x: Math.min(Math.max(x, 0), columns - 1), y: Math.min(Math.max(y, 0), rows - 1) };
    const place = at.y * columns + at.x;
    for (const cursor of cursors) {
      cursor.setAttribute("x", at.x);
      cursor.setAttribute("y", at.y);
      cursor.setAttribute("visibility", "visible");
    }
    const difference = levels[place] === 0 ? "equal" : data.graded === "1" ? `difference ${levels[place]} of 255` : "differs";
    const left = piece("b", "yours ");
    const right = piece("b", `${data.other} `);
    left.className = "of-yours";
    right.className = "of-reference";
    readout.replaceChildren(`pixel (${Number(data.x) + at.x}, ${Number(data.y) + at.y}): `, left, piece("code", texts[yours[place]]), "  ", right,
                            piece("code", texts[reference[place]]), `  ${difference}`);
  }

  panels.tabIndex = 0;
  panels.setAttribute("role", "application");
  panels.setAttribute("aria-label", "Magnified pixels; the arrow keys move, the values are said below");
  readout.setAttribute("aria-live", "polite");
  panels.addEventListener("focus", () => show(at.x, at.y));
  panels.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step) return;
    show(at.x + step[0], at.y + step[1]);
    event.preventDefault();
  });
}

for (const box of document.querySelectorAll("[data-magnified]")) make_magnifier(box);
