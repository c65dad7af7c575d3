"""Machine records: a ThreadPlan in units of 0.1 mm, in the one order that every format can hold.

Between two needle points a plan may hold jumps, trims, stops and colour changes in any order. The records hold the
commands first, where the needle last was, and then one jump that ends over the next needle point: so no format's
peculiar treatment of jumps can add or move a stitch.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.thread import COLOR, END, JUMP, STITCH, STOP, TRIM, Thread, ThreadPlan

LARGEST = 127
"""Units: the largest step of formats that hold steps in signed bytes."""
CUT = 121
"""Units: what many programs cut a long move into, whatever the format takes (the largest step of DST)."""
FARTHEST = 20_000
"""No coordinate lies further out than this many units (2 m): more is not a design."""

_LARGEST = 64 << 20

# What a file without colours is shown in: told apart at a glance, thread-like.
SHADES: tuple[tuple[int, int, int], ...] = (
    (38, 64, 120),
    (178, 44, 52),
    (52, 116, 70),
    (224, 164, 46),
    (108, 66, 132),
    (36, 142, 158),
    (214, 112, 60),
    (122, 84, 58),
    (206, 104, 140),
    (120, 150, 60),
    (60, 62, 68),
    (150, 170, 196),
)


@dataclass(frozen=True, slots=True)
class Records:
    """``xy`` (N, 2) int64 units, ``command`` (N,) uint8 as in ThreadPlan, ``thread`` (N,) int16; END is the last."""

    xy: Array
    command: Array
    thread: Array


def load(path: Path) -> bytes:
    """The bytes of a machine file; TambourError above 64 MB (a million stitches are three)."""
    if path.stat().st_size > _LARGEST:
        raise TambourError("the file is larger than 64 MB: no machine file is", where=str(path))
    return path.read_bytes()


def records(plan: ThreadPlan) -> Records:
    """The plan's records. Raises TambourError for a plan without a stitch, or beyond 2 m."""
    command = plan.command
    if not (command == STITCH).any():
        raise TambourError("the design holds no stitch", hint="a machine file needs one at least")
    if np.abs(plan.xy).max() * 10 > FARTHEST:
        raise TambourError("the design is larger than 4 m", hint="give its size with {--width}")
    xy = np.rint(plan.xy * 10).astype(np.int64)
    needle = np.flatnonzero(command == STITCH)
    gap = np.searchsorted(needle, np.arange(len(command)))  # which needle point follows the command
    last = len(needle)

    def between(kind: int) -> Array:
        return np.bincount(gap[command == kind], minlength=last + 1)[:last]

    thread = plan.thread[needle]
    changed = np.r_[False, thread[1:] != thread[:-1]]
    missing = changed & (between(COLOR) == 0)
    lifted = (between(JUMP) + between(TRIM) + between(COLOR) > 0) | changed
    lifted[0] = True

    # A key sorts all: the needle point that follows, then commands as they came, a missing change, the jump, the stitch.
    held = np.flatnonzero(np.isin(command, (TRIM, STOP, COLOR)) & (gap > 0) & ((gap < last) | (command == TRIM)))
    parts = [
        (gap[held], np.zeros(len(held), np.int64), command[held]),
        (np.flatnonzero(missing), np.full(missing.sum(), 1), np.full(missing.sum(), COLOR)),
        (np.flatnonzero(lifted), np.full(lifted.sum(), 2), np.full(lifted.sum(), JUMP)),
        (np.arange(last), np.full(last, 3), np.full(last, STITCH)),
        (np.array([last]), np.array([4]), np.array([END])),
    ]
    after, rank, kind = (np.concatenate([p[k] for p in parts]) for k in range(3))
    order = np.lexsort((rank, after))
    after, kind = after[order], kind[order].astype(np.uint8)
    moves = (kind == STITCH) | (kind == JUMP)
    at = np.where(moves, after, after - 1).clip(0, last - 1)
    coming = np.where(kind == COLOR, after, at).clip(0, last - 1)
    return Records(xy[needle][at], kind, thread[coming])


def split(r: Records, limit: int) -> Records:
    """Records whose steps are at most ``limit`` units in x and in y: what is longer becomes jumps and a last step."""
    delta = np.diff(r.xy, axis=0, prepend=np.zeros((1, 2), np.int64))
    pieces = np.maximum(1, -(-np.abs(delta).max(axis=1) // limit))
    if pieces.max() == 1:
        return r
    source = np.repeat(np.arange(len(pieces)), pieces)
    ends = np.cumsum(pieces)
    k = np.arange(len(source)) - np.repeat(ends - pieces, pieces) + 1
    n = pieces[source]
    # Rounding half up of k·d/n in integers: neighbouring values differ by at most ceil(d/n).
    step = np.floor_divide(2 * delta[source] * k[:, None] + n[:, None], 2 * n[:, None])
    command = np.where(k < n, JUMP, r.command[source]).astype(np.uint8)
    return Records((r.xy - delta)[source] + step, command, r.thread[source])


def needle_points(xy: Array, command: Array) -> tuple[Array, Array, Array]:
    """What a design is to the eye: the needle points (K, 2), the number of changes and stops before each (K,), and
    whether the thread was cut since the one before it (K,), changes of colour apart."""
    stitch = np.flatnonzero(command == STITCH)
    changes = np.cumsum((command == COLOR) | (command == STOP))[stitch]
    trims = np.cumsum(command == TRIM)[stitch]
    first = changes[0] if len(changes) else 0
    cut = np.r_[False, (np.diff(trims) > 0) & (np.diff(changes) == 0)] if len(stitch) else np.zeros(0, np.bool_)
    return xy[stitch], changes - first, cut


def same(a: tuple[Array, Array, Array], b: tuple[Array, Array, Array]) -> str:
    """What differs between two designs' needle points ``a`` (wanted) and ``b`` (read back); "" when nothing does.

    A cut more than was wanted is no difference: many machines cut at every long jump.
    """
    if len(a[0]) != len(b[0]):
        return f"{len(a[0])} stitches became {len(b[0])}"
    if not np.array_equal(a[0], b[0]):
        return f"stitches moved by up to {np.abs(a[0] - b[0]).max() / 10:g} mm"
    if not np.array_equal(a[1], b[1]):
        return "the colour changes are not where they were"
    if (a[2] & ~b[2]).any():
        return f"{int((a[2] & ~b[2]).sum())} trims were lost"
    return ""


def blocks(r: Records, stops: bool) -> list[int]:
    """The thread index of every block between changes; ``stops``: a stop also begins one."""
    begins = (r.command == COLOR) | ((r.command == STOP) if stops else False)
    first = int(r.thread[np.flatnonzero(r.command == STITCH)[0]])
    return [first, *r.thread[begins].tolist()]


def strange(xy: Array, command: Array) -> str:
    """A doubt about stitches far longer than the rest, in units: what a changed byte leaves; "" where there are none.

    Of a hundred files by a dozen programs the longest stitch was at most 1.7 times as long as all but the longest hundredth,
    but for those that write moves as stitches: cut at a largest step, or going on one way in several. Where most long ones are
    such, none is doubted.
    """
    both = (command[1:] == STITCH) & (command[:-1] == STITCH)
    step = np.diff(xy, axis=0)[both].astype(np.float64)
    long = np.hypot(*step.T)
    if len(long) < 100:
        return ""
    usual = float(np.quantile(long, 0.99))
    odd = np.flatnonzero(long > max(50.0, 2 * usual))
    if not len(odd):
        return ""
    cut = (np.abs(step[odd]).max(axis=1) == LARGEST) | (np.abs(long[odd] - CUT) < 1.5)
    beside = [np.clip(odd + d, 0, len(long) - 1) for d in (-1, 1)]
    for k in beside:
        along = (step[odd] * step[k]).sum(axis=1) > 0.99 * long[odd] * long[k]
        cut |= along & (long[k] > 0.25 * long[odd]) & (k != odd)
    if 2 * cut.sum() >= len(odd):
        return ""
    many = f"{len(odd)} stitches are" if len(odd) > 1 else "one stitch is"
    return f"{many} up to {long[odd].max() / 10:.1f} mm long, nearly all others at most {usual / 10:.1f}: bytes may have been changed"


def plan_of(
    xy: Array, command: Array, threads: list[Thread], about: dict[str, str], which: Array | None = None
) -> ThreadPlan:
    """A plan from units (N, 2), commands, and the threads in order of the changes (``which`` names them otherwise).

    Missing threads take shades of ours, and ``about`` says so. Raises TambourError when nothing is stitched.
    """
    if not (command == STITCH).any():
        raise TambourError("the file holds no stitch")
    if np.abs(xy).max() > FARTHEST:
        raise TambourError(
            f"the stitches lie {np.abs(xy).max() / 10_000:.1f} m out", hint="the file is damaged, or no machine file"
        )
    stitched = np.cumsum(command == STITCH) > 0
    change = (command == COLOR) & stitched
    command = command.copy()
    drop = (command == COLOR) & ~stitched
    block = np.cumsum(change) if which is None else which
    need = int(block.max()) + 1
    if len(threads) < need:
        if not threads:
            about["colours"] = "not in the file"
        spare = [Thread(SHADES[k % len(SHADES)], f"colour {k + 1}") for k in range(len(threads), need)]
        threads = threads + spare
    if need > 32_000:
        raise TambourError(f"the file changes colour {need - 1} times", hint="the file is damaged, or no machine file")
    distinct = list(dict.fromkeys(threads[:need]))  # a colour that comes back is the same thread
    block = np.array([distinct.index(t) for t in threads[:need]])[block]
    keep = ~drop & (command != END)
    end = np.flatnonzero(keep)[-1]
    keep[end + 1 :] = False
    return ThreadPlan(
        np.vstack([xy[keep], xy[end : end + 1]]) / 10.0,
        np.r_[command[keep], END].astype(np.uint8),
        np.r_[block[keep], block[end]].astype(np.int16),
        tuple(distinct),
        None,
        about,
    )
