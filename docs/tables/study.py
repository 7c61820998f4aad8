#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures studies: docs/tables/study.py TABLE [PAIRS]

TABLE is one of: overhead, workers, shard, search, liu. Tables are written as data/reference/study-TABLE.csv; draw makes
the picture of search. The interpreter must have the package hdconj[study].
"""

import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMMAND = "docs/tables/study.py"
VARIED = """
[vary]
"flexspline.wall" = { from = 0.6, to = 0.8 }
"wave_generator.radial_deformation" = { from = 0.24, to = 0.26 }
[sample]
count = COUNT
"""
SOLVE = VARIED + '[compute]\nverb = "solve"\n[figures]\nland = "solve.land_width"\ndepth = "solve.space_depth"\n'
CONTACT = (
    f'scene = "{ROOT}/data/scenes/type-50-coned.toml"\n'
    '[set]\n"slices.count" = 7\n"slices.surface" = "tilted"\n"contact.flank_points" = 80\n"solver.tolerance" = 1e-5\n'
    + VARIED.replace('"flexspline.wall" = { from = 0.6, to = 0.8 }', '"tilt.angle_deg" = { from = 0.0, to = 0.4 }')
    + '[compute]\nverb = "contact"\n[figures]\narea = "contact.contact_area"\n'
    'clearance = "1000 * contact.least_side_clearance"\n'
)
# The same drives, and nothing but scenes and results.
LOOP = """
import sys
import hdconj
from hdconj.study import load_recipe
recipe = load_recipe(sys.argv[1])
verb, errors = recipe.verbs[0][0], {} if recipe.verbs[0][0] == "solve" else {"errors": False}
call = getattr(hdconj, verb)
for i in range(recipe.drives):
    try:
        call(recipe.scene.with_({**recipe.values(i), "solver.threads": 1}), **errors)
    except hdconj.NumericalError:
        pass
"""
ALONE = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "GOMP_SPINCOUNT": "3000"}


def write(table, head, rows):
    """Writes a table with the command that makes it."""
    file = ROOT / "data" / "reference" / f"study-{table}.csv"
    lines = [f"# made by (long): {COMMAND} {' '.join(sys.argv[1:])}", ",".join(head)]
    file.write_text("\n".join(lines + [",".join(f"{x:.4g}" if isinstance(x, float) else str(x) for x in row)
                                       for row in rows]) + "\n")  # fmt: skip
    print(file.read_text())


def seconds_of(words):
    """Processor time of a command and all that it starts, and time on the clock."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(words, check=True, env=ALONE, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return sum(after[:2]) - sum(before[:2]), time.perf_counter() - begin


def per_drive(text, few, many, words):
    """Processor time of a drive [ms]: the difference between many drives and few, which leaves out the start."""
    spent = {}
    for count in (few, many):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "study.toml")
            file.write_text(text.replace("COUNT", str(count)))
            spent[count] = seconds_of(words(file, Path(folder, "out")))[0]
    return (spent[many] - spent[few]) / (many - few) * 1000


def overhead(pairs):
    """What a study costs beside a loop over the same drives, in pairs of runs: shards of 10 s."""
    rows = []
    for name, text, few, many in (("solve", SOLVE, 1000, 5000), ("contact", CONTACT, 40, 240)):
        loop, study = [], []
        for _ in range(pairs):
            loop.append(per_drive(text, few, many, lambda file, _: [sys.executable, "-c", LOOP, file]))
            study.append(per_drive(text, few, many, lambda file, out: [
                sys.executable, "-m", "hdconj.study", "run", file, "-o", out, "--jobs", "1", "--quiet"]))  # fmt: skip
        ratios = sorted(100 * (b / a - 1) for a, b in zip(loop, study))
        rows.append((name, pairs, statistics.median(loop), statistics.median(study), statistics.median(ratios),
                     ratios[0], ratios[-1]))  # fmt: skip
    write("overhead", ("verb", "pairs", "loop [ms]", "study [ms]", "overhead [%]", "least [%]", "most [%]"), rows)



def workers(pairs):
    """Processor time of a drive, command and scheduler included, with one worker and with two at once.

    Whole cores would compute workers/time drives a second. Other work of the machine does not count.
    """
    rows = []
    for name, text, few, many in (("solve", SOLVE, 500, 2500), ("contact", CONTACT, 20, 120)):
        spent = {1: [], 2: []}
        for _ in range(pairs):
            for jobs in spent:
                spent[jobs].append(per_drive(text, few, many, lambda file, out: [
                    sys.executable, "-m", "hdconj.study", "run", file, "-o", out, "--jobs", str(jobs),
                    "--quiet"]))  # fmt: skip
        for jobs, times in spent.items():
            rows.append((name, jobs, statistics.median(times), 1000 * jobs / statistics.median(times)))
    write("workers", ("verb", "workers", "processor time [ms]", "drives a second"), rows)


def shard(_):
    """What the command spends on a shard whose rows come back from a worker: taking it in, and writing its file."""
    from hdconj import study
    from hdconj.study._engine import engine
    from hdconj.study._shards import schema_of, write_shard

    recipe, rows = study.read_recipe(SOLVE.replace("COUNT", "8")), []
    row = {"sample": 0, **recipe.values(0), **dict.fromkeys(("land", "land_error", "depth", "depth_error"), 0.1),
           **dict.fromkeys(("code", "stage", "place", "cause"), "")}  # fmt: skip
    for drives, shards in ((1, 200), (200, 50), (2000, 10)):
        with engine(1) as client, tempfile.TemporaryDirectory() as folder:
            made = [{**row, "sample": i, "land": i / 7} for i in range(drives)]
            begin = time.process_time()
            for future in [client.submit(_rows_like, row, drives, i, pure=False) for i in range(shards)]:
                future.result()
            taken = (time.process_time() - begin) / shards
            begin = time.process_time()
            for i in range(shards):
                for each in made:
                    each["sample"] += drives
                write_shard(Path(folder), made, schema_of(recipe), {"units": {}, "seconds": 1.0, "errors": False})
            rows.append((drives, 1000 * taken, 1000 * (time.process_time() - begin) / shards))
    write("shard", ("drives", "taking in [ms]", "writing [ms]"), rows)


def _rows_like(row, drives, seed):
    return [{**row, "sample": i, "land": (i + seed) / 7} for i in range(drives)]


SEARCHED = """
[set]
"solver.tolerance" = 1e-3
[vary]
"wave_generator.radial_deformation" = { from = 0.24, to = 0.26 }
"flexspline.wall" = { from = 0.6, to = 0.8 }
"flexspline.profile.convex_radius" = { from = 0.24, to = 0.30 }
"flexspline.profile.concave_radius" = { from = 0.45, to = 0.58 }
"flexspline.profile.concave_rise" = { from = 0.03, to = 0.10 }
[sample]
method = "sobol"
count = 400
seed = SEED
[compute]
verb = "solve"
[figures]
depth = { value = "1000 * solve.space_depth", unit = "um" }
land = { value = "1000 * solve.land_width", unit = "um" }
[objectives]
depth = "max"
land = "max"
[optimise]
method = "METHOD"
population = 20
generations = 20
seed = SEED
"""
METHODS = ("nsga2", "sobol", "random")
NAMES = {"nsga2": "NSGA-II", "sobol": "Sobol sequence", "random": "random"}
STEPS = (40, 80, 120, 200, 300, 400)  # drives
SEEDS = 10


def search(_):
    """Hypervolume of what searches by three methods have found after so many drives, as a share of the largest."""
    import numpy as np
    from pymoo.indicators.hv import HV

    from hdconj import study

    found = {}
    for method in METHODS:
        for seed in range(1, SEEDS + 1):
            text = SEARCHED.replace("SEED", str(seed)).replace("METHOD", method.replace("sobol", "random"))
            with tempfile.TemporaryDirectory() as folder:
                call = study.run if method == "sobol" else study.optimise
                call(study.read_recipe(text), folder, progress=False)
                done = study.open(folder)
                values = done.objectives(done.frame)[0]
            found[method, seed] = np.where(done.feasible()[:, None], values, np.inf)
    every = np.concatenate(list(found.values()))
    every = every[np.isfinite(every).all(axis=1)]
    worst, best = np.median(every, axis=0), every.min(axis=0)  # the half of the drives that a designer looks at
    volume = HV(ref_point=np.ones(2))

    def share(values):
        return float(volume(np.minimum((values - best) / (worst - best), 1.0)))

    rows = []
    for method in METHODS:
        for count in STEPS:
            shares = sorted(share(found[method, seed][:count]) for seed in range(1, SEEDS + 1))
            rows.append((method, count, statistics.median(shares), shares[0], shares[-1]))
    whole = share(every)
    rows = [(method, count, *(100 * each / whole for each in shares)) for method, count, *shares in rows]
    write("search", ("method", "drives", "hypervolume [%]", "least [%]", "most [%]"), rows)



def draw(_):
    """docs/figures/study/search.png from the table search."""
    import pandas
    from matplotlib.figure import Figure

    table = pandas.read_csv(ROOT / "data/reference/study-search.csv", comment="#")
    figure = Figure(figsize=(5, 3.2), layout="constrained")
    axes = figure.subplots()
    for (method, part), colour in zip(table.groupby("method", sort=False), ("#d0471f", "#1f5fa8", "#7a8794")):
        axes.plot(part["drives"], part["hypervolume [%]"], "o-", ms=3, color=colour, label=NAMES[method])
        axes.fill_between(part["drives"], part["least [%]"], part["most [%]"], color=colour, alpha=0.15, lw=0)
    axes.set_xlabel("drives computed")
    axes.set_ylabel("hypervolume [%]")
    axes.legend(frameon=False)
    figure.savefig(ROOT / "docs/figures/study/search.png", dpi=140)


# What the paper does not print, and how finely it is computed here.
VARIANTS = {
    "as the study": {},
    "face width 1 mm": {'"circular_spline.width" = 10': '"circular_spline.width" = 1'},
    "cup 20 mm long": {'"flexspline.cup.length" = 40': '"flexspline.cup.length" = 20'},
    "half the harmonics": {'"slices.count" = 1': '"slices.count" = 1\n"load.harmonics" = 50'},
}


def liu(_):
    """Pressure of the flanks of a hundred teeth in the ranges of Liu et al., by what the paper does not print."""
    from hdconj import study

    rows = []
    for name, changes in VARIANTS.items():
        text = (ROOT / "data/studies/liu-2025.toml").read_text()
        for old, new in changes.items():
            assert old in text
            text = text.replace(old, new)
        text = text.replace("../scenes", f"{ROOT}/data/scenes")
        with tempfile.TemporaryDirectory() as folder:
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            study.run(study.read_recipe(text), folder, progress=False)
            seconds = sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2]) - sum(before[:2])
            done = study.open(folder)
            good = done.frame[done.feasible()].head(100)
        for figure in ("pressure", "force"):
            values = good[figure]
            middle = float(values.median())
            rows.append((name, figure, len(good), int((done.frame["code"] != "").sum()), float(values.min()), middle,
                         float(values.max()), float(values.min()) / middle, float(values.max()) / middle,
                         seconds))  # fmt: skip
    write("liu", ("variant", "figure", "drives", "cannot be made", "least", "median", "most", "least of median",
                  "most of median", "processor time [s]"), rows)  # fmt: skip


if __name__ == "__main__":
    tables = {"overhead": overhead, "workers": workers, "shard": shard, "search": search,
              "draw": draw, "liu": liu}  # fmt: skip
    tables[sys.argv[1]](int(sys.argv[2]) if len(sys.argv) > 2 else 5)
