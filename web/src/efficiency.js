// SPDX-License-Identifier: GPL-3.0-or-later
// Efficiency over torque and speed as a map with contours.

import { heatMap, strong } from "./heat_map.js";
import { brief, column, shownError } from "./data.js";
import { legend, make, svg } from "./dom.js";
import { say } from "./texts.js";

const newtonMetre = 1000, perMinute = 2 * Math.PI / 60;

/** What is known at the points that were computed: rows of speeds, columns of torques.
 * @typedef {{torque: number[], speed: number[], lost: number[][], error: number[][], ideal: number}} Grid */

/** @param {number[]} values */
function distinct(values) {
  return [...new Set(values)].sort((a, b) => a - b);
}

/** The grid at one temperature; null where the points make none, or only a line.
 * @param {import("./data.js").Group} losses @param {number} temperature @returns {Grid|null} */
function gridAt(losses, temperature) {
  const [torque, speed, warm, efficiency, error, input] = ["torque", "speed", "temperature", "efficiency",
    "efficiency_error", "input_torque"].map((name) => Array.from(column(losses, name)));
  const torques = distinct(torque), speeds = distinct(speed);
  const at = speeds.map((n) => torques.map((t) => torque.findIndex((_, i) => torque[i] === t && speed[i] === n
    && warm[i] === temperature)));
  if (torques.length < 2 || speeds.length < 2 || at.flat().includes(-1)) return null;
  const last = at[0][torques.length - 1];
  return { torque: torques, speed: speeds, lost: at.map((row) => row.map((i) => input[i] * (1 - (efficiency[i] || 0)))),
    error: at.map((row) => row.map((i) => error[i] || 0)), ideal: efficiency[last] * input[last] / torque[last] };
}

/** Where @p value lies among @p nodes: the node below, and the share of the way to the next.
 * @param {number[]} nodes @param {number} value @returns {[number, number]} */
function placeIn(nodes, value) {
  let i = 0;
  while (i < nodes.length - 2 && nodes[i + 1] < value) ++i;
  return [i, (value - nodes[i]) / (nodes[i + 1] - nodes[i])];
}

/** @param {Grid} grid @param {number[][]} values @param {number} torque @param {number} speed */
function between(grid, values, torque, speed) {
  const [i, a] = placeIn(grid.torque, torque), [j, b] = placeIn(grid.speed, speed);
  const along = (/** @type {number[]} */ row) => row[i] + a * (row[i + 1] - row[i]);
  return along(values[j]) + b * (along(values[j + 1]) - along(values[j]));
}

/** From the torque lost, which is nearly straight in torque and speed as efficiency is not. Without torque and losses
 * its limit, because it is not determined there.
 * @param {Grid} grid
 * @param {number} torque @param {number} speed @returns {number} */
function efficiencyAt(grid, torque, speed) {
  const ideal = grid.ideal * torque, lost = between(grid, grid.lost, torque, speed);
  if (ideal + lost > 0) return ideal / (ideal + lost);
  return torque > 0 ? 1 : efficiencyAt(grid, 1e-6 * grid.torque[grid.torque.length - 1], speed);
}

/** @param {number[]} list @param {number} i */
function without(list, i) {
  return list.filter((_, k) => k !== i);
}

/** How far off the map is at most where a computed point is left out and interpolated from its neighbours; null where
 * none lies between two others.
 * @param {Grid} grid */
function interpolationError(grid) {
  let most = null;
  for (let j = 0; j < grid.speed.length; ++j)
    for (let i = 0; i < grid.torque.length; ++i) {
      const others = [];
      if (i > 0 && i < grid.torque.length - 1 && grid.torque.length > 2)
        others.push({ ...grid, torque: without(grid.torque, i), lost: grid.lost.map((row) => without(row, i)) });
      if (j > 0 && j < grid.speed.length - 1 && grid.speed.length > 2)
        others.push({ ...grid, speed: without(grid.speed, j), lost: grid.lost.filter((_, k) => k !== j) });
      const [t, n] = [grid.torque[i], grid.speed[j]];
      for (const other of others)
        most = Math.max(most || 0, Math.abs(efficiencyAt(other, t, n) - efficiencyAt(grid, t, n)));
    }
  return most;
}

/** Lines of equal value over a fine grid, by marching squares; each with its label.
 * @param {number[]} xs @param {number[]} ys @param {(i: number, j: number) => number} value @param {number[]} levels
 * @param {(v: number) => number} x @param {(v: number) => number} y */
function contours(xs, ys, value, levels, x, y) {
  const group = svg("g", { class: "contours" }), labels = svg("g", { class: "contour-labels" });
  /** @type {[number, number][]} */
  const taken = [];
  for (const level of levels) {
    /** @type {[number, number][][]} */
    const pieces = [];
    for (let i = 0; i + 1 < xs.length; ++i)
      for (let j = 0; j + 1 < ys.length; ++j) {
        const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
        /** @type {[number, number][]} */
        const crossed = [];
        corners.forEach(([a, b], k) => {
          const [c, d] = corners[(k + 1) % 4], from = value(a, b) - level, to = value(c, d) - level;
          if (from < 0 === to < 0) return;
          const share = from / (from - to);
          crossed.push([x(xs[a] + share * (xs[c] - xs[a])), y(ys[b] + share * (ys[d] - ys[b]))]);
        });
        for (let k = 0; k + 1 < crossed.length; k += 2) pieces.push([crossed[k], crossed[k + 1]]);
      }
    const path = pieces.map((piece) => piece.map(([a, b], k) => `${k ? "L" : "M"}${a.toFixed(1)} ${b.toFixed(1)}`)
      .join("")).join("");
    if (!path) continue;
    group.append(svg("path", { class: "halo", d: path }), svg("path", { d: path }));
    // where it is farthest from other labels
    const room = (/** @type {[number, number]} */ at) => Math.min(80, ...taken.map(([a, b]) => Math.hypot(at[0] - a,
      1.5 * (at[1] - b))), at[0] - x(xs[0]) + 20, x(xs[xs.length - 1]) - at[0] + 20, 3 * (y(ys[0]) - at[1]),
    3 * (at[1] - y(ys[ys.length - 1])));
    const best = pieces.map((piece) => piece[0]).reduce((a, b) => (room(b) > room(a) ? b : a));
    if (room(best) < 24) continue;
    taken.push(best);
    labels.append(svg("text", { x: best[0], y: best[1] + 4, "text-anchor": "middle" },
      String(Math.round(100 * level))));
  }
  group.append(labels);
  return group;
}

/** A map for each temperature.
 * @param {import("./data.js").Group} losses */
export function efficiencyMaps(losses) {
  const isEstimated = Boolean(losses.attributes && losses.attributes.estimated);
  const temperatures = distinct(Array.from(column(losses, "temperature")));
  return temperatures.flatMap((temperature) => {
    const grid = gridAt(losses, temperature);
    if (!grid) return [];
    const even = (/** @type {number[]} */ nodes, /** @type {number} */ count) => Array.from({ length: count + 1 },
      (_, i) => nodes[0] + i / count * (nodes[nodes.length - 1] - nodes[0]));
    const torques = even(grid.torque, 88), speeds = even(grid.speed, 49);
    const all = torques.map((t) => speeds.map((n) => efficiencyAt(grid, t, n)));
    const value = (/** @type {number} */ i, /** @type {number} */ j) => all[i][j];
    const toTorque = torques.map((t) => t / newtonMetre), toSpeed = speeds.map((n) => n / perMinute);
    const levels = Array.from({ length: 19 }, (_, i) => (i + 1) / 20)
      .filter((level, i) => i % 2 || level > 0.5);
    const read = (/** @type {number} */ torque, /** @type {number} */ speed) => {
      const [t, n] = [torque * newtonMetre, speed * perMinute];
      return `${brief(torque)} N m, ${brief(speed)} rpm: ${(100 * efficiencyAt(grid, t, n)).toFixed(2)} %${isEstimated
        ? ` ± ${shownError(100 * between(grid, grid.error, t, n))}` : ""}`;
    };
    const over = (/** @type {(v: number) => number} */ x, /** @type {(v: number) => number} */ y) => {
      const group = contours(toTorque, toSpeed, value, levels, x, y);
      for (const n of grid.speed)
        for (const t of grid.torque)
          group.append(svg("circle", { class: "node", cx: x(t / newtonMetre), cy: y(n / perMinute), r: 2.4 }));
      return group;
    };
    const off = interpolationError(grid);
    const most = Math.ceil(10 * Math.max(...all.flat())) / 10; // the colours end at full tens of per cent
    const exactness = off === null ? "" : `; ${say("leftOutPoint")} ${shownError(100 * off)} ${say("percentPoints")}`;
    const key = make("span", {}, legend("0 %", `${Math.round(100 * most)} %`, true),
      make("p", { class: "note" }, `${say("computedPoints")}${exactness}.`));
    return [heatMap(`${say("efficiencyMap")}, ${brief(temperature)} °C`, say("outputTorque"), say("generatorSpeed"),
      toTorque, toSpeed, value, (v) => strong(v / most), key, { read, over }).figure];
  });
}
