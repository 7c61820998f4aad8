// SPDX-License-Identifier: GPL-3.0-or-later
// The drive beside the design that the rules make of its own wishes.

import { make } from "./dom.js";
import { say } from "./texts.js";

/** A table that scrolls; on a phone each cell says its head.
 * @param {string} title @param {string[]} head @param {{cells: (Node|string)[], kind?: string}[]} rows */
export function wideTable(title, head, rows) {
  return make("div", { "class": "scroll", "tabindex": 0, "role": "region", "aria-label": title },
    make("table", { class: "rules" },
      make("thead", {}, make("tr", {}, ...head.map((text) => make("th", { scope: "col" }, text)))),
      make("tbody", {}, ...rows.map(({ cells, kind }) => make("tr", { class: kind },
        ...cells.map((cell, i) => (i ? make("td", { "data-head": head[i] }, cell)
          : make("th", { scope: "row" }, cell))))))));
}

/** @param {string} value @param {string} unit */
function withUnit(value, unit) {
  return value && unit && unit !== "1" ? `${value} ${unit}` : value;
}

/** @param {import("./data.js").Design} design */
export function designView(design) {
  const rows = design.rows.filter((row) => row.key !== "drive.name");
  const isOutside = (/** @type {string} */ standing) => standing.includes("outside");
  const head = [say("figure"), say("found"), say("standing"), say("range"), say("proposed"), say("ruleAndSource")];
  const table = (/** @type {string} */ title, /** @type {import("./data.js").DesignRow[]} */ some) => wideTable(title,
    head, some.map((row) => {
    const name = make("span", {}, row.symbol || row.name, make("small", {}, row.symbol ? row.name : ""));
    return { kind: isOutside(row.standing) ? "differs" : undefined, cells: [name, withUnit(row.here, row.unit),
      row.standing, withUnit(row.range_text, row.unit), withUnit(row.written, row.unit),
      make("span", {}, `${row.rule}${row.source === "wish" ? "" : "; " + row.source}`,
        row.remark ? make("small", {}, row.remark) : null)] };
    }));
  const unlike = rows.filter((row) => !row.standing.startsWith("as proposed") && row.standing !== "not in a scene");
  const command = ["hdconj design", ...design.derived.filter((wish) => wish.value)
    .map((wish) => `${wish.option} ${wish.value}`)].join(" ");
  const kept = new Set(rows.map((row) => row.key));
  const others = design.differences.filter((each) => !kept.has(each.key));
  return make("div", {}, make("p", { class: "note" }, say("designNote")),
    make("details", {}, make("summary", {}, say("wishes")), make("pre", { tabindex: 0 }, command),
      wideTable(say("wishes"), [say("wish"), say("value"), say("from")],
        design.derived.map((wish) => ({ cells: [wish.option, wish.value, wish.from] })))),
    make("p", { class: "standing" }, `${rows.length} ${say("rulesCount")}, ${unlike.length} ${say("unlikeCount")}, ${
      rows.filter((row) => isOutside(row.standing)).length} ${say("outsideCount")}`),
    ...(unlike.length ? [make("h3", {}, say("unlike")), make("div", { class: "whole" }, table(say("unlike"), unlike))]
      : []),
    make("h3", {}, say("allRules")), table(say("allRules"), rows),
    ...(others.length ? [make("h3", {}, say("noRule")), wideTable(say("noRule"), [say("key"), say("found"), say("why")],
      others.map((each) => ({ cells: [each.key, each.type_50, each.why] })))] : []));
}
