// SPDX-License-Identifier: GPL-3.0-or-later
// The teeth where torque has bent and turned the flexspline: poses of one place of the wave generator, as the program
// computed them.

import { column, groupAt } from "./data.js";
import { Mesh } from "./motion.js";

/** The group of the loaded teeth; undefined where there are none.
 * @param {import("./data.js").Drive} drive */
export function loadedTeeth(drive) {
  return groupAt(drive.results.load, "load/loaded_teeth");
}

export class LoadedMesh extends Mesh {
  /** @param {import("./data.js").Drive} drive  with loaded teeth */
  constructor(drive) {
    super(drive, drive.loaded_spline || drive.spline);
    const group = loadedTeeth(drive);
    this.z = Array.from(column(group, "z"));
    this.phi0 = column(group, "phi")[0];
    this.origin = column(group, "origin");
    this.leans = column(group, "lean");
    this.step = 2 * Math.PI / this.flexsplineTeeth;
    /** Turn of the flexspline in the spaces, clockwise. */
    this.loadedTurn = /** @type {import("./data.js").Group} */ (group).attributes?.turn_rad;
    const phase = this.phi0 - this.step * Math.round(this.phi0 / this.step);
    this.loadedAngle = -phase * this.flexsplineTeeth / this.spaces;
    this.gapError -= this.teeth.interpolation_error; // each pose is the program's own
  }

  /** Only at the teeth themselves.
   * @param {number} slice @param {number} phi @returns {import("./motion.js").Pose} */
  pose(slice, phi) {
    const n = this.flexsplineTeeth, tooth = Math.round((phi - this.phi0) / this.step);
    const i = (((tooth % n) + n) % n) * this.z.length + slice;
    return { x: this.origin[2 * i], y: this.origin[2 * i + 1], lean: this.leans[i] };
  }

  /** Each space is a place of its own.
   * @param {number} space @param {number} generator */
  place(space, generator) {
    return { key: space, space, generator };
  }
}
