#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes web/bundle.js of web/src: checks the types with tsc, bundles with esbuild. uPlot, which draws the curves,
stands beside it as it is published (web/third_party).

    bundle.py           writes web/bundle.js
    bundle.py --check   compares it with what the sources give, and uPlot with its checksums
    bundle.py --control breaks sources, and uPlot, which must be caught
"""
import hashlib
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


def changed(library):
    """The files of a library that are not as it was published."""
    sums = dict(reversed(line.split()) for line in (library / "SHA256SUMS").read_text().splitlines())
    return [name for name, known in sums.items()
            if hashlib.sha256((library / name).read_bytes()).hexdigest() != known]


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
        library = Path(folder) / "web/third_party/uPlot"
        with open(library / "uPlot.iife.min.js", "a", encoding="utf-8") as source:
            source.write("\n")
        if changed(library) != ["uPlot.iife.min.js"]:
            return "a changed file of uPlot is not caught"
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
        fault = "web/bundle.js is not what web/src gives: run web/bundle.py" if differs(WEB) else ", ".join(
            f"third_party/uPlot/{name} is not as published" for name in changed(WEB / "third_party/uPlot"))
    else:
        (WEB / "bundle.js").write_text(bundle(WEB))
        fault = ""
    print(fault or "web/bundle.js is what web/src gives")
    return 1 if fault else 0


if __name__ == "__main__":
    sys.exit(main())
