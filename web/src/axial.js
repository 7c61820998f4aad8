// SPDX-License-Identifier: GPL-3.0-or-later
// What happens along the axis: map of gaps, one tooth space that one can turn, tilts.

import { caseAt, caseNames, coneNote, differencesOf, writtenCase } from "./cases.js";
import { chart } from "./curves.js";
import { column, errorOf, fixed, groupAt, plusMinus, shown } from "./data.js";
import { choice, colour, legend, make, onTheme, remember, remembered, scaleColour } from "./dom.js";
import { heatMap } from "./heat_map.js";
import { keyFigures } from "./keys.js";
import { say } from "./texts.js";

const degree = Math.PI / 180;
const limit = 20; // um, end of the colours

/** @param {import("./data.js").Drive} drive */
export function axialView(drive) {
  const contact = groupAt(drive.results.contact, "contact");
  const all = contact && groupAt(contact, "map") ? casesView(drive, contact) : [];
  const cup = groupAt(drive.results.load, "load/cup");
  if (column(cup, "z").length) {
    const error = cup?.attributes?.displacement_error_mm;
    all.push(chart(say("coning"), say("height"), say("radial"), ["w_major", "w_minor"].map((name) => ({
      name: say(name === "w_major" ? "atMajor" : "atMinor"), x: column(cup, "z"),
      y: Array.from(column(cup, name), (w) => w * 1000),
      error: typeof error === "number" ? Array.from(column(cup, "z"), () => error * 1000) : undefined }))));
  }
  if (!contact) all.push(surfaceFigure(drive, undefined, null));
  const shown = all.filter(Boolean);
  return shown.length ? make("div", { class: "figures" }, ...shown) : null;
}

/** The smallest gap of each flank over tooth space and slice, in um.
 * @typedef {{angle: ArrayLike<number>, z: ArrayLike<number>, at: (space: number, flank: number, slice: number) =>
 *   number}} Smallest */

/** Of a case: from the whole map where that is of this case.
 * @param {import("./data.js").Group} contact @param {number} index @returns {Smallest} */
function smallestOf(contact, index) {
  const map = groupAt(contact, "map"), z = column(map, "z");
  const own = caseAt(contact, index, "gaps");
  const group = own || map, angle = column(group, "angle"), gap = column(group, "gap");
  const points = gap.length / (angle.length * 2 * z.length);
  return { angle, z, at: (space, flank, slice) => {
    let low = Infinity;
    const first = ((space * 2 + flank) * z.length + slice) * points;
    for (let p = 0; p < points; ++p) low = Math.min(low, gap[first + p]);
    return low * 1000;
  } };
}

/** Rounding makes no interference of a touch.
 * @param {number} gap  in um */
function gapColour(gap) {
  return scaleColour(gap < -0.01 ? -1 : Math.max(0, gap) / limit);
}

function gapLegend() {
  return make("span", {}, legend("0", `${limit} um ${say("andMore")}`), " ", make("span", { class: "interference" },
    say("interference")));
}

/** @param {Smallest} smallest */
function gapMaps(smallest) {
  return [say("left"), say("right")].map((name, flank) => heatMap(`${say("gapMap")}, ${name}`, say("spaceAngle"),
    say("height"), Array.from(smallest.angle, (a) => a / degree), smallest.z, (i, k) => smallest.at(i, flank, k),
    gapColour, gapLegend(), { isRing: true }).figure);
}

/** The cases of a study: their figures, maps and tooth space; a slider where there are several.
 * @param {import("./data.js").Drive} drive @param {import("./data.js").Group} contact */
function casesView(drive, contact) {
  const names = caseNames(contact), written = writtenCase(contact), differences = differencesOf(contact);
  const worst = caseAt(contact, written, "revolution") ? `, ${say("worst")}` : "";
  const angles = column(contact, "wave_generator");
  const list = make("div", {}), maps = make("div", { class: "figures wide" });
  const surface = make("div", { class: "wide" });
  const output = make("output", {});
  const show = (/** @type {number} */ i) => {
    const angle = Number((angles[i] / degree).toFixed(3)) + 0; // no minus before zero
    list.replaceChildren(make("strong", {}, `${say("stateAngle")} ${angle}°${worst}`), keyFigures(contact, i,
      ["contact_fraction", "contact_area", "teeth", "turn_to_contact", "backlash", "smallest_gap", "flank_clearance",
        "backlash_offset", "least_side_clearance"]), ...[coneNote(drive)].flatMap((note) => note || []));
    const smallest = smallestOf(contact, i);
    maps.replaceChildren(...gapMaps(smallest));
    const figure = surfaceFigure(drive, groupAt(contact, "map"), i === written ? null : smallest);
    surface.replaceChildren(...[figure].filter(Boolean));
    if (figure && i !== written) figure.append(make("p", { class: "note" }, `${say("thinMap")} ${names[written]}.`));
    output.textContent = names[i];
  };
  const start = Math.max(0, Math.min(names.length - 1, remembered("t", written)));
  show(start);
  const slider = make("input", { "type": "range", "min": 0, "max": names.length - 1, "value": start, "data-tilt": "",
    "input": () => {
      show(Number(slider.value));
      remember("t", Number(slider.value));
    } });
  const chosen = make("div", { class: "wide" }, names.length < 2 ? output
    : make("label", { class: "wide" }, say(differences.names.some(Boolean) ? "case" : "tilt") + " ", slider, output),
  list);
  return [chosen, maps, surface, names.length < 2 ? null : fractionsOf(contact, differences, worst)];
}

/** Contact fractions of the cases: dots over their tilts, a table where the tilts do not differ.
 * @param {import("./data.js").Group} contact @param {ReturnType<typeof differencesOf>} differences
 * @param {string} worst */
function fractionsOf(contact, { names, areTilted }, worst) {
  const tilt = column(contact, "tilt"), fraction = column(contact, "contact_fraction");
  const error = (/** @type {number} */ i) => errorOf(contact, "contact_fraction", i);
  if (!areTilted)
    return make("figure", {}, make("figcaption", {}, say("fractions") + worst), make("table", {}, make("tbody", {},
      ...names.map((name, i) => make("tr", {}, make("th", { scope: "row" }, name || caseNames(contact)[i]),
        make("td", {}, shown(fraction[i], error(i))), make("td", {}, plusMinus(error(i))))))));
  return chart(say("tiltChart") + worst, say("tiltUnit"), say("fraction"), [...new Set(names)].map((name) => {
    const rows = names.flatMap((each, i) => (each === name ? [i] : []));
    return { name: name || say("fraction"), dots: true, x: rows.map((i) => tilt[i] / degree),
      y: rows.map((i) => fraction[i]), error: rows.map((i) => error(i) ?? NaN) };
  }));
}

/** @typedef {{x: number, y: number, depth: number}} Place  on a picture in space */

/** @param {Place} a @param {Place} b @returns {Place} half-way */
function between(a, b) {
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, depth: (a.depth + b.depth) / 2 };
}

/** One tooth space over the face width, turned by dragging; its flanks coloured by the gap map, or each slice of a
 * flank by its smallest gap.
 * @param {import("./data.js").Drive} drive @param {import("./data.js").Group|undefined} map
 * @param {Smallest|null} smallest */
function surfaceFigure(drive, map, smallest) {
  const set = drive.spline.datasets && drive.spline.datasets.outline, z = column(drive.spline, "z");
  if (!set || !set.shape || z.length < 2) return null;
  const outline = column(drive.spline, "outline"), points = set.shape[1], marks = column(drive.spline, "landmarks");
  const angle = smallest ? smallest.angle : column(map, "angle"), gap = column(map, "gap");
  const stations = gap.length ? gap.length / (column(map, "angle").length * 2 * z.length) : 0;
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
    if (smallest) return smallest.at(space, right ? 1 : 0, k);
    const p = Math.round(share * (stations - 1));
    return gap[((space * 2 + (right ? 1 : 0)) * z.length + k) * stations + p] * 1000;
  };
  const draw = () => {
    ctx.fillStyle = colour("paper");
    ctx.fillRect(0, 0, canvas.width, canvas.height);
    /** @type {{corners: Place[], depth: number, fill: string}[]} */
    const quads = [];
    /** A strip between two slices, coloured as its end at slice @p k.
     * @param {number} k @param {number} i @param {Place[]} corners */
    const strip = (k, i, corners) => {
      const g = gapAt(k, i);
      quads.push({ corners, depth: corners.reduce((sum, c) => sum + c.depth, 0),
        fill: Number.isFinite(g) ? gapColour(g) : colour("spline") });
    };
    for (let k = 0; k + 1 < z.length; ++k)
      for (let i = 0; i + step < points; i += step) { // each slice colours half the way to the next
        const near = [project(k, i), project(k, i + step)], far = [project(k + 1, i), project(k + 1, i + step)];
        const half = near.map((a, n) => between(a, far[n]));
        strip(k, i, [...near, half[1], half[0]]);
        strip(k + 1, i, [...half, far[1], far[0]]);
      }
    ctx.lineWidth = 1;
    quads.sort((a, b) => b.depth - a.depth);
    for (const { corners, fill } of quads) {
      ctx.beginPath();
      for (const c of corners) ctx.lineTo(c.x, c.y);
      ctx.closePath();
      ctx.fillStyle = ctx.strokeStyle = fill;
      ctx.fill();
      ctx.stroke();
    }
    ctx.fillStyle = colour("ink");
    ctx.strokeStyle = colour("paper");
    ctx.lineWidth = 6;
    ctx.lineJoin = "round";
    ctx.font = "26px system-ui, sans-serif";
    for (const k of [0, z.length - 1]) { // where the ends are
      const at = project(k, marks[2]);
      const text = `z = ${Number(z[k].toFixed(3))} mm`, width = ctx.measureText(text).width;
      const left = Math.max(6, Math.min(1034 - width, at.x - width / 2)), top = Math.max(28, at.y - 12);
      ctx.strokeText(text, left, top);
      ctx.fillText(text, left, top);
    }
  };
  draw();
  onTheme(canvas, draw);
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
    angle.length ? choice(say("space"), Array.from(angle, (a) => fixed(a / degree, 2) + "°"), space, (i) => {
      space = i;
      draw();
    }) : null, make("p", { class: "note" }, say("turnHelp")), stations ? gapLegend() : null);
}
