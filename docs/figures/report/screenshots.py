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
with tempfile.TemporaryDirectory() as scratch, sync_playwright() as playwright:
    page_file = Path(scratch) / "drive.html"
    subprocess.run([PROGRAM, "report", "-o", page_file, "-q"], check=True)
    browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox"])
    page = browser.new_page(viewport={"width": 900, "height": 620})
    page.goto(page_file.as_uri() + "#a=2")
    canvas = page.locator("canvas.mesh").first
    page.get_by_role("button", name="One tooth").click()
    page.wait_for_timeout(1500)
    canvas.screenshot(path=Path(FOLDER) / "one-tooth.png")
    browser.close()
