// SPDX-License-Identifier: GPL-3.0-or-later
// All words of the page; another language is another table with the same keys.

const english = {
  numbers: "Numbers", mesh: "Teeth in mesh", axial: "Along the axis", load: "Under torque", wedm: "Cutting",
  compare: "Compare", scene: "Scene", about: "About this page", drive: "Drive", warnings: "Warnings",
  notes: "Notes", warningsAndNotes: "Warnings and notes", failedDrives: "Drives that could not be computed",
  noWarnings: "The judgement of the design holds no warning.", search: "Search figures",
  copyCsv: "Copy as CSV", copied: "Copied",
    copyFailed: "The browser does not let this page copy: mark the table instead",
  part: "Part", figure: "Figure", value: "Value", error: "Error ±", unit: "Unit", meaning: "Meaning",
  leftOut: "What this page leaves out", rows: "rows",
  play: "Play", pause: "Pause", speed: "Speed", angle: "Wave generator", slice: "Slice z", view: "Held still",
  flexspline: "flexspline", housing: "circular spline", generator: "wave generator", whole: "Whole drive",
  oneTooth: "One tooth",
  zoomIn: "Zoom in", zoomOut: "Zoom out", ruler: "Ruler", sweep: "Conjugate branches", turned: "Turned to contact",
  gaps: "Gaps", pointer: "Gap under the pointer", smallest: "Smallest gap of the flanks in this slice",
  computed: "Computed at this angle", noTeeth: "The teeth are not shown.", rulerHelp: "Drag from point to point",
  forces: "Forces under load",
  meshHelp: "Drag inside the flexspline to turn the wave generator, elsewhere to move the picture; after a click the "
    + "wheel zooms. Keys: space plays, arrows turn, plus and minus zoom, 0 shows the whole drive, 1 one tooth.",
  loaded: "Under torque", loadedAt: "Under", loadedCase: "surface", loadedTwist: "the drive twists by",
  loadedAngle: "wave generator at",
  loadedTrue: "Nothing is exaggerated: the cup is bent and turned as computed, for this place of the wave generator "
    + "only. The teeth are drawn rigid and with sharp edges: where a tooth enters a flank (vermilion), both yield by "
    + "about as much.",
  loadedHelp: "Drag to move the picture; after a click the wheel zooms. Keys: plus and minus zoom, 0 shows the whole "
    + "drive, 1 one tooth.",
  canvas: "Teeth of both splines", accuracy: "Poses are interpolated from the program's own to",
  outlines: "outlines are exact to", case: "Case", contactGap: "contact gap", light: "Light", dark: "Dark",
  theme: "Light or dark", cells: "place across tooth spaces and slices", left: "left flank", right: "right flank",
  spaceAngle: "tooth space, degrees from the major axis", height: "z [mm]", gapMap: "Smallest gap of each flank [um]",
  turnHelp: "Drag or use the arrow keys to turn", surface: "One tooth space over the face width",
  thinMap: "Each slice of a flank has the colour of its smallest gap. The shape drawn is that of",
  noCone: "Without the cone of the cup: the scene has no table [coning].",
  atMajor: "at the major axis", atMinor: "at the minor axis",
  space: "Tooth space", coning: "Radial displacement of the wall", tilt: "Tilt", radial: "radial displacement [um]",
  torqueTwist: "Twist against torque", twist: "twist [arcmin]", torque: "torque [N m]",
  stiffness: "Stiffness against torque", stiffnessUnit: "stiffness [N m/arcmin]",
  pressure: "Largest pressure away from edges and ends", pressureUnit: "pressure [MPa]", force: "force [N]", ballForce: "force",
  toothForces: "Force of each tooth, all teeth unrolled",
    pressureMap: "Pressure over tooth spaces and face width [MPa]",
  stress: "Stress of the cup's section [MPa]", sectionAngle: "Angle from the major axis", members: "Twist by member",
  balls: "Bearing: forces around the ring", band: "Bands show the estimated error.",
  bandCut: "The band leaves the picture where the error is larger.", notDetermined: "not determined",
  contents: "Contents",
  noBand: "The errors were not estimated.", differs: "differs beyond both errors", same: "within the errors",
  overlaid: "Tooth spaces laid over each other", noError: "differs; no error is stated",
  path: "Wire path", pass: "Pass", face: "Face", lower: "lower", upper: "upper", nominal: "contour of the part",
  residuals: "Material that no pass reaches", jump: "Show", noResiduals: "No pass leaves more than the tolerance of the cut.",
  places: "places", tooth: "first in tooth space", on: "on", flank: "a flank", root: "the root",
    onlyOne: "This report holds one drive.",
  rules: "Design rules", rule: "Rule", usual: "Usual", accepted: "Accepted", found: "This drive", source: "Source",
  any: "any", notAbove: "at most", notBelow: "at least", withinRange: "within the usual range",
  notLoaded: "not known before hdconj load",
  rulesNote: "What a design is judged by, in the plane z = 0. m: module, z_f and z_c: teeth of flexspline and circular "
    + "spline, n: waves, w0: radial deformation.",
  design: "Against the design rules", standing: "Where it stands", range: "Range of the rule", proposed: "Proposed",
  ruleAndSource: "Rule; source", wishes: "Wishes that this drive stands for", wish: "Wish", from: "Taken from",
  rulesCount: "rows", unlikeCount: "where this drive is not as proposed",
  outsideCount: "outside the range of the rule.",
  unlike: "Where this drive is not as proposed", allRules: "All rules", key: "Key", why: "Why",
  noRule: "Keys of the scene that the proposed drive does not have",
  designNote: "hdconj design proposes a drive for the wishes that this scene stands for. A row holds this drive's "
    + "value, and what the rule proposes for it. A range is that of the rule for this drive's own dimensions.",
  built: "Program built with", curvesBy: "Curves are drawn by uPlot; its licence", keyFigures: "Figures to look at first", atTorque: "At", andMore: "and more",
  interference: "interference",
  atNodes: "at the nodes, but not under the bearing, up to",
  white: "empty: no force", bottomOpen: "left: bottom of the cup, right: open end; the axis lies below",
  noErrorNote: "Where the error is empty the program states none, as of counts and given values.", allPasses: "all", wholePart: "Whole part",
  curveHint: "point or press arrow keys to read, drag to zoom, double click for the whole",
  hoverHint: "Point at the picture to read values.", version: "hdconj", printed: "written", summary: "Printed summary",
  running: "While it runs", unloaded: "unloaded", tooth_pitch: "one tooth pitch",
  input_turn: "a turn of the wave generator", output_turn: "until both rings meet as before",
  orders: "periods in a turn of the wave generator",
  amplitude: "amplitude [arcsec]", spectrum: "Orders of the transmission error",
  transmissionError: "Transmission error",
  ahead: "output ahead, mean left out [arcsec]", generatorAngle: "angle of the wave generator [deg]",
  generatorTorque: "Torque on the wave generator, without friction", generatorTorqueUnit: "torque [N m]",
  efficiency: "Efficiency against torque on the output", efficiencyMap: "Efficiency over torque and speed [%]",
  generatorSpeed: "speed of the wave generator [rpm]", outputTorque: "torque on the output [N m]",
  computedPoints: "Dots are computed. Between them the torque lost is interpolated in straight lines",
  leftOutPoint: "interpolated across a computed point, the map is off by at most",
  percentPoints: "points of efficiency", efficiencyUnit: "efficiency [%]", card: "Card of the drive",
  cupIsOutput: "the cup is the output", splineIsOutput: "the circular spline is the output",
  peakToPeak: "peak to peak", ratio: "Ratio", ratedTorque: "Torque on the output", backlash: "Backlash",
  lostMotion: "Lost motion",
  startingTorque: "Starting torque of the wave generator", backDriving: "Back-driving torque on the output",
  stateAngle: "Wave generator at", worst: "worst of the revolution",
  tiltChart: "Contact fraction against tilt", fractions: "Contact fraction of each case", tiltUnit: "tilt [deg]",
  fraction: "contact fraction",
};

/** @type {Record<string, string>} */
const texts = english;

/** The text of a key.
 * @param {keyof typeof english} key */
export function say(key) {
  return texts[key];
}
