"""docs/python.md as a script: each block prints what stands below it."""

import contextlib
import io
import os
import re
import shutil

from conftest import ROOT

BLOCK = re.compile(r"```python\n(.*?)```(?:\n\n```text\n(.*?)```)?", re.S)


def test_the_lesson_prints_what_it_says(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copy(ROOT / "fixtures" / "shaper.toml", tmp_path)
    page = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    names, blocks = {}, BLOCK.findall(page)
    assert len(blocks) >= 5
    for code, expected in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, "docs/python.md", "exec"), names)
        assert printed.getvalue() == expected, code
    assert os.listdir(tmp_path)
