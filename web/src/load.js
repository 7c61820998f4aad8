// SPDX-License-Identifier: GPL-3.0-or-later
// The drive under torque.

import { caseAt, caseNames, writtenCase } from "./cases.js";
import { bars, chart } from "./curves.js";
import { brief, column, errorOf, groupAt, isUnknown, plusMinus, roundLength, shown, shownError } from "./data.js";
import { choice, colour, legend, make, onTheme, remember, remembered } from "./dom.js";
import { heatMap, strong } from "./heat_map.js";
import { keyFigures } from "./keys.js";
import { say } from "./texts.js";

const newtonMetre = 1000, arcminute = Math.PI / 180 / 60, degree = Math.PI / 180;

/** Values in another unit.
 * @param {ArrayLike<number>} values @param {number} unit */
function by(values, unit) {
  return Array.from(values, (v) => v / unit);
}

/** @param {import("./data.js").Group} load @param {number} index */
function caseFigures(load, index) {
  const group = caseAt(load, index);
  const curve = groupAt(group, "curve"), errors = groupAt(curve, "error");
  const known = column(errors, "estimated");
  /** @param {string} name @param {number} unit */
  const error = (name, unit) => {
    const e = column(errors, name);
    return e.length ? Array.from(e, (v, i) => (known[i] ? v / unit : NaN)) : undefined;
  };
  /** @param {string} title @param {string} xLabel @param {string} yLabel @param {string} xName @param {number} xUnit
   * @param {string} yName @param {number} yUnit */
  const curveOf = (title, xLabel, yLabel, xName, xUnit, yName, yUnit) => chart(title, xLabel, yLabel,
    [{ name: yLabel, x: by(column(curve, xName), xUnit), y: by(column(curve, yName), yUnit), error: error(yName,
      yUnit) }]);
  const perArcmin = newtonMetre / arcminute;
  const isCurve = column(curve, "torque").length > 1;
  const all = [make("div", { class: "wide" }, make("h3", {}, `${say("atTorque")} ${
    brief(column(load, "torque")[index] / newtonMetre)} N m`), keyFigures(load, index, ["twist", "stiffness",
    "backlash", "teeth", "largest_force", "flank_pressure", "largest_line_load", "largest_stress",
    "wave_generator_force", "ball_force"], true))];
  if (isCurve)
    all.push(make("p", { class: "note" }, known.some((k) => k !== 0) ? say("band") : say("noBand")),
      curveOf(say("stiffness"), say("torque"), say("stiffnessUnit"), "torque", newtonMetre, "stiffness", perArcmin),
      curveOf(say("torqueTwist"), say("torque"), say("twist"), "torque", newtonMetre, "twist", arcminute),
      curveOf(say("pressure"), say("torque"), say("pressureUnit"), "torque", newtonMetre, "flank_pressure", 1));
  all.push(...mapFigures(load, index, groupAt(group, "map")));
  const bearing = groupAt(group, "bearing"), balls = column(bearing, "ball_force");
  const ballUnit = bearing && bearing.datasets && bearing.datasets.ball_force ? bearing.datasets.ball_force.units : "";
  if (balls.length)
    all.push(bars(say("balls"), say("sectionAngle") + " [°]",
      `${say("ballForce")} [${ballUnit}]`, by(column(bearing, "ball_angle"),
      degree), balls, column(bearing, "ball_force_error")));
  const members = groupAt(group, "members");
  const names = members && members.datasets && members.datasets.name && members.datasets.name.texts;
  if (names) {
    const twist = by(column(members, "twist"), arcminute), known = column(members, "twist_error");
    const e = twist.map((_, i) => (known.length ? known[i] / arcminute : NaN));
    all.push(make("figure", {}, make("figcaption", {}, say("members")), make("table", {}, make("tbody", {},
      ...names.map((name, i) => make("tr", {}, make("th", { scope: "row" }, name),
        make("td", {}, shown(twist[i], e[i])), make("td", {}, plusMinus(e[i])), make("td", {}, "arcmin")))))));
  }
  const cup = index === writtenCase(load) ? cupSection(load, index) : null;
  return make("div", { class: "figures" }, ...all, ...(cup ? [cup] : []));
}

/** The end of a scale of colours: the largest value, and the error that the program states of it, or that it has none.
 * @param {import("./data.js").Group} load @param {number} index @param {string} name @param {number} largest
 * @param {string} unit */
function scaleEnd(load, index, name, largest, unit) {
  const error = errorOf(load, name, index);
  if (!error) return `${shown(largest, NaN)} ${unit}${Number.isNaN(error) ? `, ${say("notDetermined")}` : ""}`;
  return `${shown(largest, error)} ± ${shownError(error)} ${unit}${
    isUnknown(largest, error) ? `, ${say("notDetermined")}` : ""}`;
}

/** Forces and pressures over all teeth: a sector repeats around the ring.
 * @param {import("./data.js").Group} load @param {number} index
 * @param {import("./data.js").Group|undefined} map */
function mapFigures(load, index, map) {
  const sectors = (load.attributes && load.attributes.sectors) || 1;
  const angle = column(map, "angle"), z = column(map, "z");
  const pressure = column(map, "pressure"), known = column(map, "tooth_force_error");
  if (!angle.length) return [];
  const turn = 2 * Math.PI / sectors;
  const places = Array.from({ length: sectors * angle.length }, (_, i) => {
    const a = angle[i % angle.length] + turn * Math.floor(i / angle.length);
    return { s: i % angle.length, at: (a - 2 * Math.PI * Math.floor(a / (2 * Math.PI) + 0.5)) / degree };
  }).sort((a, b) => a.at - b.at);
  const force = column(map, "force"), nodes = 2 * z.length;
  const onTooth = column(map, "tooth_force").length ? column(map, "tooth_force")
    : angle.map((_, s) => force.slice(s * nodes, (s + 1) * nodes).reduce((all, f) => all + f, 0)); // of older files
  const sum = places.map(({ s }) => onTooth[s]);
  const largest = pressure.reduce((a, b) => Math.max(a, b), 0) || 1;
  const xs = places.map((place) => place.at);
  /** @param {number} i @param {number} k */
  const value = (i, k) => Math.max(pressure[places[i].s * 2 * z.length + k],
    pressure[(places[i].s * 2 + 1) * z.length + k]) || NaN; // nothing is painted where no force is
  return [bars(say("toothForces"), say("spaceAngle"), say("force"), xs, sum,
    known.length ? places.map(({ s }) => known[s]) : []),
    heatMap(say("pressureMap"), say("spaceAngle"), say("height"), xs, z, value, (v) => strong(v / largest),
      make("span", {}, legend("0", scaleEnd(load, index, "largest_pressure", largest, "MPa"), true),
        make("span", { class: "legend" }, say("white"))), { isRing: true }).figure];
}

/** The cup's section coloured by stress, at an angle that one chooses.
 * @param {import("./data.js").Group} load @param {number} index */
function cupSection(load, index) {
  const shape = groupAt(load, "shape"), stress = column(shape, "stress"), r = column(shape, "r"), z = column(shape, "z");
  const cells = column(shape, "cells"), phi = column(shape, "phi");
  if (!stress.length) return null;
  const kept = shape && shape.datasets && shape.datasets.stress.every ? shape.datasets.stress.every[1] : 1;
  const rows = stress.length / r.length, seat = new Set(column(shape, "seat")); // not determined there
  const largest = column(load, "largest_stress")[index] || stress.reduce((a, b) => Math.max(a, b), 0);
  const canvas = make("canvas", { "class": "section", "role": "img", "aria-label": say("stress"), "width": 960,
    "height": 640 });
  const ctx = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const lowR = Math.min(...r), highR = Math.max(...r), lowZ = Math.min(...z), highZ = Math.max(...z);
  const scale = Math.min(920 / (highZ - lowZ), 600 / (highR - lowR)), bar = roundLength(160 / scale);
  const reading = make("div", { class: "reading" });
  let row = 0;
  const draw = () => {
    ctx.fillStyle = colour("paper");
    ctx.fillRect(0, 0, canvas.width, canvas.height);
    let most = 0;
    for (let c = 0; c < cells.length; c += 4) {
      ctx.beginPath();
      let sum = 0;
      for (let i = 0; i < 4; ++i) {
        const n = cells[c + i];
        ctx.lineTo(20 + (z[n] - lowZ) * scale, 620 - (r[n] - lowR) * scale);
        sum += stress[row * r.length + n] / 4;
        if (!seat.has(n)) most = Math.max(most, stress[row * r.length + n]);
      }
      ctx.closePath();
      ctx.fillStyle = ctx.strokeStyle = strong(sum / largest);
      ctx.fill();
      ctx.stroke();
    }
    ctx.fillStyle = ctx.strokeStyle = colour("ink");
    ctx.font = "22px system-ui, sans-serif";
    ctx.beginPath();
    ctx.moveTo(60, 560);
    ctx.lineTo(60 + bar * scale, 560);
    ctx.stroke();
    ctx.fillText(`${bar} mm`, 66, 550);
    ctx.fillText(say("bottomOpen"), 60, 600);
    reading.textContent = `${(phi[row * kept] / degree).toFixed(1)}°: ${say("atNodes")} ${brief(most)} MPa`;
  };
  draw();
  onTheme(canvas, draw);
  const slider = make("input", { type: "range", min: 0, max: rows - 1, value: 0, input: () => {
    row = Number(slider.value);
    draw();
  } });
  return make("figure", {}, make("figcaption", {}, say("stress")), canvas,
    make("label", { class: "wide" }, say("sectionAngle") + " ", slider), reading,
    legend("0", scaleEnd(load, index, "largest_stress", largest, "MPa"), true));
}

/** @param {import("./data.js").Drive} drive */
export function loadView(drive) {
  const load = groupAt(drive.results.load, "load");
  if (!load) return null;
  const names = caseNames(load), place = make("div", {});
  const start = Math.max(0, Math.min(names.length - 1, remembered("l", writtenCase(load))));
  const show = (/** @type {number} */ i) => {
    if (i !== start) remember("l", i);
    place.replaceChildren(caseFigures(load, i));
  };
  show(start);
  return make("div", {}, names.length > 1 ? choice(say("case"), names, start, show) : null, place);
}
