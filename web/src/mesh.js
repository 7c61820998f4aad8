// SPDX-License-Identifier: GPL-3.0-or-later
// The view of the teeth in mesh: controls, keys, readings.

import { caseAt, caseNames, coneNote, writtenCase } from "./cases.js";
import { column, errorOf, fixed, groupAt, shown, shownError } from "./data.js";
import { choice, legend, make, onTheme, remember, remembered, toggle } from "./dom.js";
import { keyFigures } from "./keys.js";
import { LoadedMesh, loadedTeeth } from "./loaded.js";
import { Mesh, turned } from "./motion.js";
import { Painter } from "./paint.js";
import { say } from "./texts.js";
import { View } from "./view.js";

const degree = Math.PI / 180;
const colourLimit = 0.05; // mm, the gap at the end of the colours

/** @param {import("./data.js").Drive} drive */
export function meshView(drive) {
  if (!drive.teeth) return make("p", {}, say("noTeeth"));
  const place = make("div", {});
  /** @param {boolean} loaded */
  const show = (loaded) => place.replaceChildren(teethView(drive, loaded, show));
  show(remembered("u", 0) === 1 && loadedTeeth(drive) !== undefined);
  return place;
}

/** The teeth on the wave generator alone, which turns, or under torque at one place of it.
 * @param {import("./data.js").Drive} drive @param {boolean} loaded @param {(loaded: boolean) => void} show */
function teethView(drive, loaded, show) {
  const still = loaded ? new LoadedMesh(drive) : null;
  const mesh = still || new Mesh(drive), painter = new Painter(drive, mesh);
  const contact = groupAt(drive.results.contact, "contact"), drawn = writtenCase(contact);
  const revolution = caseAt(contact, drawn, "revolution"), angles = column(revolution, "wave_generator");
  const s = {
    angle: still ? still.loadedAngle : remembered("a", 0) * degree,
    slice: Math.min(mesh.z.length - 1, remembered("k", mesh.z.length >> 1)),
    turn: still ? still.loadedTurn : 0, held: remembered("h", 0), limit: colourLimit,
    sweep: !still && remembered("s", 0) === 1, forces: loaded, loaded,
    /** @type {{x: number, y: number}[]} */ ruler: [],
  };
  let playing = false, speed = 20, measuring = false, last = 0, wanted = false, work = 0;
  /** @type {{x: number, y: number}|null} */
  let pointer = null;

  const canvas = make("canvas", { "class": "mesh", "tabindex": 0, "role": "img", "aria-label": say("canvas") });
  const ctx = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d", { alpha: false }));
  const slider = make("input", { type: "range", min: 0, max: 360, step: 0.01, value: s.angle / degree,
    input: () => turnTo(Number(slider.value) * degree) });
  const number = make("output", {});
  const pointed = make("output", { class: "reading" }), least = make("output", { class: "reading", "data-gap": "" });
  const computed = make("div", { class: "computed" });
  const reach = mesh.reach + 4 * drive.module;
  const view = new View(canvas, "v", { x: 0, y: 0, span: 2.08 * reach }, draw);

  function draw() {
    if (wanted) return;
    wanted = true;
    requestAnimationFrame(frame);
  }
  /** @param {number} now */
  function frame(now) {
    wanted = false;
    const began = performance.now();
    if (playing) {
      if (last) s.angle += speed * degree * Math.min(0.1, (now - last) / 1000);
      last = now;
      label();
    }
    painter.paint(ctx, view, s);
    work = performance.now() - began;
    canvas.dataset.work = work.toFixed(2);
    if (!canvas.dataset.first) canvas.dataset.first = performance.now().toFixed(1); // ms after the page was opened
    canvas.dataset.frames = String(Number(canvas.dataset.frames || 0) + 1);
    if (playing || !painter.known) draw();
    readPointer();
  }
  function label() {
    const turn = ((s.angle % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
    slider.value = String(turn / degree);
    number.textContent = (turn / degree).toFixed(2) + "°";
  }
  let settled = 0;
  /** @param {number} angle */
  function turnTo(angle) {
    if (still) return;
    s.angle = angle;
    remember("a", angle / degree);
    label();
    settle();
    draw();
  }
  function settle() {
    clearTimeout(settled);
    settled = window.setTimeout(readLeast, 120);
  }
  /** The state of the drawn case whose angle is nearest. */
  function stateAt() {
    // states repeat with every tooth space
    const away = (/** @type {number} */ a) => Math.abs(remainder(a - s.angle, mesh.pitch));
    const off = Array.from(angles, away), index = off.indexOf(Math.min(...off));
    if (index >= 0) return { state: revolution, index, off: off[index], angle: angles[index] };
    const angle = column(contact, "wave_generator")[drawn];
    return { state: contact, index: drawn, off: away(angle), angle };
  }
  function readLeast() {
    if (playing) return;
    const found = mesh.smallest(s.slice, s.angle, s.turn);
    least.value = `${fixed(found.gap * 1000, 2)} um ± ${shownError(mesh.gapError * 1000)} um`;
    least.dataset.gap = String(found.gap * 1000);
    least.dataset.space = String(found.space);
    readComputed();
  }
  function readComputed() {
    computed.replaceChildren();
    if (!contact || still) return;
    const { state, index, off } = stateAt();
    if (!state || !(off < 1e-7)) return;
    computed.append(make("strong", {}, `${say("computed")}: ${caseNames(contact)[drawn]}`), keyFigures(state, index,
      ["smallest_gap", "turn_to_contact", "reverse_turn_to_contact", "backlash", "contact_fraction", "teeth"]),
      coneNote(drive) || "");
  }
  function readPointer() {
    if (!pointer) return;
    const spin = s.held === 1 ? -s.angle : 0;
    const space = Math.round((Math.atan2(pointer.x, pointer.y) - spin) / mesh.pitch);
    const local = turned(pointer.x, pointer.y, -(space * mesh.pitch + spin));
    let best = Infinity, at = { x: 0, y: 0 };
    for (let i = 0; i < mesh.points; ++i) {
      const p = mesh.at(s.slice, i), d = Math.hypot(p.x - local.x, p.y - local.y);
      if (d < best) {
        best = d;
        at = p;
      }
    }
    if (best > 2 * drive.module) {
      pointed.value = "–";
      return;
    }
    const gap = mesh.gap(at, s.slice, space, s.angle, s.turn);
    pointed.value = `${fixed(gap * 1000, 2)} um ± ${shownError(mesh.gapError * 1000)} um`;
    pointed.dataset.gap = String(gap * 1000);
  }
  const play = make("button", { type: "button", class: "play", click: () => {
    playing = !playing;
    last = 0;
    play.textContent = say(playing ? "pause" : "play");
    if (!playing) turnTo(s.angle);
    draw();
  } }, say("play"));
  function oneTooth() {
    const lean = Math.round(s.angle / mesh.pitch) * mesh.pitch + (s.held === 1 ? -s.angle : 0);
    const at = turned(0, painter.seat, lean);
    view.show(at.x, at.y, 6 * drive.module);
  }

  let grip = 0;
  view.onDrag = (x, y, what) => {
    if (measuring) {
      if (what === "start") s.ruler = [{ x, y }];
      else s.ruler = [s.ruler[0], { x, y }];
      draw();
      return true;
    }
    const polar = Math.atan2(x, y);
    if (what === "start") {
      grip = polar;
      return !still && s.held === 0 && Math.hypot(x, y) < painter.seat - 3 * drive.module;
    }
    turnTo(s.angle + remainder(polar - grip, 2 * Math.PI));
    grip = polar;
    return true;
  };
  view.onHover = (x, y) => {
    pointer = { x, y };
    if (!playing) readPointer();
  };
  canvas.addEventListener("keydown", (/** @type {KeyboardEvent} */ e) => {
    const act = { " ": () => play.click(), "ArrowLeft": () => turnTo(s.angle - degree * (e.shiftKey ? 0.1 : 1)),
      "ArrowRight": () => turnTo(s.angle + degree * (e.shiftKey ? 0.1 : 1)), "+": () => view.zoom(1.4),
      "-": () => view.zoom(1 / 1.4), "0": () => view.showAll(), "1": oneTooth }[e.key];
    if (!act) return;
    e.preventDefault();
    act();
  });
  onTheme(canvas, () => {
    painter.colours();
    painter.paint(ctx, view, s);  // at once: the page may be about to be printed
  });

  /** @param {string} text @param {() => void} act */
  const button = (text, act) => make("button", { type: "button", click: act }, text);
  const turning = still ? [] : [play, make("label", { class: "wide" }, say("angle") + " ", slider, number),
    make("label", {}, say("speed") + " ", make("input", { type: "range", min: 1, max: 120, value: speed,
      input: (/** @type {any} */ e) => { speed = Number(e.target.value); } }))];
  const controls = make("div", { class: "controls" }, ...turning,
    loadedTeeth(drive) ? toggle(say("loaded"), loaded, (on) => {
      playing = false;
      remember("u", on ? 1 : 0);
      show(on);
    }) : null,
    mesh.z.length > 1 ? choice(say("slice"), mesh.z.map((z) => fixed(z, 2) + " mm"), s.slice, (k) => {
      s.slice = k;
      remember("k", k);
      settle();
      draw();
    }) : null,
    choice(say("view"), [say("housing"), say("generator")], s.held, (h) => {
      s.held = h;
      remember("h", h);
      draw();
    }),
    angles.length && !still ? choice(say("computed"), Array.from(angles, (a) => (a / degree).toFixed(3) + "°"), -1,
      (i) => turnTo(angles[i])) : null,
    button(say("whole"), () => view.showAll()), button(say("oneTooth"), oneTooth),
    button(say("zoomIn"), () => view.zoom(1.6)), button(say("zoomOut"), () => view.zoom(1 / 1.6)),
    toggle(say("ruler"), false, (on) => {
      measuring = on;
      s.ruler = [];
      canvas.classList.toggle("ruler", on);
      draw();
    }),
    still ? null : toggle(say("sweep"), s.sweep, (on) => {
      s.sweep = on;
      remember("s", on ? 1 : 0);
      draw();
    }),
    contact && !still ? toggle(say("turned"), false, (on) => {
      const { state, index, angle } = stateAt();
      s.turn = on && state ? column(state, "turn_to_contact")[index] : 0;
      turnTo(on ? angle + Math.round((s.angle - angle) / mesh.pitch) * mesh.pitch : s.angle);
    }) : null,
    drive.results.load && (still || !loadedTeeth(drive)) ? toggle(say("forces"), s.forces, (on) => {
      s.forces = on;
      if (on) turnTo(0);
      draw();
    }) : null);
  label();
  settle();
  const accuracy = still ? "" : `${say("accuracy")} ${shownError(mesh.teeth.interpolation_error * 1000)} um, ${
    say("outlines")} ${shownError(drive.outline_error * 1000)} um.`;
  return make("div", { class: "view" }, controls, canvas,
    make("div", { class: "readings" }, make("span", {}, say("pointer") + " ", pointed),
      make("span", {}, say("smallest") + " ", least), make("span", {}, say("gaps") + " ", legend("0", "50 um")),
      ...["flexspline", "spline", "generator"].map((part) => make("span", { class: `patch ${part}` },
        say(part === "spline" ? "housing" : /** @type {"flexspline"|"generator"} */ (part))))),
    still ? make("p", { class: "loaded" }, loadedNote(drive, still)) : computed,
    make("p", { class: "note" }, say(still ? "loadedHelp" : "meshHelp") + " " + accuracy));
}

/** What the picture of the loaded teeth shows.
 * @param {import("./data.js").Drive} drive @param {LoadedMesh} mesh */
function loadedNote(drive, mesh) {
  const load = groupAt(drive.results.load, "load"), index = writtenCase(load), map = caseAt(load, index, "map");
  const torque = Number(((map?.attributes?.torque_Nmm || 0) / 1000).toPrecision(4));
  const minutes = 60 / degree, twist = column(load, "twist")[index] * minutes, known = errorOf(load, "twist", index);
  const error = known === null ? null : known * minutes;
  return `${say("loadedAt")} ${torque} N m, ${say("loadedCase")} ${caseNames(load)[index]}: ${say("loadedTwist")} ${
    shown(twist, error)}${error ? ` ± ${shownError(error)}` : ""} arcmin, ${say("loadedAngle")} ${
    fixed(mesh.loadedAngle / degree, 2)}°. ${say("loadedTrue")}`;
}

/** @param {number} a @param {number} b */
function remainder(a, b) {
  return a - b * Math.round(a / b);
}
