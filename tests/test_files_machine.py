"""Machine files: what is written is read back, what is damaged is said."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tambour import files
from tambour.core.errors import TambourError
from tambour.core.thread import COLOR, END, JUMP, STITCH, STOP, TRIM, Thread, ThreadPlan
from tambour.files.dst import LIMIT, decode, encode, trims_from_jumps
from tambour.files.records import Records, needle_points, records, split

NINE = ("dst", "pes", "pec", "exp", "jef", "vp3", "xxx", "u01", "tbf")
ALL = (*NINE, "sew")
THREADS = (Thread((200, 30, 40), "Red", "House", "12"), Thread((20, 30, 140), "Blue"), Thread((240, 230, 220), "Cream"))


def design(seed: int = 0, n: int = 600, trims: int = 4, stop: bool = True) -> ThreadPlan:
    """A random walk in three colours with trims, jumps, a stop, and steps far above every format's limit."""
    rng = np.random.default_rng(seed)
    xy = np.cumsum(rng.uniform(-3, 3, (n, 2)), axis=0)
    xy *= 60 / np.ptp(xy, axis=0).max()
    xy[n // 2 :] += [100.0, 0.0]  # a step of 100 mm
    xy[n // 4 :] += [-12.8, 0.0]
    xy[n // 4 + 1 :] += [13.0, 13.0]
    command, thread = np.zeros(n, np.uint8), np.zeros(n, np.int16)
    thread[n // 3 :], thread[2 * n // 3 :] = 1, 2
    command[[n // 3, 2 * n // 3]] = COLOR
    for k in (np.linspace(0.1, 0.9, trims) * n).astype(int) + 7:
        command[k : k + 2] = TRIM, JUMP
    if stop:
        command[n // 5] = STOP
    for k in np.flatnonzero(command >= TRIM):
        xy[k] = xy[k - 1]
    command[-1], xy[-1] = END, xy[-2]
    low, high = xy.min(axis=0), xy.max(axis=0)
    return ThreadPlan(xy - (low + high) / 2, command, thread, THREADS, None, {"title": "test piece"})


def seen(plan: ThreadPlan) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return needle_points(np.rint(plan.xy * 10).astype(int), plan.command)


@pytest.mark.parametrize("suffix", ALL)
@pytest.mark.parametrize("seed", range(3))
def test_what_is_written_is_read_back(tmp_path, suffix, seed):
    plan = design(seed)
    path = tmp_path / f"a.{suffix}"
    files.write(plan, path)
    back = files.read(path, ("ThreadPlan",))
    (p, c, t), (q, d, u) = seen(plan), seen(back)
    if suffix in ("pes", "pec"):  # they hold no origin: the machine centres the design
        q = q - q[0] + p[0]
    assert np.array_equal(p, q)
    assert np.array_equal(c, d)
    assert suffix in ("jef", "sew") or not (t & ~u).any()
    assert all("mm long" in doubt for doubt in back.about.get("doubts", "").splitlines())  # the step of 100 mm


@pytest.mark.parametrize("suffix", ALL)
def test_same_design_same_bytes(tmp_path, suffix):
    for name in ("a", "b"):
        files.write(design(), tmp_path / f"{name}.{suffix}")
    assert (tmp_path / f"a.{suffix}").read_bytes() == (tmp_path / f"b.{suffix}").read_bytes()


@pytest.mark.parametrize("suffix", ["vp3", "xxx", "tbf"])
def test_colors_survive(tmp_path, suffix):
    plan = design(stop=False)
    files.write(plan, tmp_path / f"a.{suffix}")
    back = files.read(tmp_path / f"a.{suffix}", ("ThreadPlan",))
    assert [t.rgb for t in back.threads] == [t.rgb for t in THREADS]


def test_pes_six_carries_threads_and_pes_one_three_of_the_screen(tmp_path):
    plan = design(stop=False)
    six = ThreadPlan(plan.xy, plan.command, plan.thread, plan.threads, None, {"pes": "6"})
    files.write(six, tmp_path / "six.pes")
    files.write(plan, tmp_path / "one.pes")
    back = files.read(tmp_path / "six.pes", ("ThreadPlan",)).threads
    assert [(t.rgb, t.name) for t in back] == [(t.rgb, t.name) for t in THREADS]
    assert (tmp_path / "one.pes").read_bytes()[:8] == b"#PES0001"
    assert len({t.rgb for t in files.read(tmp_path / "one.pes", ("ThreadPlan",)).threads}) == 3


@pytest.mark.parametrize(("suffix", "version"), [("pes", "1"), ("pes", "6"), ("pec", "1")])
def test_a_second_reader_agrees(tmp_path, suffix, version):
    pyembroidery = pytest.importorskip("pyembroidery")
    plan = design(stop=False)
    plan = ThreadPlan(plan.xy, plan.command, plan.thread, plan.threads, None, {"pes": version})
    path = tmp_path / f"a.{suffix}"
    files.write(plan, path)
    theirs = pyembroidery.read(str(path)).stitches
    sewn = np.array([s[:2] for s in theirs if s[2] & 0xFF == pyembroidery.STITCH])
    wanted = seen(plan)[0]
    assert np.array_equal(sewn - sewn[0], wanted - wanted[0])
    assert sum(s[2] & 0xFF == pyembroidery.COLOR_CHANGE for s in theirs) == 2


def test_dst_is_read_alike_by_pystitch(tmp_path):
    import pystitch

    plan = design(3)
    files.write(plan, tmp_path / "a.dst")
    theirs = pystitch.read(str(tmp_path / "a.dst")).stitches
    sewn = np.array([s[:2] for s in theirs if s[2] & 0xFF == pystitch.STITCH])
    assert np.array_equal(sewn, seen(plan)[0])


def test_dst_steps_all_come_back():
    d = np.arange(-LIMIT, LIMIT + 1)
    steps = np.stack([np.r_[d, d[::-1]], np.r_[d[::-1], np.roll(d, 7)]], axis=1)
    xy = np.cumsum(steps, axis=0)
    made = Records(xy, np.full(len(xy), STITCH, np.uint8), np.zeros(len(xy), np.int16))
    assert np.array_equal(decode(encode(made))[0], xy)


def test_trims_are_three_jumps_in_dst(tmp_path):
    plan = design(trims=7, stop=False)
    files.write(plan, tmp_path / "a.dst")
    xy, command, _, _ = decode((tmp_path / "a.dst").read_bytes()[512:])
    assert (trims_from_jumps(xy, command)[1] == TRIM).sum() >= 7
    assert (files.read(tmp_path / "a.dst", ("ThreadPlan",)).command == TRIM).sum() >= 7


def test_jef_trims_only_when_asked(tmp_path):
    plan = design(stop=False)
    files.write(plan, tmp_path / "a.jef")
    asked = ThreadPlan(plan.xy, plan.command, plan.thread, plan.threads, None, {"jef-trims": "yes"})
    files.write(asked, tmp_path / "b.jef")
    plain, trimmed = ((tmp_path / f"{n}.jef").read_bytes() for n in "ab")
    assert trimmed.count(b"\x80\x02\x00\x00") >= 12 > plain.count(b"\x80\x02\x00\x00")


@pytest.mark.parametrize(("size", "code"), [(40, 1), (50, 1), (105, 0), (112, 2), (160, 4)])
def test_jef_names_the_hoop(tmp_path, size, code):
    half = size / 2
    xy = np.array([[-half, -half], [half, half], [0, 0], [0, 0]], float)
    plan = ThreadPlan(xy, np.array([STITCH, STITCH, STITCH, END], np.uint8), np.zeros(4, np.int16), THREADS[:1])
    files.write(plan, tmp_path / "a.jef")
    assert (tmp_path / "a.jef").read_bytes()[32] == code


def test_what_a_format_cannot_hold_is_refused(tmp_path):
    xy = np.array([[-150, 0], [150, 0], [150, 0]], float)
    wide = ThreadPlan(xy, np.array([STITCH, STITCH, END], np.uint8), np.zeros(3, np.int16), THREADS[:1])
    with pytest.raises(TambourError, match="hoop"):
        files.write(wide, tmp_path / "a.jef")
    n = 40
    many = ThreadPlan(
        np.stack([np.arange(n), np.zeros(n)], axis=1) * 0.5,
        np.r_[np.tile([STITCH, COLOR], n // 2 - 1), STITCH, END].astype(np.uint8),
        np.r_[np.arange(n - 2) // 2 + np.arange(n - 2) % 2, n // 2 - 1, n // 2 - 1].astype(np.int16),
        tuple(Thread((5 * k, 250 - 5 * k, 90)) for k in range(n // 2)),
    )
    for suffix in ("sew", "u01"):
        with pytest.raises(TambourError, match="colours"):
            files.write(many, tmp_path / f"a.{suffix}")
    files.write(many, tmp_path / "a.pes")
    bare = ThreadPlan(xy[:1], np.array([END], np.uint8), np.zeros(1, np.int16), THREADS[:1])
    with pytest.raises(TambourError, match="no stitch"):
        files.write(bare, tmp_path / "b.dst")


def test_splitting_keeps_points_and_limits():
    rng = np.random.default_rng(2)
    xy = rng.integers(-900, 900, (300, 2))
    made = Records(xy, np.full(300, STITCH, np.uint8), np.zeros(300, np.int16))
    for limit in (121, 123, 127, 255):
        r = split(made, limit)
        assert np.abs(np.diff(r.xy, axis=0, prepend=np.zeros((1, 2), int))).max() <= limit
        assert np.array_equal(r.xy[r.command == STITCH], xy)


def test_records_put_commands_before_the_jump():
    xy = np.array([[0, 0], [1, 0], [5, 5], [5, 5], [6, 5], [7, 5], [7, 5]], float)
    command = np.array([STITCH, STITCH, JUMP, TRIM, JUMP, STITCH, END], np.uint8)
    r = records(ThreadPlan(xy, command, np.zeros(7, np.int16), THREADS[:1]))
    assert r.command.tolist() == [JUMP, STITCH, STITCH, TRIM, JUMP, STITCH, END]
    assert r.xy.tolist() == [[0, 0], [0, 0], [10, 0], [10, 0], [70, 50], [70, 50], [70, 50]]


def damaged(raw: bytes, rng: np.random.Generator, how: int) -> bytes:
    data = bytearray(raw)
    if how == 0:  # cut off
        return bytes(data[: rng.integers(0, len(data))])
    if how == 1:  # some bytes changed
        for _ in range(rng.integers(1, 12)):
            data[rng.integers(0, len(data))] = rng.integers(0, 256)
    elif how == 2:  # a stretch of noise
        at = rng.integers(0, len(data))
        data[at : at + 40] = rng.integers(0, 256, 40, np.uint8).tobytes()
    elif how == 3:  # a stretch lost
        at = rng.integers(0, len(data))
        del data[at : at + rng.integers(1, 60)]
    else:  # the header spoilt
        for _ in range(rng.integers(1, 8)):
            data[rng.integers(0, min(80, len(data)))] = rng.integers(0, 256)
    return bytes(data)


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ALL)
def test_damage_gives_a_design_or_one_line(tmp_path, suffix):
    """200 mutations of each format: never a raw exception, and a file cut short never passes for whole."""
    path, bad = tmp_path / f"a.{suffix}", tmp_path / f"b.{suffix}"
    plan = design(n=160)
    files.write(plan, path)
    raw, rng = path.read_bytes(), np.random.default_rng(7)
    full = len(seen(plan)[0])
    size = np.ptp(files.read(path, ("ThreadPlan",)).xy, axis=0)
    designs = 0
    for k in range(200):
        hurt = damaged(raw, rng, k % 5)
        bad.write_bytes(hurt)
        try:
            made = files.read(bad, ("ThreadPlan",))
        except TambourError as error:
            assert len(error.problems) == 1
            assert "\n" not in error.problems[0].message
            continue
        designs += 1
        if k % 5 == 0 and suffix != "exp":  # nothing in an EXP file says how long it should be
            assert "doubts" in made.about or len(seen(made)[0]) == full
        if suffix not in ("exp", "sew"):  # what tells its extents does not grow or shrink without a word
            assert "doubts" in made.about or np.abs(np.ptp(made.xy, axis=0) - size).max() <= 0.41
    assert designs > 20


@pytest.mark.parametrize("suffix", sorted(s[1:] for s, kinds in files.READ.items() if "ThreadPlan" in kinds))
def test_what_is_no_machine_file_is_one_line(tmp_path, suffix):
    path = tmp_path / f"a.{suffix}"
    for raw in (b"", b"x", b"<svg xmlns='http://www.w3.org/2000/svg'/>", bytes(2000), b"\xff" * 700):
        path.write_bytes(raw)
        try:
            files.read(path, ("ThreadPlan",))
        except TambourError as error:
            assert "\n" not in error.problems[0].message


def test_header_and_stitches_that_disagree_are_said(tmp_path):
    path = tmp_path / "a.dst"
    files.write(design(), path)
    raw = path.read_bytes()
    path.write_bytes(raw.replace(b"ST:    ", b"ST:9999"))
    assert "declares" in files.read(path, ("ThreadPlan",)).about["doubts"]
    path.write_bytes(raw[: 512 + 300])
    assert "end mark" in files.read(path, ("ThreadPlan",)).about["doubts"]


@pytest.mark.parametrize(("suffix", "head"), [("dst", 512), ("u01", 0x100), ("xxx", 0x100)])
def test_what_lies_a_little_aside_within_the_design_is_told_by_its_end(tmp_path, suffix, head):
    """One byte of a stitch changed: all that follows lies half a millimetre off, and neither count nor size changes."""
    path, plan = tmp_path / f"a.{suffix}", rows()
    frame = np.array([[-16.5, -9.0], [-16.5, -6.0], [16.5, 9.0], [16.5, 6.0]])

    def made(aside: float) -> bytes:
        xy = np.vstack([frame, plan.xy])
        xy[200:, 1] += aside
        still = ThreadPlan(xy, np.r_[np.zeros(4, np.uint8), plan.command], np.zeros(len(xy), np.int16), plan.threads)
        files.write(still, path)
        return path.read_bytes()

    whole, moved = made(0.0), made(0.5)
    path.write_bytes(whole)
    assert "doubts" not in files.read(path, ("ThreadPlan",)).about
    path.write_bytes(whole[:head] + moved[head:])
    assert re.search(r"\bends?\b", files.read(path, ("ThreadPlan",)).about["doubts"])


@pytest.mark.parametrize("suffix", ["dst", "tbf"])
def test_a_header_whose_numbers_are_none_is_read_past(tmp_path, suffix):
    path = tmp_path / f"a.{suffix}"
    files.write(rows(), path)
    raw = path.read_bytes()
    at = raw.index(b"AX:") + 3
    for odd in (b"--  1", b"+-  1", b"-+12 ", b"-    "):
        path.write_bytes(raw[:at] + odd + raw[at + 5 :])
        assert len(files.read(path, ("ThreadPlan",)))


@pytest.mark.parametrize("suffix", ["pes", "vp3", "tbf"])
def test_a_changed_byte_of_a_stitch_within_the_design_is_told(tmp_path, suffix):
    """Half a millimetre aside, in the last third: no count and no size changes, but where a colour, or all, should end does."""
    path, plan = tmp_path / f"a.{suffix}", rows()

    def made(aside: float) -> bytes:
        xy = plan.xy.copy()
        xy[150:-1, 0] = np.clip(xy[150:-1, 0], -9, 9)
        xy[200:, 0] += aside
        files.write(ThreadPlan(xy, plan.command, plan.thread, plan.threads), path)
        return path.read_bytes()

    whole, moved = made(0.0), made(0.5)
    differ = [k for k in range(len(whole)) if whole[k] != moved[k]]
    assert len(whole) == len(moved) and "doubts" not in files.read(path, ("ThreadPlan",)).about
    start = int.from_bytes(whole[8:12], "little") + 532 if suffix == "pes" else len(whole) - 3 * len(plan)
    sewn = [k for k in differ if k >= start and (suffix != "vp3" or k > 226)]
    spoilt = bytearray(whole)
    spoilt[sewn[0]] = moved[sewn[0]]
    path.write_bytes(spoilt)
    assert re.search("twice|should|elsewhere", files.read(path, ("ThreadPlan",)).about["doubts"])


def test_a_vp3_thread_whose_names_were_spoilt_is_told(tmp_path):
    path = tmp_path / "a.vp3"
    files.write(rows(), path)
    raw = path.read_bytes()
    mark = raw.index(b"\x0a\xf6\0")
    path.write_bytes(raw[:mark] + b"\x0b" + raw[mark + 1 :])
    assert "their mark is not there" in files.read(path, ("ThreadPlan",)).about["doubts"]


@pytest.mark.parametrize("suffix", ["jef", "xxx", "u01"])
def test_five_records_more_than_the_header_declares_are_told(tmp_path, suffix):
    path = tmp_path / f"a.{suffix}"

    def made(more: int) -> bytes:
        plan = rows()
        twice = np.r_[np.arange(200), np.full(more, 199), np.arange(200, len(plan))]  # stitches on the spot
        files.write(ThreadPlan(plan.xy[twice], plan.command[twice], plan.thread[twice], plan.threads), path)
        return path.read_bytes()

    whole = made(0)
    head = int.from_bytes(whole[:4], "little") if suffix == "jef" else 0x100
    path.write_bytes(whole[:head] + made(5)[head:])
    assert "the header declares" in files.read(path, ("ThreadPlan",)).about["doubts"]


def test_a_header_that_was_never_filled_in_is_no_doubt(tmp_path):
    for suffix, at, blank in (("u01", 0x8C, b"0000"), ("pec", 8 + 512 + 8, b"\0\0\0\0")):
        path = tmp_path / f"a.{suffix}"
        files.write(design(), path)
        raw = bytearray(path.read_bytes())
        for wrong in (True, False):
            raw[at : at + 4] = b"\x01\x02\x01\x02" if wrong else blank
            path.write_bytes(raw)
            assert ("declares" in files.read(path, ("ThreadPlan",)).about.get("doubts", "")) == wrong, suffix


def rows(n: int = 400) -> ThreadPlan:
    """A field of stitches 3 mm long, as designs have them."""
    k = np.arange(n)
    xy = np.stack([3.0 * np.abs((k % 20) - 10), 0.4 * (k // 10)], axis=1)
    command = np.zeros(n, np.uint8)
    command[-1], xy[-1] = END, xy[-2]
    return ThreadPlan(xy - xy.mean(axis=0), command, np.zeros(n, np.int16), THREADS[:1])


@pytest.mark.parametrize("suffix", ALL)
def test_a_stitch_out_of_all_proportion_is_told(tmp_path, suffix):
    path, plan = tmp_path / f"a.{suffix}", rows()
    files.write(plan, path)
    assert "doubts" not in files.read(path, ("ThreadPlan",)).about
    moved = plan.xy.copy()
    moved[200:, 1] += 11.0  # what one changed byte does: all that follows lies elsewhere
    files.write(ThreadPlan(moved, plan.command, plan.thread, plan.threads), path)
    assert "one stitch is up to 1" in files.read(path, ("ThreadPlan",)).about["doubts"]


def test_bytes_lost_from_the_head_of_a_sew_file_are_told(tmp_path):
    path = tmp_path / "a.sew"
    files.write(rows(), path)
    raw = path.read_bytes()
    for lost in (1, 2, 6, 40):
        path.write_bytes(raw[:3000] + raw[3000 + lost :])
        assert "should begin at byte" in files.read(path, ("ThreadPlan",)).about["doubts"]


def test_wide_satin_beside_small_stitches_is_no_doubt(tmp_path):
    path = tmp_path / "a.exp"
    plan = rows()
    wide = np.stack([np.where(np.arange(40) % 2, 9.0, 0.0), 0.2 * np.arange(40)], axis=1) + plan.xy[-1]
    xy = np.vstack([plan.xy[:-1], wide, wide[-1:]])
    command = np.zeros(len(xy), np.uint8)
    command[-1] = END
    files.write(ThreadPlan(xy, command, np.zeros(len(xy), np.int16), THREADS[:1]), path)
    assert "doubts" not in files.read(path, ("ThreadPlan",)).about


def test_moves_that_a_program_wrote_as_stitches_are_no_doubt_and_a_changed_byte_is(tmp_path):
    # 200 stitches of 2 mm, and between two blocks of them a move of 20 mm, cut at 12.1 mm as many programs cut it.
    small = [(20, 0), (-20, 3)] * 50
    steps = [*small, (120, 15), (78, 10), *small, (-120, -15), (-78, -10)]
    path = tmp_path / "a.exp"
    path.write_bytes(b"".join(bytes([x & 255, -y & 255]) for x, y in steps))
    assert "doubts" not in files.read(path, ("ThreadPlan",)).about
    steps[30] = (90, 3)
    alone = [s for s in steps if abs(s[0]) in (20, 90)]
    path.write_bytes(b"".join(bytes([x & 255, -y & 255]) for x, y in alone))
    assert "bytes may have been changed" in files.read(path, ("ThreadPlan",)).about["doubts"]
