// SPDX-License-Identifier: GPL-3.0-or-later
// The rules that a design is judged by, and what was found.

import { wideTable } from "./design.js";
import { make } from "./dom.js";
import { say } from "./texts.js";

/** Rules whose figure is not known before the drive is loaded. */
const knownUnderLoad = ["backlash", "teeth-end"];

/** What was found of a rule that no note is about.
 * @param {string} code @param {import("./data.js").Drive} drive */
function withoutNote(code, drive) {
  const known = !knownUnderLoad.includes(code) || drive.results.load || drive.results.run;
  return say(known ? "withinRange" : "notLoaded");
}

/** @param {(number|null)[]} range @param {string} unit */
function rangeText(range, unit) {
  const [low, high] = range.map((end) => (end === null ? null : Number(end.toPrecision(3))));
  const ending = unit === "1" ? "" : " " + unit;
  if (low === null) return high === null ? say("any") : `${say("notAbove")} ${high}${ending}`;
  return high === null ? `${say("notBelow")} ${low}${ending}` : `${low} ... ${high}${ending}`;
}

/** @param {import("./data.js").Limit[]} limits @param {import("./data.js").Drive} drive */
export function rulesView(limits, drive) {
  const head = [say("rule"), say("usual"), say("accepted"), say("found"), say("source")];
  const rows = limits.map((limit) => {
    const note = drive.judgement.find((each) => each.code === limit.code);
    return { kind: note ? note.severity : undefined, cells: [
      make("span", {}, limit.code, make("small", {}, limit.figure)), rangeText(limit.usual, limit.unit),
      rangeText(limit.accepted, limit.unit), note ? `${note.severity}: ${note.cause}` : withoutNote(limit.code, drive),
      limit.source] };
  });
  return make("div", {}, make("p", { class: "note" }, say("rulesNote")), wideTable(say("rules"), head, rows));
}
