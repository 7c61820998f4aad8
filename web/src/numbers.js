// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of figures: of one drive, and of several side by side.

import { column, figuresOf, namesOf, roundLength, shown, shownError } from "./data.js";
import { make, svg } from "./dom.js";
import { say } from "./texts.js";


/** @param {import("./data.js").Figure} figure */
function placeOf(figure) {
  return `${figure.part}${figure.group ? "/" + figure.group : ""}`;
}
/** @param {import("./data.js").Figure} figure */
function nameOf(figure) {
  return figure.name + (figure.index >= 0 ? ` [${figure.index}]` : "");
}

/** A cell of CSV.
 * @param {string|number|null} value */
function cell(value) {
  const text = value === null || Number.isNaN(value) ? "" : String(value);
  return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

/** A table with a search and a button that copies it.
 * @param {string[]} head
 * @param {{cells: (string|Node)[], csv: (string|number|null)[], search: string, mark?: boolean}[]} rows
 * @param {string} label */
function searchable(head, rows, label) {
  const body = make("tbody", {}), count = make("span", { "class": "note", "role": "status" });
  const made = rows.map((row) => make("tr", { class: row.mark ? "differs" : undefined },
    ...row.cells.map((each, i) => make(i === 1 ? "th" : "td", i === 1 ? { scope: "row" }
      : { "data-head": head[i] || undefined }, each))));
  const most = 400; // rows shown at once: a search finds the others
  const show = () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = made.filter((_, i) => words.every((/** @type {string} */ word) => rows[i].search.includes(word)));
    body.replaceChildren(...found.slice(0, most));
    count.textContent = `${Math.min(most, found.length)} / ${rows.length} ${say("rows")}`;
  };
  const search = make("input", { type: "search", placeholder: say("search"), "aria-label": say("search"),
    input: show });
  const copy = make("button", { type: "button", click: () => {
    const text = [head, ...rows.map((row) => row.csv)].map((row) => row.map(cell).join(",")).join("\n") + "\n";
    copy.dataset.csv = text;
    toClipboard(text).then((done) => { count.textContent = say(done ? "copied" : "copyFailed"); });
  } }, say("copyCsv"));
  show();
  return make("div", {}, make("div", { class: "controls" }, search, copy, count),
    make("p", { class: "note" }, say("noErrorNote")),
    make("div", { "class": "scroll", "tabindex": 0, "role": "region", "aria-label": label },
      make("table", {}, make("thead", {}, make("tr", {}, ...head.map((text) => make("th", { scope: "col" }, text)))),
        body)));
}

/** A page from disk may be kept from the clipboard: then a hidden text is copied.
 * @param {string} text */
async function toClipboard(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch (_) {
    const area = make("textarea", {});
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

/** @param {import("./data.js").Drive} drive */
export function numbersView(drive) {
  const rows = figuresOf(drive).map((f) => ({
    cells: [placeOf(f), nameOf(f), shown(f.value, f.error), shownError(f.error), f.units === "1" ? "" : f.units,
      f.meaning],
    csv: [placeOf(f), nameOf(f), f.value, f.error, f.units, f.meaning],
    search: `${placeOf(f)} ${nameOf(f)} ${f.units} ${f.meaning}`.toLowerCase(),
  }));
  return searchable([say("part"), say("figure"), say("value"), say("error"), say("unit"), say("meaning")], rows,
    say("numbers"));
}

/** @param {import("./data.js").Drive[]} drives */
export function compareView(drives) {
  if (drives.length < 2) return null;
  const tables = drives.map((drive) => new Map(figuresOf(drive).filter((f) => f.name !== "seconds")
    .map((f) => [`${placeOf(f)} ${nameOf(f)}`, f]))); // how long the computer took says nothing of a drive
  const keys = [...new Set(tables.flatMap((table) => [...table.keys()]))];
  const rows = keys.map((key) => {
    const found = tables.map((table) => table.get(key));
    const known = found.flatMap((f) => f || []), first = known[0];
    const pairs = known.flatMap((a, i) => known.slice(i + 1).map((b) => [a, b]))
      .filter(([a, b]) => Math.abs(a.value - b.value) > (a.error || 0) + (b.error || 0));
    const mark = pairs.length > 0, exact = pairs.every((pair) => pair.some((f) => !Number.isFinite(f.error)));
    return {
      mark, search: `${key} ${first.units} ${first.meaning} ${mark ? say("differs") : ""}`.toLowerCase(),
      cells: [placeOf(first), make("span", {}, nameOf(first), make("small", {}, first.meaning), mark
        ? make("small", {}, make("strong", {}, "≠ " + say(exact ? "noError" : "differs")))
        : known.length > 1 ? make("small", {}, say("same")) : null),
        ...found.map((f) => (f ? shown(f.value, f.error) + (f.error ? " ± " + shownError(f.error) : "") : "–")),
        first.units === "1" ? "" : first.units],
      csv: [placeOf(first), nameOf(first), ...found.map((f) => (f ? f.value : null)), first.units, mark ? "differs"
        : ""],
    };
  });
  rows.sort((a, b) => Number(b.mark) - Number(a.mark));
  const head = [say("part"), say("figure"), ...namesOf(drives), say("unit")];
  return make("div", {}, overlay(drives), searchable(head, rows, say("compare")));
}

/** Tooth spaces of the middle slices and teeth laid over each other, their centre lines and tip circles together.
 * @param {import("./data.js").Drive[]} drives */
function overlay(drives) {
  const shapes = drives.map((drive) => {
    const set = drive.spline.datasets && drive.spline.datasets.outline, n = set && set.shape ? set.shape[1] : 0;
    const slices = set && set.shape ? set.shape[0] : 0, outline = column(drive.spline, "outline");
    const first = 2 * n * (slices >> 1), marks = column(drive.spline, "landmarks");
    const seat = outline[first + 2 * marks[0] + 1];
    return Array.from({ length: n }, (_, i) => [outline[first + 2 * i], seat - outline[first + 2 * i + 1]]);
  });
  const xs = shapes.flat().map((p) => p[0]), ys = shapes.flat().map((p) => p[1]);
  const low = Math.min(...xs), high = Math.max(...xs), bottom = Math.min(...ys), top = Math.max(...ys);
  const more = (high - low) * 0.03;
  const picture = svg("svg", { "class": "overlay", "role": "img", "aria-label": say("overlaid"),
    "viewBox": `${low - more} ${bottom - more} ${high - low + 2 * more} ${top - bottom + 2 * more}` },
    ...shapes.map((points, i) => svg("polyline", { "class": `line s${i % 4}`, "vector-effect": "non-scaling-stroke",
      "points": points.map((p) => p.map((v) => v.toFixed(5)).join(",")).join(" ") })));
  const bar = roundLength((high - low) / 4), size = (high - low) / 40;
  picture.append(svg("path", { "class": "line", "vector-effect": "non-scaling-stroke",
    "d": `M${low} ${bottom + size * 2}h${bar}` }), svg("text", { "x": low, "y": bottom + size * 1.4, "font-size": size,
    "fill": "currentColor" }, `${bar} mm`));
  return make("figure", {}, make("figcaption", {}, say("overlaid")), picture,
    make("div", { class: "names" }, ...namesOf(drives).map((name, i) => make("span", { class: `key s${i % 4}` }, name,
      drives[i].origin ? ": " + drives[i].origin : null))));
}
