// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of contact and of load: their names, and which of them is drawn.

import { brief, column, groupAt } from "./data.js";
import { make } from "./dom.js";
import { say } from "./texts.js";

const degree = Math.PI / 180;

/** The case that circular spline, mesh and whole map belong to.
 * @param {import("./data.js").Group|undefined} group @returns {number} */
export function writtenCase(group) {
  return group?.attributes?.written_case || 0;
}

/** What belongs to one case alone.
 * @param {import("./data.js").Group|undefined} group @param {number} index @param {string} [path]  within it */
export function caseAt(group, index, path) {
  return groupAt(group, `case_${String(index).padStart(3, "0")}${path ? "/" + path : ""}`);
}

/** Surface, kind of tilt and tilt of each case.
 * @param {import("./data.js").Group|undefined} group */
function casesOf(group) {
  const sets = group?.datasets || {}, tilt = column(group, "tilt");
  return (sets.surface?.texts || []).map((surface, i) => ({ surface, kind: sets.kind?.texts?.[i] || "",
    tilt: tilt[i] || 0 }));
}

/** @param {import("./data.js").Group|undefined} group */
export function caseNames(group) {
  return casesOf(group).map(({ surface, kind, tilt }) => (kind ? `${surface}, ${kind} ${brief(tilt / degree)}°`
    : surface));
}

/** How cases are told apart but for their tilt, as far as that differs among them, and whether tilts differ.
 * @param {import("./data.js").Group|undefined} group */
export function differencesOf(group) {
  const all = casesOf(group);
  /** @param {"surface"|"kind"|"tilt"} key */
  const differs = (key) => all.some((each) => each[key] !== all[0][key]);
  const words = /** @type {("surface"|"kind")[]} */ (["surface", "kind"]).filter(differs);
  return { names: all.map((each) => words.map((key) => each[key]).join(", ")), areTilted: differs("tilt") };
}

/** A line where the contact is that of a drive whose cup does not cone; null elsewhere.
 * @param {import("./data.js").Drive} drive */
export function coneNote(drive) {
  const stages = drive.results.contact?.attributes?.stages;
  return Array.isArray(stages) && !stages.includes("coning") ? make("p", { class: "note" }, say("noCone")) : null;
}
