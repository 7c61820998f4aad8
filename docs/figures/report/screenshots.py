#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes the pictures of docs/how-to/report.md. Needs Playwright and Chromium.

    screenshots.py PROGRAM FOLDER
"""
import subprocess
import sys
import tempfile
from pathlib import Path

from playwright.sync_api import sync_playwright

PROGRAM, FOLDER = sys.argv[1:3]
SCENES = Path(__file__).resolve().parents[3] / "data/scenes"


def take(playwright, scratch, words, hash_, scheme, act, name):
    file = Path(scratch) / f"{name}.html"
    subprocess.run([PROGRAM, "report", *words, "-o", file, "-q"], check=True)
    browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox"])
    page = browser.new_page(viewport={"width": 900, "height": 620}, color_scheme=scheme)
    page.goto(file.as_uri() + hash_)
    act(page)
    browser.close()


def one_tooth(page):
    page.get_by_role("button", name="One tooth").click()
    page.wait_for_timeout(1500)
    page.locator("canvas.mesh").first.screenshot(path=Path(FOLDER) / "one-tooth.png")


def under_torque(page):
    page.get_by_role("button", name="Under torque").click()
    page.locator("label:has-text('Slice') select").select_option(index=8)
    page.get_by_role("button", name="Zoom in").click()
    page.wait_for_timeout(1500)
    page.locator("canvas.mesh").first.screenshot(path=Path(FOLDER) / "under-torque.png")


def tooth_space(page):
    page.locator("#axial").scroll_into_view_if_needed()
    page.wait_for_timeout(500)
    page.locator("#axial canvas").screenshot(path=Path(FOLDER) / "tooth-space.png")


def running(page):
    page.set_viewport_size({"width": 1100, "height": 940})
    page.evaluate("document.getElementById('run').scrollIntoView()")
    page.wait_for_timeout(800)
    page.evaluate("document.getElementById('run').scrollIntoView()")
    page.screenshot(path=Path(FOLDER) / "running.png")
    efficiency = page.locator("#run figure:has(.contours)")
    efficiency.scroll_into_view_if_needed()
    box = efficiency.locator("svg").bounding_box()
    page.mouse.move(box["x"] + 0.7 * box["width"], box["y"] + 0.3 * box["height"])
    efficiency.screenshot(path=Path(FOLDER) / "efficiency-map.png")


def against_rules(page):
    page.locator("#design").scroll_into_view_if_needed()
    page.wait_for_timeout(500)
    page.locator("#design .whole").screenshot(path=Path(FOLDER) / "design-rules.png")


FRICTION = {"flanks": 0.08, "bearing_load": 0.0005, "bearing_speed": 2, "viscosity_40": 100, "viscosity_100": 11}

with tempfile.TemporaryDirectory() as scratch, sync_playwright() as playwright:
    take(playwright, scratch, [], "#a=2", "light", one_tooth, "one-tooth")
    take(playwright, scratch, [SCENES / "type-50-elastic.toml", "--set", "slices.count=9", "--with", "load", "--no-curve"],
         "#vx=-0.9&vy=25.45&vw=1.6", "light", under_torque, "loaded")
    take(playwright, scratch, [SCENES / "type-50-coned.toml", "--with", "contact"], "", "dark", tooth_space, "space")
    friction = [word for key, value in FRICTION.items() for word in ("--set", f"friction.{key}={value}")]
    take(playwright, scratch, [SCENES / "type-50.toml", *friction, "--with", "load,run"], "", "light", running, "run")
    take(playwright, scratch, ["--with", "design"], "", "light", against_rules, "design")
