"""Yarn of crochet and of knitting as USD curves: widths, places along the yarn, plies, twist, and which stitch a point is of."""

from __future__ import annotations

import numpy as np
import pytest

from tambour import run
from tambour.crochet.params import CrochetParams
from tambour.knit.params import KnitParams


def opened(path):
    pytest.importorskip("pxr")
    from pxr import Usd, UsdGeom

    stage = Usd.Stage.Open(str(path))
    prim = stage.GetPrimAtPath(f"{stage.GetDefaultPrim().GetPath()}/yarn")
    curves, told = UsdGeom.BasisCurves(prim), UsdGeom.PrimvarsAPI(prim)
    counts = np.array(curves.GetCurveVertexCountsAttr().Get())
    points = np.array(curves.GetPointsAttr().Get())
    held = {k: np.array(told.GetPrimvar(k).Get()) for k in ("st", "twist", "stitch", "ply")}
    assert counts.sum() == len(points) == len(held["st"]) == len(held["twist"]) == len(held["stitch"])
    assert len(held["ply"]) == len(counts) and (held["ply"] == 4).all()
    ends = np.cumsum(counts)
    for a, b in zip(np.r_[0, ends[:-1]], ends):
        assert (np.diff(held["st"][a:b, 0]) >= 0).all() and held["st"][a, 0] == 0
    assert np.allclose(held["twist"], 360 * held["st"][:, 0], rtol=1e-4)
    return stage, points, counts, held, told, np.array(curves.GetWidthsAttr().Get())


def test_crochet_yarn_is_curves_with_its_stitches(tmp_path):
    (tmp_path / "ball.acl").write_text(": MR(6)\n: 6 inc\n: (sc, inc)*6\n")
    run.run("crochet", tmp_path / "ball.acl", CrochetParams(), [tmp_path / "a.curves.usdc"])
    stage, points, _, held, told, widths = opened(tmp_path / "a.curves.usdc")
    assert stage.GetDefaultPrim().GetName() == "crochet"
    rounds = np.array(told.GetPrimvar("round").Get())
    assert set(np.unique(held["stitch"])) == set(range(1, 6 + 12 + 18 + 1)) and rounds.max() == 2  # 0 is the ring
    assert 10 < np.ptp(points, axis=0).max() < 80 and 0.5 < widths[0] < 6


def test_knitted_loops_hang_in_their_rows(tmp_path):
    (tmp_path / "c.csv").write_text("0,0,1\n1,0,0\n")
    run.run("knit", tmp_path / "c.csv", KnitParams(gauge="20x20"), [tmp_path / "a.curves.usdc"])
    stage, points, counts, held, told, widths = opened(tmp_path / "a.curves.usdc")
    assert stage.GetDefaultPrim().GetName() == "knit" and sorted(counts) == [25, 25, 49, 49]
    row = np.array(told.GetPrimvar("row").Get())
    for r in (0, 1):
        assert abs(points[row == r, 1].mean() - (r + 0.5) * 5) < 1.0
    assert set(held["stitch"]) == set(range(6)) and np.ptp(points[:, 0]) > 14
    assert 1 < widths[0] < 4
