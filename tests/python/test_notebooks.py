# SPDX-License-Identifier: GPL-3.0-or-later
"""The notebooks of the tutorials run, from the folder of the sources, and draw what they say."""

import json
import os
from pathlib import Path

import pytest
from conftest import SOURCE

nbclient = pytest.importorskip("nbclient")
nbformat = pytest.importorskip("nbformat")

NOTEBOOKS = sorted((SOURCE / "docs/tutorials/notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_notebook(notebook, monkeypatch):
    monkeypatch.setenv("MPLBACKEND", "module://matplotlib_inline.backend_inline")
    pages = nbformat.read(notebook, as_version=4)
    nbclient.NotebookClient(pages, timeout=600, resources={"metadata": {"path": str(SOURCE)}}).execute()
    shown = [output for cell in pages.cells if cell.cell_type == "code" for output in cell.outputs]
    drawings = [output for output in shown if "image/png" in output.get("data", {})]
    assert len(drawings) >= 2
    if "HDCONJ_SHOWN" in os.environ:  # to be looked at
        nbformat.write(pages, Path(os.environ["HDCONJ_SHOWN"]) / notebook.name)


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_stored_without_what_it_shows(notebook):
    for cell in json.loads(notebook.read_text())["cells"]:
        assert cell.get("outputs", []) == [] and cell.get("execution_count") is None
