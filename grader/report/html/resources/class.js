// The class's table: sorted by a column, and only the rows that hold a word.
for (const table of document.querySelectorAll("[data-sortable]")) {
  const body = table.tBodies[0];
  const heads = [...table.tHead.rows[0].cells];
  const key = (row, column) => row.cells[column].dataset.sort;

  function sort(column, descending) {
    // Names in the order of the language, points as numbers; equal ones keep their order.
    const as_number = [...body.rows].every((row) => !Number.isNaN(Number(key(row, column))));
    const compare = (a, b) => as_number ? Number(key(a, column)) - Number(key(b, column)) : key(a, column).localeCompare(key(b, column), undefined, { numeric: true });
    const rows = [...body.rows].sort((a, b) => (descending ? -1 : 1) * compare(a, b));
    body.append(...rows);
    heads.forEach((head, index) => {
      if (index === column) head.setAttribute("aria-sort", descending ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    });
  }

  heads.forEach((head, column) => {
    if (!("sortBy" in head.dataset)) return;
    const button = document.createElement("button");
    button.type = "button";
    button.title = "Sort by this column";
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const order = head.getAttribute("aria-sort");
      // Points begin with the most, names with the first.
      sort(column, order ? order === "ascending" : column > 0);
    });
  });

  heads[0].setAttribute("aria-sort", "ascending");  // as they come

  const filter = document.getElementById("filter");
  const shown = document.getElementById("shown");
  filter?.addEventListener("input", () => {
    const words = filter.value.toLocaleLowerCase().split(/\s+/).filter(Boolean);
    let count = 0;
    for (const row of body.rows) {
      const text = row.textContent.toLocaleLowerCase();
      row.hidden = !words.every((word) => text.includes(word));
      if (!row.hidden) ++count;
    }
    shown.textContent = words.length === 0 ? "" : `${count} of ${body.rows.length}`;
  });
}
