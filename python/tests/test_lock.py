"""The package is built of the versions of the workspace, so that it calculates what the program does."""

import re

from conftest import ROOT


def versions(lock):
    text = lock.read_text(encoding="utf-8")
    found = {}
    for name, version in re.findall(r'^name = "(.*)"\nversion = "(.*)"$', text, re.M):
        found.setdefault(name, set()).add(version)
    return found


def test_versions_are_those_of_the_workspace():
    whole, own = versions(ROOT / "Cargo.lock"), versions(ROOT / "python" / "Cargo.lock")
    other = {name: found for name, found in own.items() if name in whole and not found <= whole[name]}
    told = "cp Cargo.lock python/Cargo.lock && cargo metadata --format-version 1 --manifest-path python/Cargo.toml"
    assert not other, f"take the versions of the workspace: {told}"
