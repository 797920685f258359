"""The examples run, and what is learned is better than what was there before, on robots that were not seen."""

import pathlib
import runpy
import sys

import pytest

EXAMPLES = pathlib.Path(__file__).parents[2] / "python" / "examples"


def test_learning_helps():
    learn = runpy.run_path(str(EXAMPLES / "learn_command.py"))["learn"]
    before, after = learn(iterations=4, directions=3, cycles=40)
    assert after > before + 0.05


@pytest.mark.parametrize("with_plots", [True, False])
def test_push_recovery(tmp_path, monkeypatch, with_plots):
    monkeypatch.setattr(sys, "argv", ["push_recovery.py", str(tmp_path)])
    if not with_plots:
        monkeypatch.setitem(sys.modules, "matplotlib", None)
    told = runpy.run_path(str(EXAMPLES / "push_recovery.py"))
    assert not told["robot"].fallen
    assert told["data"][-1, 6] != pytest.approx(told["unpushed_m"][1], abs=1e-6)
    assert [file.suffix for file in tmp_path.iterdir()] in ([".png"], [".csv"])


def test_readme_runs():
    text = (EXAMPLES.parent / "README.md").read_text()
    snippets = [part.split("```")[0] for part in text.split("```python\n")[1:]]
    assert len(snippets) >= 2
    for snippet in snippets:
        exec(compile(snippet, "README.md", "exec"), {})
