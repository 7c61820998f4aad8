// SPDX-License-Identifier: GPL-3.0-or-later
// The drive while it turns, and the figures that a catalogue has of it.

import { bars, chart } from "./curves.js";
import { attributeError, brief, column, groupAt, isUnknown, plusMinus, shown, shownError, valuesOf } from "./data.js";
import { make } from "./dom.js";
import { efficiencyMaps } from "./efficiency.js";
import { say } from "./texts.js";

const arcsecond = Math.PI / 180 / 3600, degree = Math.PI / 180, newtonMetre = 1000, perMinute = 2 * Math.PI / 60;

/** @param {ArrayLike<number>} values @param {number} unit */
function by(values, unit) {
  return Array.from(values, (v) => v / unit);
}

/** Values less their mean.
 * @param {number[]} values */
function aboutMean(values) {
  const mean = values.reduce((sum, v) => sum + v, 0) / values.length;
  return values.map((v) => v - mean);
}

/** Sequences of positions, each with its name.
 * @param {import("./data.js").Group} running */
function sequencesOf(running) {
  return Object.entries(running.groups || {}).filter(([name]) => name.startsWith("sequence_")).sort()
    .map(([, group]) => {
      const of = group.attributes || {}, torque = of.torque_Nmm / newtonMetre;
      return { group, of, torque: of.torque_Nmm,
        name: `${say(of.span)}, ${torque ? `${brief(torque)}\u00a0N\u00a0m` : say("unloaded")}` };
    });
}

/** Orders that are seen: the largest ones, at most as many as a chart has room for.
 * @param {import("./data.js").Group} group @param {string} title */
function spectrum(group, title) {
  const room = 40, order = column(groupAt(group, "spectrum"), "per_input");
  const amplitude = by(column(groupAt(group, "spectrum"), "amplitude"), arcsecond);
  const error = by(column(groupAt(group, "spectrum"), "amplitude_error"), arcsecond);
  const kept = amplitude.map((_, i) => i).sort((a, b) => amplitude[b] - amplitude[a]).slice(0, room)
    .sort((a, b) => a - b);
  return bars(title, say("orders"), say("amplitude"), kept.map((i) => order[i]), kept.map((i) => amplitude[i]),
    error.length ? kept.map((i) => error[i]) : []);
}

/** Efficiency against torque, a curve for each speed and temperature.
 * @param {import("./data.js").Group} losses */
function efficiencyChart(losses) {
  const torque = by(column(losses, "torque"), newtonMetre), speed = column(losses, "speed");
  const temperature = column(losses, "temperature"), value = column(losses, "efficiency");
  const error = column(losses, "efficiency_error");
  /** @type {Map<string, number[]>} */
  const curves = new Map();
  torque.forEach((_, i) => {
    const name = `${brief(speed[i] / perMinute)} rpm, ${brief(temperature[i])} °C`;
    curves.set(name, [...(curves.get(name) || []), i]);
  });
  return chart(say("efficiency"), say("torque"), say("efficiencyUnit"), [...curves].map(([name, rows]) => ({
    name, x: rows.map((i) => torque[i]), y: rows.map((i) => 100 * value[i]),
    error: error.length ? rows.map((i) => 100 * error[i]) : undefined })));
}

/** @typedef {[string, number, number|null, string]} CardRow */

/** A figure of a group as a row of the card.
 * @param {string} name @param {import("./data.js").Group|undefined} group @param {string} key @param {number} index
 * @param {number} unit @param {string} units @returns {CardRow[]} */
function rowOf(name, group, key, index, unit, units) {
  const place = ((group && group.figures) || []).find((each) => each[0] === key);
  if (!group || !place) return [];
  if (place[5]) {
    const of = group.attributes || {}, error = attributeError(group, place);
    return typeof of[place[1]] === "number" ? [[name, of[place[1]] / unit, error === null ? null : error / unit, units]]
      : [];
  }
  const { values, errorAt } = valuesOf(group, place), error = errorAt(index);
  return index < values.length ? [[name, values[index] / unit, error === null ? null : error / unit, units]] : [];
}

/** What a catalogue says of a drive, as far as the parts of the page hold it.
 * @param {import("./data.js").Drive} drive @param {import("./data.js").Group} running
 * @param {import("./data.js").Group|undefined} losses */
function card(drive, running, losses) {
  const load = groupAt(drive.results.load, "load");
  const index = (load && load.attributes && load.attributes.written_case) || 0;
  const catalogue = groupAt(load, `case_${String(index).padStart(3, "0")}/catalogue`);
  const turnsCup = running.attributes?.output === "flexspline";
  // load has the figures of the circular spline: a cup turns so much further under a torque so much smaller
  const further = turnsCup ? drive.circular_spline_teeth / drive.flexspline_teeth : 1;
  const arcmin = degree / 60 / further, perArcmin = further * newtonMetre / arcmin;
  const rows = [...rowOf(say("ratio"), running, "ratio", 0, 1, ""),
    ...rowOf(say("ratedTorque"), running, "torque", 0, newtonMetre, "N m"),
    ...["K1", "K2", "K3"].flatMap((k) => rowOf(k, catalogue, k, 0, perArcmin, "N m/arcmin")),
    ...rowOf(say("backlash"), load, "backlash", index, arcmin, "arcmin"),
    ...rowOf(say("lostMotion"), catalogue, "lost_motion", 0, arcmin, "arcmin"),
    ...sequencesOf(running).flatMap(({ group, name }) =>
      rowOf(`${say("transmissionError")}, ${name}`, group, "peak_to_peak", 0, arcsecond, "arcsec")),
    ...rowOf(say("startingTorque"), losses, "starting_torque", 0, newtonMetre, "N m"),
    ...rowOf(say("backDriving"), losses, "back_driving_torque", 0, newtonMetre, "N m")];
  return make("div", { class: "wide" }, make("h3", {},
    `${say("card")}: ${say(turnsCup ? "cupIsOutput" : "splineIsOutput")}`), make("table", { "class": "keys",
    "aria-label": say("card") }, make("tbody", {}, ...rows.map(([name, value, error, units]) => make("tr",
    { "data-name": name, "data-value": value }, make("th", { scope: "row" }, name), make("td", {}, shown(value, error)),
    make("td", {}, plusMinus(error)), make("td", {}, units,
      isUnknown(value, error) ? make("em", {}, say("notDetermined")) : null))))));
}

/** @param {import("./data.js").Drive} drive */
export function runningView(drive) {
  const running = groupAt(drive.results.run, "running");
  if (!running) return null;
  const losses = groupAt(running, "losses");
  const figures = sequencesOf(running).flatMap(({ group, torque, name }) => {
    const angle = by(column(group, "angle"), degree), [span] = rowOf("", group, "peak_to_peak", 0, arcsecond, "");
    const peaks = span ? `${say("peakToPeak")} ${shown(span[1], span[2])}${span[2]
      ? ` ± ${shownError(span[2])}` : ""} arcsec` : name;
    const made = [chart(`${say("transmissionError")}: ${name}`, say("generatorAngle"), say("ahead"),
      [{ name: peaks, x: angle, y: aboutMean(by(column(group, "error"), arcsecond)),
        error: by(column(group, "error_error"), arcsecond) }]),
    spectrum(group, `${say("spectrum")}: ${name}`)];
    if (torque)
      made.push(chart(`${say("generatorTorque")}: ${name}`, say("generatorAngle"), say("generatorTorqueUnit"),
        [{ name, x: angle, y: by(column(group, "wave_generator_torque"), newtonMetre),
          error: by(column(group, "wave_generator_torque_error"), newtonMetre) }]));
    return made;
  });
  return make("div", { class: "figures" }, card(drive, running, losses), ...figures,
    ...(losses ? [...efficiencyMaps(losses), efficiencyChart(losses)] : []));
}
