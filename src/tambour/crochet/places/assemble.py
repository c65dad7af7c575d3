"""Assemble: what was heard of the assembly, and what is usual where it is silent → finishing records."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.core.errors import Span
from tambour.crochet.graph.built import Built
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.places.bundles import bundles
from tambour.crochet.places.faces import Facer
from tambour.crochet.places.halves import halves
from tambour.crochet.places.hear import Copy, Feature, Heard, Put, Sentence
from tambour.crochet.places.hosts import DOMED, LIMBS, SIZES, Hosts
from tambour.crochet.places.layers import layers
from tambour.crochet.places.likely import NAMELESS
from tambour.crochet.places.names import Made, kind_of, one
from tambour.crochet.places.onward import onward
from tambour.crochet.places.said import Where, where
from tambour.crochet.places.toy import Assembled, versions
from tambour.crochet.places.wear import clothes

_CAPPED: Final = re.compile(
    r"\b(?:mushroom|toadstool|fungi|fungus|acorn|champignon|\w*pilz|seta|hongo|paddenstoel|gland|eichel|bellota|eikel)s?\b"
)
"""Toys, by their titles, whose caps are full."""
_STUFFED: Final = re.compile(
    r"\bstuff|\bfill (?:it|them|the|with|lightly|firmly)|\b(?:re?m)?bourr(?:ez|er|e)\b|\bgarni(?:r|ssez)\b|\w*stopfen\b|\b(?:be)?füllen\b|\brellen(?:ar|a|e)\b|\b(?:op)?vul(?:len)?\b"
)
"""That a part is stuffed, in five languages; what says that it is not is read elsewhere."""
_TAILED: Final = re.compile(r"\b(?:leav\w*|with)\b[^.]{0,30}\b(?:tail|end)\b")
_BOUGHT: Final = r"\b(?:safety|plastic|toy|doll) eyes?\b"
_LISTED: Final = rf"{_BOUGHT}|\beyes?:|\bbeads? for (?:the )?eyes"
"""Eyes that the materials list, and words that name some."""
_OTHER_SIDE: Final = re.compile(r"\b(?:opposite|other) side\b")
_NO_GUESS: Final = Where(shown=True)
_FEATURES: Final = re.compile(
    r"\bfacial features\b|\bfaces? (?:is|are) made\b|\b(?:embroider|sew|glue|draw)\w* (?:the |its |all )?features\b"
)
"""A face is made without a word of what is in it:"""
_FACE: Final = ("eyes", "smile")
"""so much of it every face has."""
FLAT: Final = frozenset(
    "ear wing fin fluke leaf hat spot cheek eye tuft collar bow spike inner door tooth face beard worn".split()
)
"""Kinds of parts that are not stuffed, unless it is said."""
_SHEETS: Final = frozenset(("", "base", "stem", "bow", "shell", "handle", "branch", "neck"))
"""Kinds of parts that are flat where they are worked in rows, and no edges of them are sewn together."""
_EVEN: Final = 2.5
"""A belly worked in rows lies flat whose longest row has no more than so many times the stitches of its shortest; a fan is a bowl."""
_SNOUTS: Final = frozenset(("beak", "muzzle", "nose"))
"""Kinds of things that eyes are on both sides of."""
_SMALL: Final = frozenset(("bow", "spot", "cheek", "tooth", "lamp"))
"""Kinds of things that are small beside what they are put on."""
_LAYERS: Final = frozenset(("ear", "wing", "fin", "leaf", "foot", "tail"))
"""Kinds of things that are made of two layers, one in another colour."""
_ONCE: Final = frozenset(("eyes", "nose", "mouth", "smile", "cheeks", "brows", "whiskers", "nostrils"))
"""Things of which a face has one, or one pair."""
_PAIRS: Final = frozenset(("ear", "wing", "foot"))
"""Kinds of things of which a toy has two, one each side."""


class Assembly(Hosts):
    """Puts a pattern together.

    built : the pattern worked; sentences : of its finishing, in order; stitch : a stitch's width, mm
    eye : the size of eyes that the materials name, mm; None unsaid; names : of the parts of this toy
    """

    def __init__(
        self, built: Built, sentences: list[Sentence], stitch: float, eye: float | None, names: list[str]
    ) -> None:
        super().__init__(built, stitch, eye, names)
        later = versions(self.parts)
        now = [p for p in self.parts if p not in later]
        behind, self.layered = layers(now, {p: self.size(p) for p in now}, self.text)
        around = {
            r.part.rpartition(".")[0] or r.part for r in built.pattern.finish if isinstance(r, Placed) and r.around
        }
        under = {p.heading: p for p in built.pattern.parts if p.heading and not p.twin}
        twins = [
            p for p in built.pattern.parts if p.twin and p.name not in around and p.copies == under[p.heading].copies
        ]
        kinds = {p.name: kind_of(one(p.heading.lower().split()[-1])) for p in twins}
        # One ear in each of two colours is a pair; two in each are its layers.
        second = {p.name for p in twins if kinds[p.name] in _LAYERS and not (p.copies == 1 and kinds[p.name] in _PAIRS)}
        behind = [*behind, *(p for p in now if p.name in second)]  # of tubes that lie on each other one is seen
        self.parts = [p for p in self.parts if p not in later and p not in behind]
        self.made.apart += [p.name for p in later]
        self.made.behind += [p.name for p in (*behind, *self.layered)]
        self._undressed()
        # What hangs from loops all round has its place.
        inside = [r for r in self.built.pattern.finish if isinstance(r, Placed)]
        own = {p.name for p in self.parts}
        self.around = [r for r in inside if r.around and own & {r.part, r.part.rpartition(".")[0]}]
        gone = {name for r in self.around for name in (r.part, r.part.rpartition(".")[0])}
        self.parts = [p for p in self.parts if p.name not in gone]
        trunk = any({"head", "body", "leg"} & {*p.kinds} for p in self.parts)
        self.parts = [replace(p, alone=p.vessel and not trunk) for p in self.parts]
        half = {k for pair in halves(built) for k in pair}
        both = {p.name for p in self.parts if p.copies == 2 and {self.spots.parts[p.copy(k)] for k in (1, 2)} <= half}
        bodied = any(p.kind == "body" and (p.single or p.name in both) for p in self.parts)
        # A toy of one body has one head: its two pieces are halves of it, joined by a gusset.
        both |= {p.name for p in self.parts if bodied and p.kind == "head" and p.copies == 2}
        self.parts = [replace(p, halved=p.name in both) for p in self.parts]
        self.sections |= {p.name: made for p in self.parts if p.halved and (made := self._sections(p))}
        for k, before in onward(
            built
        ):  # rounds that go on from two legs are the body, those from an arm the rest of it
            name, from_ = (built.pattern.parts[built.parts[i].section].name for i in (k, before[0]))
            kind = "body" if len(before) > 1 else Made(from_, 1).kind
            self.parts = [replace(p, likely=kind) if p.name == name and kind else p for p in self.parts]
        of = built.graph.part
        # What is sewn to, or worked on from, another part has its place there.
        ties = of[np.concatenate([built.graph.edges, built.sewn.reshape(-1, 2)])]
        self.sewn = {int(k) for k in np.unique(ties[ties[:, 0] != ties[:, 1]])}
        if self.parts:
            self._tailored()
            self._shaped()
        self.sentences = sentences
        self.heard = Heard(self.parts, sentences, self.text)
        self.heard.puts[:0] = self._worked_in()
        self.made.unstuffed += sorted(gone & own)
        self.made.lost = self.heard.lost
        self.dog = re.search(r"\b(?:dog|puppy|pup|hound|dachshund|spaniel|poodle)\b", self.text[:200]) is not None
        if self.parts:
            self.main = self._main()

    def _worked_in(self) -> list[Put]:
        """Puts of parts that are crocheted in: no other sentence says more of where they are."""
        made = {p.copy(k): (p, k) for p in self.parts for k in range(1, p.copies + 1)}
        made |= {p.name: (p, 1) for p in self.parts if p.copies == 1}
        return [
            Put(
                [made[r.part]],
                made[r.spot.part],
                "",
                Where(
                    (r.spot.round, r.spot.round, False), r.spot.stitch, words=frozenset(("flat",)), through=r.through
                ),
                r.span,
                0,
            )
            for r in self.built.pattern.finish
            if isinstance(r, Placed) and r.through and not r.around and r.part in made and r.spot.part in made
        ]

    def _main(self) -> Made:
        """What everything else is put on: what parts are sewn to and is sewn to nothing, else the body, else the head,
        else a stem under its cap, else the largest part made once."""
        bare = [p for p in self.parts if not p.worn] or self.parts
        single = [p for p in bare if p.single] or bare
        largest = max(single, key=self.size)
        body = self.of_kind("body") or self._carapace() or self.of_kind("head")
        if body is not None and (3 * self.size(body) > self.size(largest) or largest.kind):
            return body
        put = {c[0] for p in self.heard.puts for c in p.copies}
        under = [
            p.host[0]
            for p in self.heard.puts
            if p.host is not None and p.host[0] not in put and p.host[0].single and not p.host[0].worn
        ]
        stem = self.of_kind("stem")
        under = [p for p in under if stem is None or p.kind != "hat"]
        if under:
            return max(under, key=self.size)
        return (
            stem if stem is not None and largest.kind == "hat" and 6 * self.size(stem) > self.size(largest) else largest
        )

    # -- the whole --------------------------------------------------------------------------------------------------

    def assemble(self, usual: bool = True) -> Assembled:
        """All of it; ``usual``: parts that no sentence places go where such parts usually do."""
        if not self.parts:
            return self.made
        if usual:
            self._guess_parts()
            self._featured()
        if usual and (self.heard.puts or self.heard.features):
            self._stand_up()
            self._between_rims()
        put = Facer(self)
        put.waiting = waiting = self._tree()
        self._fill(waiting)
        if any(p.kind == "hat" and any(b[:2] == ("over", "nose") for b in p.where.beside) for p in self.heard.puts):
            for p in waiting:  # a gnome's nose looks out from under the brim
                if p.kind == "nose" and not p.where.says:
                    p.where = replace(p.where, words=p.where.words | {"upper"})
        put.snouts = [
            p for p in waiting if p.kind in _SNOUTS and any(b[:2] == ("between", "eye") for b in p.where.beside)
        ]
        under = self._under(self.bearer, waiting)
        roofed = [p for p in waiting if p.host is not None and p.host[0].kind == "hat"]  # a chimney waits for its roof
        trunk = [p for p in waiting if p.kind in ("head", "body", "neck", "stem") and p not in roofed]
        trunk = [p for p in waiting if p in trunk or p.copies[0][0] in under]
        for p in trunk:
            self.out += [(p.order, record) for record in put.part(p)]
        # Eyes whose rounds are known come before a muzzle, which is below them.
        self._patched(waiting)
        self._eyes(put, [f for f in self._seeing(usual) if f.where.rounds or f.where.end])
        for turn in ("plain", "beside"):
            if turn == "beside":
                self._eyes(put, [f for f in self._seeing(usual) if not (f.where.rounds or f.where.end)])
            for p in [p for p in waiting if p not in trunk]:
                if (bool(p.where.beside) and p.kind != "muzzle") == (turn == "beside"):
                    self.out += [(p.order, record) for record in put.part(p)]
        for feature in self._once():
            if feature.what != "safety eyes":
                self.out += [(feature.order, record) for record in put.feature(feature)]
        if usual:
            self.out += [(10_001, record) for record in bundles(self, put._lies((self.main, 1)), put)]
        # What is said to the stitch, as a hand that moved a part wrote it, stands for all that is said of it besides; the
        # others stay where they would be with it.
        exact = {r.part for r, _ in self.heard.exact if isinstance(r, Placed)}
        self.out = [pair for pair in self.out if not (isinstance(pair[1], Placed) and pair[1].part in exact)]
        self.out += [(order, record) for record, order in self.heard.exact]
        self.out += [(-1, record) for record in self.around]
        self.made.finish = [record for _, record in sorted(self.out, key=lambda pair: pair[0])]
        if usual and any(isinstance(record, Placed) for record in self.made.finish):
            self.made.worn = clothes(self)
            on = {one.part.split(".")[0]: one.host for one in self.made.worn}
            self.made.apart = [name for name in self.made.apart if name not in on]
            self.made.finish = [r for r in self.made.finish if not (isinstance(r, Placed) and r.part in on)]
            self.made.guessed += [(name, f"{name} worn on {host.split('.')[0]}") for name, host in on.items()]
        return self.made

    def _featured(self) -> None:
        """A face that the text has one make without a word of what is in it, "cut out facial features from felt", which is told."""
        faced = any({"eye", "muzzle", "nose", "beak", "face"} & {*p.kinds} for p in self.parts)
        if faced or self.heard.features or not _FEATURES.search(self.text):
            return
        self.made.guessed.append(("face", f"a face on {self.bearer.name}"))
        self.heard.features += [
            Feature(what, None, "", _NO_GUESS, Span(0, 0), 10_000, None, what, True) for what in _FACE
        ]

    def _fill(self, waiting: list[Put]) -> None:
        """Which parts are made to be flat: those that such parts are, and discs; where the text does not say it."""
        text, starts = self.text, sorted(p.span.start for p in self.built.pattern.parts)
        bears = bool(self.heard.features) or any(p.host is not None and p.host[0] == self.main for p in waiting)
        for part in self.built.pattern.parts:
            made = next((p for p in self.parts if p.name == part.name), None)
            if made is None or part.stuffing is not None or (made == self.main and bears):
                continue
            end = next((k for k in starts if k > part.span.start), len(text))
            if not made.worn and self._told_stuffed(part.name, part.span.start, end):
                continue
            counts = [
                r.count for r in self.built.rounds if not r.aside and r.part == self.spots.parts[f"{part.name}.1"]
            ]
            if made.kind == "hat" and _CAPPED.search(text[:200]):
                continue
            disc = bool(counts) and counts[-1] == max(counts) and counts[-1] > 4 * len(counts)
            disc = disc and made.kind not in DOMED
            # One layer holds no stuffing: what is neither folded to a tube nor sewn to its like.
            index = self.spots.parts[f"{part.name}.1"]
            alone = made.name in self.made.apart or (made == self.main and "stuff" not in text)
            sheet = (made.kind in _SHEETS or alone) and bool(self.spots.in_rows[index]) and index not in self.sewn
            even = bool(counts) and max(counts) <= _EVEN * min(counts)
            patch = made.kind == "belly" and even and bool(self.spots.in_rows[index])
            if disc or sheet or patch or made.worn or made.kind in FLAT:
                self.made.unstuffed.append(part.name)

    def _told_stuffed(self, name: str, start: int, end: int) -> bool:
        """Whether a stretch of the text says that a part is stuffed; sentences that speak of others alone do not: behind the last part stands
        "sew the roof to the walls, adding more stuffing"."""
        for found in _STUFFED.finditer(self.text, start, end):
            begin = max(self.text.rfind(sign, start, found.start()) for sign in ".!?\n") + 1
            ends = [at for sign in ".!?\n" if (at := self.text.find(sign, found.end(), end)) >= 0]
            said = self.text[max(begin, start) : min(ends, default=end)]
            named = {p.name for p in self.parts if re.search(rf"\b{re.escape(p.name.lower().removesuffix('s'))}", said)}
            if not named or name in named:
                return True
        return False

    def _taken(self) -> set[Copy]:
        """Copies that sentences put somewhere."""
        taken = {c for p in self.heard.puts for c in p.copies}
        exact = {r.part for r, _ in self.heard.exact if isinstance(r, Placed)}
        return taken | {(p, k) for p in self.parts for k in range(1, p.copies + 1) if p.copy(k) in exact}

    def _guess_parts(self) -> None:
        """Puts for parts that no sentence speaks of, and whose name says what they are."""
        taken, main = self._taken(), self.main
        if self._outfit():
            self.heard.puts = [p for p in self.heard.puts if p.host is not None]
            self.made.apart += [p.name for p in self.parts if p != main and (p, 1) not in self._taken()]
            return
        order = len(self.heard.puts) + len(self.heard.features) + len(self.heard.exact)
        for part in self.parts:
            free = [(part, k) for k in range(1, part.copies + 1) if part.worn or (part, k) not in taken]
            free = [c for c in free if self.spots.parts[c[0].copy(c[1])] not in self.sewn]
            if not free or part == main:
                continue
            if (other := self._other_half(part)) is not None:
                self.heard.puts.append(Put(free, (other, 1), "", _NO_GUESS, Span(0, 0), order, True))
                order += 1
                continue
            if not part.kind or part.worn or (part.kind in _SMALL and 2 * self.size(part) > self.size(main)):
                self.made.apart.append(part.name)  # a star half as large as the toy is another toy
                continue
            last = self.heard.puts[-1] if self.heard.puts else None
            if last is not None and last.guess and last.kind == part.kind == "tentacle":
                last.copies.extend(free)  # the first, and the second to the eighth
                continue
            mine = [p for p in self.heard.puts if p.copies[0][0] == part and not p.guess]
            if len(mine) == 1 and len(mine[0].copies) == 1 and mine[0].where.stitch is None and not part.worn:
                mine[0].copies[:] = sorted([*mine[0].copies, *free], key=lambda c: c[1])  # "repeat for the left ear"
                continue
            sizes = [SIZES & set(p.words) for p in (part, main)]
            if part.kind == main.kind == "body" and all(sizes) and sizes[0] != sizes[1]:
                self.made.apart.append(part.name)  # the body of another size of the toy
                continue
            onto = main if (part.kind in ("head", "body")) else None
            place = _NO_GUESS
            if (
                part.kind == "bow"
                and not part.words[0].startswith("hair")
                and any("collar" in p.words for p in self.parts)
            ):
                onto, place = main, where("at the front of the neck")  # "Collar and bow"
            self.heard.puts.append(Put(free, None if onto is None else (onto, 1), "", place, Span(0, 0), order, True))
            order += 1

    def _paired(self) -> None:
        """One limb in each of two colours, said in one sentence, are the two of a pair."""
        heading = {p.name: p.heading for p in self.built.pattern.parts if p.heading and p.copies == 1}
        found: list[Put] = []
        for p in self.heard.puts:
            name = p.copies[0][0].name
            alike = [
                q
                for q in found
                if name in heading and q.span == p.span and len(q.copies) == len(p.copies) == 1
                if heading.get(q.copies[0][0].name) == heading[name] and q.copies != p.copies
            ]
            if alike and p.kind in {*_PAIRS, "leg", "arm"}:
                alike[0].copies.append(p.copies[0])
            else:
                found.append(p)
        self.heard.puts = found

    def _tree(self) -> list[Put]:
        """Every put with what it is put on, those that others stand on first; no copy twice, none on itself."""
        self._paired()
        main = self.main
        exact = {r.part: r.spot.part for r, _ in self.heard.exact if isinstance(r, Placed)}
        seen: set[Copy] = {(main, 1)}
        puts: list[Put] = []
        hosts = {c: p.host for p in reversed(self.heard.puts) if p.host is not None for c in p.copies}
        # What says most of a place comes first, whatever was said before.
        for p in sorted(self.heard.puts, key=_vagueness):
            if (main, 1) in p.copies:
                # "Sew the body to the head": the head is put on the body.
                if p.host is not None and len(p.copies) == 1 and p.host not in seen:
                    (part, k), rounds = p.host, p.where.rounds
                    copies = [(part, n) for n in ([k] if k else range(1, part.copies + 1))]
                    own = replace(p.where, rounds=None, stitch=None)  # they are of what it is said to be put on
                    p = replace(p, copies=copies, host=(main, 1), where=own)
                    if not part.kind and rounds is None:
                        # What was said of the middle of a mat says nothing of the head on it: the mat is under it.
                        p.where = replace(p.where, stitch=None, beside=(), words=frozenset(("bottom",)))
                else:
                    p = replace(p, copies=[c for c in p.copies if c != (main, 1)], host=p.host or (main, 1))
            free = [
                c
                for c in p.copies
                if c not in seen
                and not c[0].worn
                and c[1] <= self.layered.get(c[0], c[1])
                and self.spots.parts[c[0].copy(c[1])] not in self.sewn
            ]
            if free and p.host is None and p.where.rounds is not None:
                p.host = hosts.get(free[0])  # "sew the claws to the arm. Sew them to Rnd 1.": of the arm
            if free and p.host is not None and p.host[0].worn and p.host[0] != main and not p.copies[0][0].worn:
                if p.kind not in LIMBS | {"head", "body", "neck"}:
                    seen.update(free)  # a flower on a dress that lies beside the toy
                    self.made.apart.append(free[0][0].name)
                    continue
                p.host = (main, 1)  # in its sleeves, and sewn to the body under them
            if free and free[0][0].halved and free[0][0].kind == "head":
                seen.update(free)
                self.made.behind += [free[0][0].name] if len(free) > 1 else []
                free = free[:1]
            if free and self._another(p, puts):
                seen.update(free)
                self.made.apart.append(p.copies[0][0].name)
                free = []
            if free and p.host is None and not p.where.says and not free[0][0].kind and NAMELESS.match(free[0][0].name):
                self.made.apart.append(free[0][0].name)
                free = []
            if not free:
                self._said_again(p, puts)
                continue
            seen.update(free)
            puts.append(replace(p, copies=free))
        on: dict[str, str] = {}
        for p in puts:
            self._seat(p, puts)
            assert p.host is not None
            for c in p.copies:
                on[c[0].copy(c[1])] = p.host[0].copy(max(1, p.host[1]))
        on.update(exact)

        def depth(name: str) -> int:
            n, seen_ = 0, set[str]()
            while name in on and name not in seen_:
                seen_.add(name)
                name, n = on[name], n + 1
            return 99 if name in seen_ else n

        for p in puts:
            name = p.copies[0][0].copy(p.copies[0][1])
            if _circle(
                name, on
            ):  # of parts that stand on each other one is put on the main part, the rest stays as it is
                p.host = (main, 1)
                on |= {c[0].copy(c[1]): main.copy(1) for c in p.copies}
        # A beak is below the eyes, also where it is sewn on before them; a heart on the chest finds its place between the arms.
        return sorted(
            puts, key=lambda p: (depth(p.copies[0][0].copy(p.copies[0][1])), p.kind != "eye", p.kind == "bow")
        )

    @staticmethod
    def _under(part: Made, puts: list[Put]) -> set[Made]:
        """A part, and what it stands on, one on the other."""
        found = {part}
        while (on := next((p.host[0] for p in puts if p.copies[0][0] == part and p.host), None)) and on not in found:
            found.add(on)
            part = on
        return found

    def _patched(self, waiting: list[Put]) -> None:
        """Patches about the eyes, of which nothing else is said, go where the eyes do, and the eyes into their middles."""
        for p in waiting:
            if p.kind != "eye" or len(p.copies) != 2 or p.where.rounds is not None or p.where.beside:
                continue
            eyes = [f for f in self._seeing(False) if f.where.rounds is not None and f.host in (None, p.host)]
            if len(eyes) == 1:
                p.where = eyes[0].where
                self.heard.features.append(
                    replace(eyes[0], where=replace(p.where, rounds=None, stitch=None, beside=()))
                )
                self.heard.features.remove(eyes[0])

    def _once(self) -> list[Feature]:
        """What is embroidered, each thing of a face once: "embroider nose" in the head's rounds and again at the end is one nose, and
        eyes of thread without a place are those of glass for a small child."""
        made: list[Feature] = []
        glass = any(isinstance(record, Eye) for _, record in self.out)
        for f in self.heard.features:
            thing = f.what.split()[-1]
            if thing == "eyes" and glass and not f.where.says and f.what == "eyes":
                continue
            alike = [k for k, g in enumerate(made) if g.what.split()[-1] == thing]
            alike = [k for k in alike if f.host is None or made[k].host in (None, f.host)]
            alike = [k for k in alike if not (made[k].where.says and f.where.says)]
            if not alike or thing not in _ONCE:
                made.append(f)
            elif f.where.says:
                made[alike[0]] = f
        return made

    def _eyes(self, put: Facer, features: list[Feature]) -> None:
        for feature in features:
            self.out += [(feature.order, record) for record in put.eyes(feature)]

    def _seeing(self, usual: bool) -> list[Feature]:
        """Safety eyes, where they are said; once, or those that the materials list, where nothing says more."""
        every = [f for f in self.heard.features if f.what in ("safety eyes", "eyes", "closed eyes")]
        # Eyes of glass beside a pair that is crocheted are their pupils.
        there = any("eye" in p.kinds and p.copies != 2 for p in self.parts)
        there = there or any(isinstance(r, Eye) for r, _ in self.heard.exact)
        listed = re.search(_BOUGHT if any("eye" in p.kinds for p in self.parts) else _LISTED, self.text)
        if usual and not every and not there and listed:
            return [Feature("safety eyes", None, "", _NO_GUESS, Span(0, 0), 10_000, None, "eyes", True)]
        said = [f for f in every if f.where.rounds] or [f for f in every if f.where.says] or every[:1]
        return [f for f in said if f.what == "safety eyes"]


def _vagueness(put: Put) -> int:
    """How little a sentence says of a place: "leaving a tail to sew it to the body" least of all."""
    if put.where.rounds or put.where.end:
        return 0
    if len(put.copies) == 1 < put.copies[0][0].copies and not put.where.beside and _OTHER_SIDE.search(put.where.text):
        return 3  # the mirror image of what is said of the first
    return 3 if _TAILED.search(put.where.text) else 1 if put.where.says else 2


def _circle(name: str, on: dict[str, str]) -> bool:
    """Whether a part stands, over others, on itself."""
    at, left = on.get(name, ""), len(on)
    while at in on and at != name and left:
        at, left = on[at], left - 1
    return at == name
