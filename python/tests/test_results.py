"""Positions, reactions and motions: against another program's results, and against the files of `assur analyze`."""

import csv
import gc
import json
import signal

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

import assur


def columns_of_file(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return {name: [cell[at] for cell in rows[1:]] for at, name in enumerate(rows[0])}


def same(found, cells):
    """Whether an array has the numbers of the cells of a file, each to the bit, and NaN where they are empty."""
    expected = np.array([float(cell) if cell else np.nan for cell in cells])
    return np.array_equal(found, expected, equal_nan=True)


def is_checked(name):
    """Whether a column is of the checks, which `assur analyze` does besides."""
    return name.startswith("residual_")


@pytest.fixture(scope="module")
def shaper(fixtures):
    return assur.load(fixtures / "shaper.toml")


def test_positions_and_reactions_are_those_of_another_program(shaper, fixtures):
    reference = json.loads((fixtures / "shaper.json").read_text())["positions"]
    results = shaper.analyze()
    assert len(results.positions) == len(reference)
    pins = [pair for pair in reference[0]["reactions"] if "/" not in pair]
    assert pins
    for row, at in enumerate(reference):
        for name, point in at["points"].items():
            place = shaper.at(at["coordinate"]).transfer(name)
            assert np.allclose(place, [point["pf0"], point["pf1"], point["pf2"]], rtol=0, atol=1e-9), name
        for pair in pins:
            found = results.reaction(pair)
            assert np.allclose([found.x[row], found.y[row]], at["reactions"][pair][found.on], rtol=0, atol=1e-5)


def test_columns_are_those_of_the_csv(shaper, program, tmp_path):
    program("analyze", "shaper.toml", "--format", "csv", "-o", tmp_path)
    table = shaper.analyze().positions
    written = {**columns_of_file(tmp_path / "positions.csv"), **columns_of_file(tmp_path / "reactions.csv")}
    written = {name: cells for name, cells in written.items() if not is_checked(name)}
    assert set(table.names) == set(written)
    assert all(same(table[name], cells) for name, cells in written.items())


def test_a_motion_over_time_has_the_columns_of_its_csv(fixtures, program, tmp_path):
    program("analyze", "run-up.toml", "--format", "csv", "-o", tmp_path)
    motion = assur.load(fixtures / "run-up.toml").analyze().motion
    written = columns_of_file(tmp_path / "trajectory.csv")
    written = {name: cells for name, cells in written.items() if not is_checked(name)}
    assert motion.names == list(written)
    assert all(same(motion[name], cells) for name, cells in written.items())


@pytest.mark.parametrize("scene", ["shaper", "shaper-friction", "stephenson3", "andrews"])
def test_arrow_has_what_parquet_has(fixtures, program, tmp_path, scene):
    program("analyze", f"{scene}.toml", "-o", tmp_path / "x.parquet")
    table = pa.table(assur.load(fixtures / f"{scene}.toml").analyze().positions)
    written = pq.read_table(tmp_path / "x.parquet")
    written = written.select([name for name in written.column_names if not is_checked(name)])
    assert table.column_names == written.column_names
    for name in table.column_names:
        assert table[name].type == written[name].type, name
        assert table[name].equals(written[name]), name


def test_no_number_is_copied(shaper):
    table = shaper.analyze(positions=360).positions
    first, second = table["D_x_m"], table["D_x_m"]
    assert first is not second and np.shares_memory(first, second)
    assert not first.flags.owndata and not first.flags.writeable
    arrow = pa.table(table)["D_x_m"].chunk(0)
    assert arrow.buffers()[1].address == first.__array_interface__["data"][0]
    force = shaper.analyze().reaction("O")
    with pytest.raises(ValueError):
        force.x[0] = 0.0
    kept = first.copy()
    del table, second, arrow
    gc.collect()
    assert np.array_equal(first, kept), "an array keeps its numbers"


def test_many_positions(shaper):
    results = shaper.analyze(positions=40_000)
    index = results["index"]
    assert np.array_equal(index, np.arange(40_000)) and index.dtype.kind == "i"
    last = shaper.replace("input.positions", 40_000)
    assert last.at(last.coordinates[-1]).point("D") == (results["D_x_m"][-1], results["D_y_m"][-1])


def test_a_table_is_a_mapping(shaper):
    table = shaper.analyze().positions
    assert "D_x_m" in table and "D_x" not in table and list(table) == table.names == list(dict(table))
    with pytest.raises(KeyError, match="did you mean `D_x_m`"):
        table["D_xm"]
    with pytest.raises(KeyError, match="there is no pair"):
        shaper.analyze().reaction("Q")
    with pytest.raises(KeyError, match="did you mean"):
        shaper.at(0.0).point("d")


def test_an_error_has_its_place(fixtures):
    text = (fixtures / "four-bar.toml").read_text().replace('mass = "1.4 kg"', 'mass = "4 mm"', 1)
    with pytest.raises(assur.Error, match="mm") as raised:
        assur.loads(text, "a.toml")
    line = 1 + text.splitlines().index('mass = "4 mm"')
    error = raised.value
    assert (error.file, error.line, error.key) == ("a.toml", line, "link.crank.mass") and error.column > 0
    with pytest.raises(assur.Error) as raised:
        assur.load(fixtures / "none.toml")
    assert raised.value.file.endswith("none.toml") and raised.value.line is None
    with pytest.raises(assur.Error) as raised:
        assur.load(fixtures / "four-bar.toml").replace("link.crank.mas", "1 kg")
    assert "did you mean `mass`" in str(raised.value) and raised.value.line


def test_a_signal_ends_a_long_calculation(shaper):
    class Enough(Exception):
        pass

    def enough(*_):
        raise Enough

    before = signal.signal(signal.SIGALRM, enough)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    try:
        with pytest.raises(Enough):
            shaper.analyze(positions=1_000_000)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
