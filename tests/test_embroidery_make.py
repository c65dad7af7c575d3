"""The craft's promises on a whole drawing."""

from __future__ import annotations

import json

import numpy as np
from click.testing import CliRunner

from tambour.cli import tambour
from tambour.core.thread import END, JUMP, STITCH

SQUARES = """<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="30mm" viewBox="0 0 60 30">
<g data-tambour-angle="45"><path id="left" fill="#a22" d="M2 2h20v20h-20z"/></g>
<path id="right" fill="navy" fill-rule="evenodd" d="M30 2h25v25h-25z M38,8h8v8h-8z"/></svg>"""


def report(tmp_path, svg, *options):
    (tmp_path / "in.svg").write_text(svg)
    out, rep = tmp_path / "out.json", tmp_path / "report.json"
    result = CliRunner().invoke(
        tambour, ["embroidery", str(tmp_path / "in.svg"), "-o", str(out), "--report", str(rep), *options]
    )
    assert result.exit_code == 0, result.output
    return json.loads(rep.read_text()), json.loads(out.read_text())


def test_two_fills_have_one_jump_and_lie_inside(tmp_path):
    facts, plan = report(tmp_path, SQUARES, "--underlay", "none")
    assert facts["jumps"] == 1 and facts["trims"] == 2 and facts["outside"] == 0
    assert facts["density"]["rows_cv"] < 0.015
    assert facts["longest_mm"] <= 3 + 1e-9
    command = np.array(plan["command"])
    assert command[-1] == END and (command[:-1] != END).all()
    xy = np.c_[plan["x_mm"], plan["y_mm"]]
    assert abs(xy[command == STITCH].mean(0)).max() < 5 and (command == JUMP).sum() >= 1


def test_a_region_overrides_the_angle(tmp_path):
    _, plan = report(tmp_path, SQUARES, "--underlay", "none", "--no-locks")
    xy = np.c_[plan["x_mm"], plan["y_mm"]]
    region, kind = np.array(plan["region"]), np.array(plan["kind"])
    for k, slope in ((plan["regions"].index("left"), -1.0), (plan["regions"].index("right"), 0.0)):
        end = np.flatnonzero((region == k) & (kind == 0))
        d = xy[end] - xy[end - 1]
        long = np.hypot(*d.T) > 1
        assert np.allclose(d[long, 1] / d[long, 0], slope, atol=1e-3)
