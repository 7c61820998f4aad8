// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the page: results as C++ wrote them (src/report/html), arrays in base64.
// The error of a figure is null where it has none by nature, and not a number where it was not determined.

import { say } from "./texts.js";

/**
 * @typedef {{type?: "f8"|"f4"|"i4", shape?: number[], data?: string, texts?: string[], units: string, meaning: string,
 *   every?: [string, number], values?: Float64Array|Float32Array|Int32Array}} Dataset
 * @typedef {[name: string, value: string, error: string, units: string, meaning: string, isAttribute: boolean]} Place
 * @typedef {{attributes?: Record<string, any>, datasets?: Record<string, Dataset>, groups?: Record<string, Group>,
 *   figures?: Place[]}} Group
 * @typedef {{z: number[], steps: number, period: number, radius: Dataset, advance: Dataset, lean: Dataset,
 *   tooth: Dataset, chord: number, interpolation_error: number}} Teeth
 * @typedef {{code: string, figure: string, unit: string, usual: (number|null)[], accepted: (number|null)[],
 *   source: string}} Limit
 * @typedef {{code: string, severity: string, cause: string, advice: string, place: string}} Note
 * @typedef {{set_up: number, pass: number, tooth: number, x: number, y: number, upper: boolean, height: number,
 *   meshing: boolean}} Residual
 * @typedef {{name: string, symbol: string, key: string, rule: string, unit: string, source: string, remark: string,
 *   written: string, range_text: string, here: string, standing: string}} DesignRow
 * @typedef {{rows: DesignRow[], derived: {option: string, value: string, from: string}[],
 *   differences: {key: string, here: string, type_50: string, why: string}[]}} Design
 * @typedef {{name: string, flexspline_teeth: number, circular_spline_teeth: number, module: number, scene: string,
 *   origin: string, judgement: Note[], notes: string[]|null, left_out: {part: string, why: string, failed: boolean}[],
 *   outline_error: number, spline: Group, loaded_spline: Group|null, teeth: Teeth|null,
 *   results: Record<string, Group>, residuals: Residual[], design: Design|null,
 *   limits: Limit[], text: string}} Drive
 * @typedef {{program_version: string, git_revision: string, build: string, date: string,
 *   failed: {name: string, why: string}[], drives: Drive[]}} Report
 * @typedef {{part: string, group: string, name: string, index: number, value: number, error: number|null,
 *   units: string, meaning: string}} Figure
 */

const kinds = { f8: Float64Array, f4: Float32Array, i4: Int32Array };

/** The numbers of a dataset, row by row.
 * @param {Dataset|undefined} set
 * @returns {Float64Array} or an array of another kind, which has the same methods */
export function numbers(set) {
  if (!set || !set.type) return new Float64Array(0);
  if (!set.values) {
    const text = atob(set.data || "");
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    set.values = new kinds[set.type](bytes.buffer);
    set.data = "";
  }
  return /** @type {Float64Array} */ (set.values);
}

/** The group at the end of a path, undefined where there is none.
 * @param {Group|undefined} root @param {string} path */
export function groupAt(root, path) {
  let group = root;
  for (const name of path.split("/")) group = group && group.groups ? group.groups[name] : undefined;
  return group;
}

/** @param {Group|undefined} group @param {string} name */
export function column(group, name) {
  return numbers(group && group.datasets ? group.datasets[name] : undefined);
}

/** The values of a figure that stands in datasets, and its errors.
 * @param {Group} group @param {Place} place */
export function valuesOf(group, [, value, stated]) {
  const apart = groupAt(group, "error"), error = stated || (apart?.datasets?.[value] ? "error/" + value : "");
  const errors = column(error.startsWith("error/") ? apart : group, error.replace("error/", ""));
  const known = column(apart, "estimated"), isEstimated = group.attributes?.estimated !== 0;
  return { values: column(group, value), errorAt: (/** @type {number} */ i) =>
    (!error ? null : !isEstimated || known[i] === 0 ? NaN : i < errors.length ? errors[i] : null) };
}

/** The error of a figure that stands in an attribute.
 * @param {Group} group @param {Place} place @returns {number|null} */
export function attributeError(group, [, , error]) {
  const of = group.attributes || {};
  return !error || !(error in of) ? null : of.estimated === 0 ? NaN : of[error];
}

/** The error of row @p index of a figure.
 * @param {Group|undefined} group @param {string} name @param {number} index */
export function errorOf(group, name, index) {
  const place = ((group && group.figures) || []).find((each) => each[0] === name && !each[5]);
  return group && place ? valuesOf(group, place).errorAt(index) : null;
}

/** Names of drives: their numbers stand beside names that are equal.
 * @param {Drive[]} drives */
export function namesOf(drives) {
  return drives.map(({ name }, i) => (drives.filter((each) => each.name === name).length > 1 ? `${name} (${i + 1})`
    : name));
}

/** Every figure of a group and of those within it.
 * @param {string} part @param {Group} group @param {string} path @param {Figure[]} into */
function collect(part, group, path, into) {
  for (const place of group.figures || []) {
    const [name, value, , units, meaning, isAttribute] = place;
    const own = { part, group: path, name, units, meaning };
    if (isAttribute) {
      const of = group.attributes || {};
      if (typeof of[value] === "number")
        into.push({ ...own, index: -1, value: of[value], error: attributeError(group, place) });
      continue;
    }
    const { values, errorAt } = valuesOf(group, place);
    for (let i = 0; i < values.length; ++i)
      into.push({ ...own, index: values.length > 1 ? i : -1, value: values[i], error: errorAt(i) });
  }
  for (const [name, inner] of Object.entries(group.groups || {}))
    collect(part, inner, path ? `${path}/${name}` : name, into);
}

/** Every figure of a drive with its error.
 * @param {Drive} drive */
export function figuresOf(drive) {
  /** @type {Figure[]} */
  const all = [];
  for (const [part, group] of Object.entries(drive.results)) collect(part, group, "", all);
  return all.sort((a, b) => Number(a.index >= 0) - Number(b.index >= 0)); // single figures before tables
}

/** A figure to the digits that its error leaves, to the error's second; seven without one, three where it was not
 * determined.
 * @param {number} value @param {number|null} [error] */
export function shown(value, error) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0 || (Number.isInteger(value) && !error)) return String(value);
  if (error && error > 0) {
    const digits = Math.floor(Math.log10(Math.abs(value))) - Math.floor(Math.log10(error)) + 2;
    return digits < 1 ? "0" : tidy(value.toPrecision(Math.min(15, digits)));
  }
  return tidy(value.toPrecision(Number.isNaN(error) ? 3 : 7));
}

/** Whether a figure is not known by its error: larger than a third of it, as the program's summary has it.
 * @param {number} value @param {number|null} error */
export function isUnknown(value, error) {
  return error !== null && 3 * error > Math.abs(value);
}

/** An error to two digits.
 * @param {number|null} error */
export function shownError(error) {
  if (Number.isNaN(error)) return say("notDetermined");
  return error === null ? "" : error === 0 ? "0" : tidy(error.toPrecision(2));
}

/** An error behind its figure.
 * @param {number|null} error */
export function plusMinus(error) {
  return (error === null || Number.isNaN(error) ? "" : "± ") + shownError(error);
}

/** @param {string} text */
function tidy(text) {
  const number = Number(text);
  const size = Math.abs(number);
  if (text.includes("e") && size >= 1e-4 && size < 1e7) return String(number); // 340 rather than 3.4e+2
  return size !== 0 && (size < 1e-4 || size >= 1e7) ? text.includes("e") ? text : number.toExponential() : text;
}

/** A number of four digits, for the end of a scale.
 * @param {number} value */
export function brief(value) {
  return String(Number(value.toPrecision(4)));
}

/** With so many decimals, no minus before zero.
 * @param {number} value @param {number} decimals */
export function fixed(value, decimals) {
  return value.toFixed(decimals).replace(/^-(?=[0.]*$)/, "");
}

/** The largest length of one digit, 1, 2 or 5, that is not longer: for a scale bar.
 * @param {number} most */
export function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return Number(((([5, 2].find((d) => d * power <= most)) || 1) * power).toPrecision(1));
}

/** From the smallest to the largest finite value.
 * @param {ArrayLike<number>[]} lists @returns {[number, number]} */
export function range(lists) {
  let low = Infinity, high = -Infinity;
  for (const list of lists)
    for (let i = 0; i < list.length; ++i)
      if (Number.isFinite(list[i])) {
        low = Math.min(low, list[i]);
        high = Math.max(high, list[i]);
      }
  return low <= high ? [low, high] : [0, 1];
}
