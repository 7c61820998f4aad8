// SPDX-License-Identifier: GPL-3.0-or-later
// What happens along the axis: map of gaps, one tooth space that one can turn, tilts.

import { chart, heatMap } from "./chart.js";
import { column, groupAt, shown, shownError } from "./data.js";
import { choice, colour, legend, make, remember, remembered, scaleColour } from "./dom.js";
import { caseNames } from "./load.js";
import { say } from "./texts.js";

const degree = Math.PI / 180;
const limit = 20; // um, end of the colours

/** @param {import("./data.js").Drive} drive */
export function axialView(drive) {
  const contact = groupAt(drive.results.contact, "contact"), map = groupAt(contact, "map");
  const all = [];
  if (map && contact) all.push(...gapMaps(map), ...tiltFigures(contact));
  const cup = groupAt(drive.results.load, "load/cup");
  if (column(cup, "z").length)
    all.push(chart(say("coning"), say("height"), say("radial"), ["w_major", "w_minor"].map((name) => ({
      name, x: column(cup, "z"), y: Array.from(column(cup, name), (w) => w * 1000) }))));
  const surface = surfaceFigure(drive, map);
  if (surface) all.push(surface);
  return all.length ? make("div", { class: "figures" }, ...all) : null;
}

/** The smallest gap of each flank over tooth space and slice.
 * @param {import("./data.js").Group} map */
function gapMaps(map) {
  const angle = column(map, "angle"), z = column(map, "z"), gap = column(map, "gap");
  const points = gap.length / (angle.length * 2 * z.length);
  return [say("left"), say("right")].map((name, flank) => {
    const least = new Float64Array(angle.length * z.length);
    for (let s = 0; s < angle.length; ++s)
      for (let k = 0; k < z.length; ++k) {
        let low = Infinity;
        const first = ((s * 2 + flank) * z.length + k) * points;
        for (let p = 0; p < points; ++p) low = Math.min(low, gap[first + p]);
        least[s * z.length + k] = low * 1000;
      }
    return heatMap(`${say("gapMap")}, ${name}`, say("spaceAngle"), say("height"), Array.from(angle,
      (a) => a / degree), z,
      (i, k) => least[i * z.length + k], (v) => scaleColour(v < -0.01 ? -1 : v / limit), legend("0",
        `${limit} um`)).figure;
  });
}

/** The cases of a study against their tilt; a slider where there are several.
 * @param {import("./data.js").Group} contact */
function tiltFigures(contact) {
  const names = caseNames(contact), tilt = column(contact, "tilt"), list = make("ul", { class: "computed" });
  const show = (/** @type {number} */ i) => list.replaceChildren(...(contact.figures || [])
    .filter((place) => !place[5] && column(contact, place[1]).length === names.length)
    .map(([name, value, error, units]) => {
      const v = column(contact, value)[i], e = error ? column(contact, error)[i] : null;
      return make("li", {}, `${name} ${shown(v, e)}${e ? " ± " + shownError(e) : ""} ${units === "1" ? "" : units}`);
    }));
  const start = Math.max(0, Math.min(names.length - 1, remembered("t", 0)));
  show(start);
  const output = make("output", {}, names[start] || "");
  const slider = make("input", { "type": "range", "min": 0, "max": names.length - 1, "value": start, "data-tilt": "",
    "input": () => {
      show(Number(slider.value));
      remember("t", Number(slider.value));
      output.textContent = names[Number(slider.value)];
    } });
  if (names.length < 2) return [make("div", {}, output, list)];
  const figure = chart(say("tiltChart"), say("tiltUnit"), say("fraction"), [{ name: say("fraction"), dots: true,
    x: Array.from(tilt, (t) => t / degree), y: column(contact, "contact_fraction"),
    error: column(contact, "contact_fraction_error") }]);
  return [figure, make("div", {}, make("label", { class: "wide" }, say("tilt") + " ", slider, output), list)];
}

/** One tooth space over the face width, turned by dragging; its flanks coloured by the gap map.
 * @param {import("./data.js").Drive} drive @param {import("./data.js").Group|undefined} map */
function surfaceFigure(drive, map) {
  const set = drive.spline.datasets && drive.spline.datasets.outline, z = column(drive.spline, "z");
  if (!set || !set.shape || z.length < 2) return null;
  const outline = column(drive.spline, "outline"), points = set.shape[1], marks = column(drive.spline, "landmarks");
  const angle = column(map, "angle"), gap = column(map, "gap");
  const stations = angle.length ? gap.length / (angle.length * 2 * z.length) : 0;
  const canvas = make("canvas", { "class": "section", "role": "img", "aria-label": say("surface"), "tabindex": 0,
    "width": 1040, "height": 640 });
  const ctx = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const middle = outline[2 * (marks[2] || points >> 1) + 1] - drive.module, half = (z[z.length - 1] - z[0]) / 2;
  let yaw = 0.6, pitch = 0.5, space = angle.length >> 1;
  const step = Math.max(1, Math.floor(points / 70));
  /** @param {number} k @param {number} i */
  const project = (k, i) => {
    const x = outline[2 * (k * points + i)] / drive.module,
      y = (outline[2 * (k * points + i) + 1] - middle) / drive.module;
    const w = z[k] / half * 2; // the axis is shortened: a tooth is narrow
    const u = x * Math.cos(yaw) - w * Math.sin(yaw), d = x * Math.sin(yaw) + w * Math.cos(yaw);
    return { x: 520 + 150 * u, y: 320 - 150 * (y * Math.cos(pitch) - d * Math.sin(pitch)),
      depth: d * Math.cos(pitch) + y * Math.sin(pitch) };
  };
  /** Gap of a point in um; NaN off the flanks.
   * @param {number} k @param {number} i */
  const gapAt = (k, i) => {
    const right = i > marks[2], from = right ? marks[4] : marks[0], to = right ? marks[3] : marks[1];
    const share = (i - from) / (to - from);
    if (!stations || !(share >= 0 && share <= 1)) return NaN;
    const p = Math.round(share * (stations - 1));
    return gap[((space * 2 + (right ? 1 : 0)) * z.length + k) * stations + p] * 1000;
  };
  const draw = () => {
    ctx.fillStyle = colour("paper");
    ctx.fillRect(0, 0, canvas.width, canvas.height);
    const quads = [];
    for (let k = 0; k + 1 < z.length; ++k)
      for (let i = 0; i + step < points; i += step) {
        const corners = [project(k, i), project(k, i + step), project(k + 1, i + step), project(k + 1, i)];
        const g = gapAt(k, i);
        quads.push({ corners, depth: corners.reduce((sum, c) => sum + c.depth, 0),
          fill: Number.isFinite(g) ? scaleColour(g < -0.01 ? -1 : g / limit) : colour("spline") });
      }
    quads.sort((a, b) => b.depth - a.depth);
    for (const { corners, fill } of quads) {
      ctx.beginPath();
      for (const c of corners) ctx.lineTo(c.x, c.y);
      ctx.closePath();
      ctx.fillStyle = ctx.strokeStyle = fill;
      ctx.fill();
      ctx.stroke();
    }
  };
  draw();
  document.addEventListener("themechange", draw);
  const turn = (/** @type {number} */ a, /** @type {number} */ b) => {
    yaw += a;
    pitch = Math.max(-1.5, Math.min(1.5, pitch + b));
    draw();
  };
  canvas.addEventListener("pointerdown", (/** @type {PointerEvent} */ e) => canvas.setPointerCapture(e.pointerId));
  canvas.addEventListener("pointermove", (/** @type {PointerEvent} */ e) => {
    if (e.buttons) turn(e.movementX * 0.008, e.movementY * 0.008);
  });
  canvas.addEventListener("keydown", (/** @type {KeyboardEvent} */ e) => {
    const by = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[e.key];
    if (!by) return;
    e.preventDefault();
    turn(by[0], by[1]);
  });
  return make("figure", { class: "wide" }, make("figcaption", {}, say("surface")), canvas,
    angle.length ? choice(say("space"), Array.from(angle, (a) => (a / degree).toFixed(2) + "°"), space, (i) => {
      space = i;
      draw();
    }) : null, make("p", { class: "note" }, say("turnHelp")), stations ? legend("0", `${limit} um`) : null);
}
