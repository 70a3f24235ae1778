"""The repository, and the program that the package is compared with."""

import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def fixtures():
    return ROOT / "fixtures"


@pytest.fixture(scope="session")
def program():
    """Runs the program `assur` in the folder of the scenes, and returns what it prints."""
    built = os.environ.get("ASSUR", ROOT / "target" / "debug" / "assur")

    def run(*arguments):
        called = [str(built), *map(str, arguments)]
        return subprocess.run(called, cwd=ROOT / "fixtures", check=True, capture_output=True, text=True).stdout

    return run
