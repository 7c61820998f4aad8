// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the page together: one section a view, each made when it comes near the screen.

import { axialView } from "./axial.js";
import { cuttingView } from "./cutting.js";
import { namesOf } from "./data.js";
import { designView } from "./design.js";
import { choice, make, remember, remembered } from "./dom.js";
import { loadView } from "./load.js";
import { meshView } from "./mesh.js";
import { compareView, numbersView } from "./numbers.js";
import { rulesView } from "./rules.js";
import { runningView } from "./running.js";
import { say } from "./texts.js";

const element = /** @type {HTMLElement} */ (document.getElementById("data"));
/** @type {import("./data.js").Report} */
const report = JSON.parse(element.textContent || "{}");
const app = /** @type {HTMLElement} */ (document.getElementById("app"));

const themes = ["light", "dark"];
const darkWanted = matchMedia("(prefers-color-scheme: dark)").matches;
/** @param {string|undefined} theme */
function showTheme(theme) {
  document.documentElement.dataset.theme = theme;
  document.dispatchEvent(new Event("themechange"));
}
/** @param {number} index */
function setTheme(index) {
  remember("dark", index);
  showTheme(themes[index]);
}
showTheme(themes[remembered("dark", darkWanted ? 1 : 0) ? 1 : 0]);

/** Drives that the page should show and does not; null where there are none. */
function failedDrives() {
  const title = say("failedDrives");
  return !report.failed.length ? null : make("section", { "class": "warnings", "aria-label": title },
    make("h2", {}, title),
    make("ul", {}, ...report.failed.map((each) => make("li", { class: "warning" }, `${each.name}: ${each.why}`))));
}

/** @param {import("./data.js").Drive} drive */
function warnings(drive) {
  const notes = drive.judgement.map((note) => make("li", { class: note.severity },
    `${note.severity}: ${note.place ? note.place + ": " : ""}${note.cause}${
      note.advice ? " (" + note.advice + ")" : ""}`));
  const others = (drive.notes || []).map((text) => make("li", {}, text));
  const failed = drive.left_out.filter((each) => each.failed)
    .map((each) => make("li", { class: "warning" }, `${each.part}: ${each.why}`));
  const all = [...failed, ...notes, ...others];
  const alarming = failed.length > 0 || drive.judgement.some((note) => note.severity === "warning");
  const title = say(!others.length ? "warnings" : alarming ? "warningsAndNotes" : "notes");
  return make("section", { "class": alarming ? "warnings" : "notes", "aria-label": title }, make("h2", {}, title),
    all.length ? make("ul", {}, ...all) : make("p", {}, say("noWarnings")));
}

/** What is made when it is needed: before printing, or near the screen.
 * @type {Map<Element, () => void>} */
const later = new Map();
const observer = new IntersectionObserver((entries) => {
  for (const entry of entries) if (entry.isIntersecting) makeNow(entry.target);
}, { rootMargin: "300px" });

/** @param {Element} place */
function makeNow(place) {
  const build = later.get(place);
  later.delete(place);
  observer.unobserve(place);
  if (build) build();
}
window.addEventListener("beforeprint", () => {  // paper is light
  const ofScreen = document.documentElement.dataset.theme;
  window.addEventListener("afterprint", () => showTheme(ofScreen), { once: true });
  showTheme("light");
  [...later.keys()].forEach(makeNow);
});

/** @param {string} id @param {string} title @param {() => Node|null} build */
function section(id, title, build) {
  const place = make("section", { id }, make("h2", {}, title));
  later.set(place, () => {
    const made = build();
    if (made) place.append(made);
  });
  observer.observe(place);
  return place;
}

/** @param {number} index */
function show(index) {
  const drive = report.drives[index], results = drive.results, names = namesOf(report.drives);
  observer.disconnect();
  later.clear();
  const sections = [section("mesh", say("mesh"), () => meshView(drive))];
  const along = drive.spline.datasets && drive.spline.datasets.z && (drive.spline.datasets.z.shape || [0])[0] > 1;
  if (results.contact || results.load || along) sections.push(section("axial", say("axial"), () => axialView(drive)));
  if (results.load) sections.push(section("load", say("load"), () => loadView(drive)));
  if (results.run) sections.push(section("run", say("running"), () => runningView(drive)));
  if (results.wedm) sections.push(section("wedm", say("wedm"), () => cuttingView(drive)));
  if (report.drives.length > 1) sections.push(section("compare", say("compare"), () => compareView(report.drives)));
  const design = drive.design;
  if (design) sections.push(section("design", say("design"), () => designView(design)));
  sections.push(section("rules", say("rules"), () => rulesView(drive.limits, drive)),
    section("numbers", say("numbers"), () => numbersView(drive)),
    section("scene", say("scene"), () => make("pre", { tabindex: 0 }, drive.scene)),
    section("about", say("about"), () => about(drive)));
  const nav = make("nav", { "aria-label": say("contents") },
    ...sections.map((each) => make("a", { href: "#" + each.id, click: (/** @type {Event} */ e) => {
      e.preventDefault(); // the hash holds the state
      each.scrollIntoView({ behavior: "smooth" });
    } }, each.firstChild ? each.firstChild.textContent : "")));
  const theme = document.documentElement.dataset.theme === "dark" ? 1 : 0;
  app.replaceChildren(make("header", {}, make("h1", {}, names[index]),
    make("p", {},
      `${say("version")} ${report.program_version} (${report.git_revision}), ${say("printed")} ${report.date}`),
    drive.origin ? make("p", { class: "origin" }, drive.origin) : null,
    make("div", { class: "controls" },
      report.drives.length > 1 ? choice(say("drive"), names, index, (i) => {
        remember("d", i);
        show(i);
      }) : null,
      choice(say("theme"), [say("light"), say("dark")], theme, setTheme)), nav),
  make("main", {}, failedDrives(), warnings(drive), ...sections));
}

/** @param {import("./data.js").Drive} drive */
function about(drive) {
  return make("div", {}, make("h3", {}, say("leftOut")),
    make("ul", {}, ...drive.left_out.map((each) => make("li", {}, `${each.part}: ${each.why}`))),
    make("p", {}, `${say("built")} ${report.build}`),
    make("details", {}, make("summary", {}, say("curvesBy")),
      make("pre", {}, (document.getElementById("licence") || app).textContent)),
    make("details", {}, make("summary", {}, say("summary")), make("pre", {}, drive.text)));
}

show(Math.min(report.drives.length - 1, Math.max(0, Math.round(remembered("d", 0)))));
