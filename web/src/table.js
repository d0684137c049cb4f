// Every flight as a row: sorted by a click on a head, filtered by state, variant and words, and by the map's brush.
import { inText, OF_STATES } from "./marks.js";
import { short } from "./plot.js";

const ROWS = 15; // shown at first, and with each "more"

function columns(sweep, chosen) {
  const { flights } = sweep;
  const several = sweep.variants.length > 1;
  return [
    { head: "run", number: true, value: (i) => flights[i].run, cell: (i, cell) => cell.append(link(flights[i].run, chosen.page(i))) },
    several && { head: "variant", value: (i) => sweep.variants[flights[i].variant] },
    { head: "ended", value: (i) => flights[i].state, html: (i) => `${inText(OF_STATES[flights[i].state], `s${flights[i].state}`)} ${sweep.states[flights[i].state]}` },
    { head: "report, or the command that makes it", fixed: true, cell: (i, cell) => cell.append(chosen.page(i) ? link("report", chosen.page(i)) : command(chosen.command(i))) },
    { head: "missed by most", value: (i) => sweep.requirements[flights[i].missed] ?? flights[i].reason ?? "", more: (i) => (flights[i].others ? ` and ${flights[i].others} more` : "") },
    { head: "margin", number: true, value: (i) => flights[i].margin, missing: Infinity },
    { head: "end [s]", number: true, value: (i) => flights[i].end_s },
    ...sweep.inputs.map(({ path, names, values }) => ({ head: path, number: !names, value: (i) => (names ? names[values[i]] : values[i]) })),
  ].filter(Boolean);
}

function link(text, page) {
  return page ? Object.assign(document.createElement("a"), { href: page, textContent: text }) : String(text);
}

function command(text) {
  return Object.assign(document.createElement("code"), { textContent: text });
}

// The worst first: without a result, then lost, the earliest first, then missed, by the number of requirements and the margin.
function worst(sweep) {
  const rank = [4, 2, 1, 0, 3]; // of passed, missed, lost, no result, not judged
  const key = ({ state, others, margin, end_s }) => [rank[state], state === 2 ? end_s : -others, margin ?? 0];
  return (i, j) => {
    const [a, b] = [key(sweep.flights[i]), key(sweep.flights[j])];
    return a[0] - b[0] || a[1] - b[1] || a[2] - b[2] || i - j;
  };
}

export function table(root, sweep, chosen) {
  const shownColumns = columns(sweep, chosen);
  let order = worst(sweep);
  let sorted = null; // {column, up}
  let most = ROWS;
  root.innerHTML = `<p class="buttons"><label>words <input type="search" size="16"></label>
    <label>ended <select data-filter="state"><option value="">all</option>${sweep.states.map((name, s) => `<option value="${s}">${name}</option>`).join("")}</select></label>
    <label data-several>variant <select data-filter="variant"><option value="">all</option></select></label><output></output></p>
    <div class="table"><table><thead><tr></tr></thead><tbody></tbody></table></div><p><button type="button" data-do="more">More</button></p>
    <p class="note">Margin: how far the worst value is inside (+) or outside (-) of the limit. Commands are run in the folder above this one; <code>report</code> makes the page of a flight whose log was kept, and this page then links to it.</p>`;
  const [head, body, count, more] = ["thead tr", "tbody", "output", "[data-do=more]"].map((s) => root.querySelector(s));
  const variants = root.querySelector("[data-filter=variant]");
  sweep.variants.forEach((name, v) => variants.append(new Option(name, v)));
  root.querySelector("[data-several]").hidden = sweep.variants.length < 2;
  root.querySelector("input").addEventListener("input", (e) => chosen.set({ words: e.target.value.trim().toLowerCase() }));
  for (const made of root.querySelectorAll("[data-filter]")) made.addEventListener("change", () => chosen.set({ [made.dataset.filter]: made.value }));
  more.addEventListener("click", () => {
    most += 10 * ROWS;
    fill();
  });

  for (const column of shownColumns) {
    const cell = document.createElement("th");
    cell.scope = "col";
    if (column.number) cell.className = "number";
    if (column.fixed) cell.textContent = column.head;
    else {
      const button = Object.assign(document.createElement("button"), { type: "button", className: "sort" });
      for (const part of column.head.split(/(?<=[._])/)) button.append(part, document.createElement("wbr")); // a long path may break there
      button.addEventListener("click", () => sort(column));
      cell.append(button);
      column.cellOfHead = cell;
    }
    head.append(cell);
  }

  function sort(column) {
    const up = sorted?.column === column ? !sorted.up : true;
    sorted = { column, up };
    for (const { cellOfHead } of shownColumns) cellOfHead?.removeAttribute("aria-sort");
    column.cellOfHead.setAttribute("aria-sort", up ? "ascending" : "descending");
    const value = (i) => column.value(i) ?? column.missing ?? "";
    order = (i, j) => {
      const [a, b] = [value(i), value(j)];
      const by = typeof a === "number" && typeof b === "number" ? (a === b ? 0 : a - b) : String(a).localeCompare(String(b));
      return (up ? by : -by) || i - j;
    };
    fill();
  }

  function row(i) {
    const made = document.createElement("tr");
    made.dataset.flight = i;
    made.classList.toggle("picked", chosen.picked === i);
    for (const column of shownColumns) {
      const cell = document.createElement("td");
      if (column.number) cell.className = "number";
      if (column.cell) column.cell(i, cell);
      else if (column.number) cell.textContent = short(column.value(i));
      else if (column.html) cell.innerHTML = column.html(i);
      else cell.textContent = `${column.value(i) ?? ""}${column.more?.(i) ?? ""}`;
      made.append(cell);
    }
    return made;
  }

  function fill() {
    const rows = sweep.flights.map((_, i) => i).filter((i) => chosen.has(i) || i === chosen.picked).sort(order);
    if (chosen.picked != null && rows.includes(chosen.picked)) rows.unshift(...rows.splice(rows.indexOf(chosen.picked), 1));
    body.replaceChildren(...rows.slice(0, most).map(row));
    const not = sweep.all > sweep.flights.length ? `; the page has the first ${sweep.flights.length} of ${sweep.all}` : "";
    count.textContent = `${rows.length} of ${sweep.flights.length} flights${not}`;
    more.hidden = rows.length <= most;
  }

  chosen.listen(fill);
  fill();
}
