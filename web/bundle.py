#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes web/bundle.js of web/src: checks the types with tsc, bundles with esbuild.

    bundle.py           writes web/bundle.js
    bundle.py --check   compares it with what the sources give; --control breaks a source, which must be caught
"""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

WEB = Path(__file__).resolve().parent
BANNER = "/* SPDX-License-Identifier: GPL-3.0-or-later; sources: web/src */"
VERSION = "0.17.0"  # of esbuild: others write the same program with other names


def bundle(web, typed=True):
    if typed:
        subprocess.run(["tsc", "-p", str(web)], check=True)
    return subprocess.run(["esbuild", str(web / "src/main.js"), "--bundle", "--minify", "--target=es2020",
                           "--format=iife", f"--banner:js={BANNER}", "--log-level=warning"],
                          check=True, capture_output=True, text=True).stdout


def differs(web, typed=True):
    return bundle(web, typed) != (web / "bundle.js").read_text()


def control():
    """A source with a wrong type, and one that does another thing, must both be caught."""
    with tempfile.TemporaryDirectory() as folder:
        for change, typed in (("export const wrong = turned(\"1\", 2, 3);\n", True),
                              ("document.title = \"another\";\n", False)):
            web = Path(folder) / "web"
            shutil.copytree(WEB, web, dirs_exist_ok=True)
            with open(web / "src/motion.js", "a", encoding="utf-8") as source:
                source.write("\n" + change)
            try:
                caught = differs(web, typed)
            except subprocess.CalledProcessError:
                caught = typed
            if not caught:
                return "a changed source is not caught"
    return ""


def main():
    missing = [tool for tool in ("tsc", "esbuild") if shutil.which(tool) is None]
    if not missing and VERSION != subprocess.run(["esbuild", "--version"], capture_output=True, text=True,
                                                 check=True).stdout.strip():
        missing = ["esbuild " + VERSION]
    if missing:
        print("NOT TRIED: no " + " and no ".join(missing))
        return 0 if len(sys.argv) > 1 else 1
    if "--control" in sys.argv:
        fault = control()
        print(fault or "a changed source is caught")
        return 1 if fault else 0
    elif "--check" in sys.argv:
        fault = "web/bundle.js is not what web/src gives: run web/bundle.py" if differs(WEB) else ""
    else:
        (WEB / "bundle.js").write_text(bundle(WEB))
        fault = ""
    print(fault or "web/bundle.js is what web/src gives")
    return 1 if fault else 0


if __name__ == "__main__":
    sys.exit(main())
