// SPDX-License-Identifier: GPL-3.0-or-later
// A short table of the figures that one looks at first, in the units of a drawing.

import { isUnknown, plusMinus, shown, valuesOf } from "./data.js";
import { make } from "./dom.js";
import { say } from "./texts.js";

/** Other units for small lengths and angles: factor and name.
 * @param {string} name @param {string} units @returns {[number, string]} */
function shownUnit(name, units) {
  if (units === "rad") return [60 * 180 / Math.PI, "arcmin"];
  if (units === "mm" && /gap|clearance|offset/.test(name)) return [1000, "um"];
  if (units === "N mm/rad") return [Math.PI / 180 / 60 / 1000, "N m/arcmin"];
  return [1, units === "1" ? "" : units];
}

/** The figures of row @p index of a group whose names are @p wanted, in that order.
 * @param {import("./data.js").Group|undefined} group @param {number} index @param {string[]} wanted
 * @param {boolean} [judged]  whether a large error is called what it is; a gap may well be 0 */
export function keyFigures(group, index, wanted, judged) {
  const rows = wanted.map((name) => {
    const place = ((group && group.figures) || []).find((each) => each[0] === name && !each[5]);
    if (!group || !place) return null;
    const { values, errorAt } = valuesOf(group, place), error = errorAt(index);
    if (!(index < values.length)) return null;
    const [factor, unit] = shownUnit(name, place[3]), value = values[index] * factor;
    return make("tr", { "data-name": name, "data-value": value },
      make("th", { scope: "row" }, name.replace(/_/g, " "), make("small", {}, place[4])),
      make("td", {}, shown(value, error === null ? null : error * factor)),
      make("td", {}, plusMinus(error === null ? null : error * factor)), make("td", {}, unit,
        judged && isUnknown(values[index], error) ? make("em", {}, say("notDetermined")) : null));
  });
  return make("table", { "class": "keys", "aria-label": say("keyFigures") }, make("tbody", {}, ...rows));
}
