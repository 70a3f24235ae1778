"""Each sweep of docs/sweep.md gives the rows of the command."""

import argparse
import csv
import io
import re
import shlex

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

import assur
from conftest import ROOT

# Points for the sweep of the page that takes them from a file.
POINTS = ["link.crank.points.A", "link.coupler.mass"]
POINT_ROWS = [["0.075", "2 kg"], ["80 mm", "3"], ["0.09", "2500 g"]]

# Samples of the page are for machines of many cores.
MOST_SAMPLED = 320


def sweeps():
    """The sweeps of the page: a scene and options, without those that say where and how rows are written."""
    page = (ROOT / "docs" / "sweep.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```sh\n(.*?)```", page, re.S)
    lines = "\n".join(blocks).replace("\\\n", " ").splitlines()
    calls = [line[line.index("assur sweep") :] for line in lines if "assur sweep" in line]
    return [[word.strip("'") for word in shlex.split(call, comments=True)[2:]] for call in calls]


def options(words):
    parser = argparse.ArgumentParser(exit_on_error=False)
    parser.add_argument("scene")
    for name in ["vary", "tie", "target", "where"]:
        parser.add_argument(f"--{name}", action="append")
    parser.add_argument("--points")
    parser.add_argument("--measure")
    parser.add_argument("--between", action="store_true")
    for name in ["sample", "seed"]:
        parser.add_argument(f"--{name}", type=int)
    for name in ["shard", "threads", "best", "best-scene"]:
        parser.add_argument(f"--{name}")
    parser.add_argument("-o", dest="output")
    parser.add_argument("--resume", action="store_true")
    return parser.parse_args(words)


def rows_of(text):
    rows = list(csv.reader(io.StringIO(text)))
    return rows[0], rows[1:]


@pytest.mark.parametrize("words", sweeps(), ids=" ".join)
def test_a_sweep_of_the_page(words, fixtures, program, tmp_path):
    given = options(words)
    wanted = {name: getattr(given, name) for name in ["vary", "tie", "target", "where", "measure", "seed"]}
    wanted = {name: value for name, value in wanted.items() if value is not None}
    if given.sample:
        wanted["sample"] = min(given.sample, MOST_SAMPLED)
    # The part of a whole that the first of 32 machines has; the header is there.
    if given.shard:
        wanted["shard"] = (1, 32)

    called = ["sweep", given.scene]
    points = None
    if given.points:
        points = dict(zip(POINTS, zip(*POINT_ROWS)))
        written = tmp_path / given.points
        written.write_text("\n".join(",".join(row) for row in [POINTS, *POINT_ROWS]) + "\n", encoding="utf-8")
        called += ["--points", written]
    for name, value in wanted.items():
        for one in value if isinstance(value, list) else [value]:
            called += [f"--{name}", "1/32" if name == "shard" else str(one)]
    called += ["--between"] if given.between else []
    names, rows = rows_of(program(*called))
    assert rows

    table = assur.load(fixtures / given.scene).sweep(**wanted, points=points, between=given.between)
    assert table.names == names and len(table) == len(rows)
    for at, name in enumerate(names):
        cells, column = [row[at] for row in rows], table[name]
        if column.dtype.kind == "U":
            assert list(column) == cells, name
        else:
            expected = np.array([float(cell) if cell else np.nan for cell in cells])
            assert np.array_equal(column, expected, equal_nan=True), name


def test_the_page_has_sweeps():
    assert len(sweeps()) >= 6


def test_each_argument_is_that_of_the_command(fixtures, program, tmp_path):
    scene = assur.load(fixtures / "four-bar.toml")
    ranges = {"link.crank.points.A": "70 mm..95 mm", "link.coupler.mass": "2 kg..3 kg"}
    table = scene.sweep(
        ranges,
        tie={"link.rocker.mass": "link.coupler.mass*0.5"},
        target="B=300 mm,100 mm",
        measure="distance, transmission",
        sample=20,
        seed=7,
        between=True,
        threads=1,
    )
    vary = [word for key, range in ranges.items() for word in ["--vary", f"{key}={range}"]]
    more = ["--target", "B=300 mm,100 mm", "--measure", "distance,transmission", "--sample", 20, "--seed", 7, "--between"]
    tie = ["--tie", "link.rocker.mass=link.coupler.mass*0.5"]
    program("sweep", "four-bar.toml", *vary, *tie, *more, "-o", tmp_path / "s.parquet")
    written = pq.read_table(tmp_path / "s.parquet")
    found = pa.table(table)
    assert found.column_names == written.column_names
    for name in found.column_names:
        assert found[name].to_pylist() == written[name].to_pylist(), name


def test_shards_are_the_whole(fixtures):
    scene = assur.load(fixtures / "four-bar.toml")
    vary = "link.crank.points.A=70 mm..95 mm:11"
    parts = [scene.sweep(vary, measure=["transmission"], shard=(part, 3)) for part in (1, 2, 3)]
    name = "least_transmission_angle_rad"
    whole = scene.sweep([vary], measure="transmission")
    assert np.array_equal(np.concatenate([part[name] for part in parts]), whole[name])
    with pytest.raises(ValueError, match="shard"):
        scene.sweep(vary, shard=(4, 3))


def test_points_that_fail_are_rows_but_not_if_all_do(fixtures):
    scene = assur.load(fixtures / "four-bar.toml")
    table = scene.sweep("link.crank.points.A=90 mm,900 mm", measure="transmission")
    assert list(table["status"]) == ["ok", "no assembly"] and table["message"][1]
    assert np.isnan(table["least_transmission_angle_rad"][1])
    assert pa.table(table)["least_transmission_angle_rad"].null_count == 1
    with pytest.raises(assur.Error):
        scene.sweep("link.crank.mass=-2 kg..-1 kg:3")
    with pytest.raises(assur.Error, match="mas"):
        scene.sweep("link.crank.mas=1 kg..2 kg:3")
    with pytest.raises(TypeError):
        scene.sweep(3)
