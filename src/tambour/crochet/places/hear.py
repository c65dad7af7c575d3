"""Heard: sentences of the assembly → which parts are put where, and what is put or embroidered on a face."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.finishes import Finish, Placed
from tambour.crochet.places import face, lines
from tambour.crochet.places.assembling import (
    ADJACENT,
    ALL,
    BLUSH,
    BUTTONS,
    CLOSING,
    DRAWN,
    EYED,
    EYES,
    IT,
    MEET,
    ONTO_BASE,
    SAFETY_NOSE,
    SHUT_AT,
    THREAD,
    TO,
    UNDER_HEAD,
    WHEN,
    put_eyes,
)
from tambour.crochet.places.groups import (
    ALIKE,
    BEFORE,
    BOTH,
    BY_IT,
    HANDLED,
    ONE_OTHER,
    again,
    apart,
    below_eyes,
    grouped,
    of_each,
    paired,
)
from tambour.crochet.places.habits import plainly, unlisted
from tambour.crochet.places.hairdo import COMBED, SEWN_HAIR, is_hair
from tambour.crochet.places.names import Made, Mention, its_own, kind_of, mentions, one
from tambour.crochet.places.said import OF_PLACE, VERB, Where, clauses, where
from tambour.crochet.words.numbers import QUANTITY, quantity

Copy = tuple[Made, int]
_NEXT: Final = re.compile(r"\s*(?:at|to|onto|on|between|over|along|beside|next to|behind|close to)\b")
_MORE: Final = re.compile(rf"(?:\band|,)\s+(?:with\s+)?(?:the\s+|\w+ing\s+|{QUANTITY}\s+)?$")
_COUNTED: Final = re.compile(rf"\b({QUANTITY})\s+(?:(?!of\b)[a-z]+\s+)?$")
"""How many of a part are put there, before its name: "two flowers to the side"."""
_ON: Final = re.compile(r"(?:sew|stitch|put|attach|pin|glue)\s+on\s+(?:the\s+|both\s+|all\s+)?")
"""Where "on" may belong to the verb: "sew on the snout"."""
_PASSIVE: Final = re.compile(
    r"(?:\b(?:is|are|be|being|get|gets|should be)\s+(?:\w+(?:ed|shut|closed)\s+(?:\w+ly\s+|flat\s+)?(?:,\s*)?(?:and\s+)?(?:then\s+)?)?|[:–—|→-]\s*|^\s*|\beach\s+)$"
)
_FIRST_DONE: Final = re.compile(
    r"\b(?:stuff|fold|flatten|gather|pin|press|pinch|squash|squeeze|weight|close|shape|bend|lay|slip|drop)\w*\s+(?:down\s+|up\s+|over\s+|in\s+)?"
    r"(?:(?:the\s+)?(?:open\s+|wide\s+|upper\s+|lower\s+|top\s+)?(?:top|bottom|end|edge|tip|base|opening)s?\s+of\s+)?(?:the\s+|each\s+|both\s+|left\s+|right\s+)*$"
)
"""What is done with a part before it is sewn: "stuff the snout and sew to the head"."""
_EDGES: Final = re.compile(
    r"\b(?:match|line up|align)\s+(?:the\s+)?(?:\w+\s+)?(?:edges?|rims?|stitches)\s+of\s+(the\s+\w+(?:\s\w+)?)\s+(?:with|to|and)\s+"
    r"(?:(?:the\s+)?(?:\w+\s+)?(?:edges?|rims?|stitches|that|those)\s+of\s+)?(?=the\b)"
)
"""Two edges that are laid on each other before they are sewn: "Match the edge of the gills with the edge of the cap and whip stitch"."""
_IT: Final = re.compile(
    r"(?:sew|stitch|attach|pin|place|position|glue|whipstitch|put|fasten|tack|secure|join|seam)\s+(?:it\b|them\b|these\b|"
    r"this\b|(?:the )?(?:piece|circle|disc|disk|oval)\b|both\b|to\b|onto\b|on\b(?! (?:\w+ )?(?:buttons|beads|sequins|bells?|ribbons?|pompoms?|bows?)\b)|in place|in position|between\b|at\b|over\b|around\b|securely\b|firmly\b|\d+ (?:on|to|at|in|onto|each)\b|one\b|"
    r"evenly\b|down\b|across\b|centered\b|under\b|below\b|above\b|along\b|each\b|using\b|as\b)"
)
"""A sentence that says what is done with the part that it stands in."""
_THESE: Final = re.compile(r"\s(?:them|these|both)\b")
_CLOSED: Final = re.compile(r"\b(?:sew|seam|whip|stitch|close)\w*\b.*\b(?:closed|shut|close)\b|^\W*stuff\b")
"""What is done with a part before "it" is sewn on."""
_SEWN_EYES: Final = re.compile(r"embroider|\b(?:french knots?|satin|backstitch\w*)\b")
"""How eyes are made of thread."""
_OF_IT: Final = re.compile(r"\b(?:rounds?|rnds?|rows?|r\s?\d+|edge|end|side)\b[^,;]{0,14}\bof\b")
"""What is said of the rounds of what is sewn."""
_OF_BODY: Final = frozenset(("arm", "leg", "wing", "fin", "tail", "belly"))
"""What is sewn to a body, and never to the head above it."""
_FROM_MEET: Final = re.compile(r"\b(?:from|below|under) (?:the place )?(?:where|at which)\b")
_BACK, _FAR = 240, 4
"""So many letters, and one sentence fewer, before a sentence tell what "them" are in it."""
_EACH: Final = re.compile(r"\b(?:each|both|either|every)\b")
_NEAR: Final = re.compile(
    r"\b(?:below|beneath|under|underneath|above|between|beside|next to|near|close to|alongside|behind|in front of|ahead of|level with|in line with|"
    r"on (?:either|both|each) sides? of(?! (?:the |its )?(?:tip|end)\b)|as|from|towards?|so that|so|between (?:the |each |both )?\w+ and)\s+"
    r"(?:the\s+|an?\s+|each\s+|both\s+|its\s+|his\s+|her\s+|two\s+|side\s+|front\s+|back\s+|hind\s+|end\s+|edge\s+|frame\s+|tip\s+|of\s+|white\s+|cream\s+|black\s+|pink\s+|red\s+|light\s+|dark\s+)*$"
)
"""Words before a part that something is only near."""
_BEHIND: Final = re.compile(r"\b(?:behind|below|beneath|under|underneath)\s+(?:the|his|her|its)\s+$")
_NEAR_HEAD: Final = re.compile(
    r"\b(?:behind|below|beneath|under|underneath|next to|near) (?:the |his |her |its )?(?:head|face)\b"
)


@dataclass(frozen=True)
class Sentence:
    """A sentence of finishing: its words as written, its place, the part it stands in, and the colours that it names (where in it, which)."""

    text: str
    span: Span
    part: str
    colors: tuple[tuple[int, RGB], ...] = ()
    exact: Finish | None = None


@dataclass
class Put:
    """A part that is put somewhere: which copies, on which part ("" unsaid), where; ``order``: of its sentence."""

    copies: list[Copy]
    host: Copy | None
    region: str
    where: Where
    span: Span
    order: int
    guess: bool = False
    word: str = ""
    strange: bool = False  # it is sewn to something that no part is called

    @property
    def kind(self) -> str:
        """What the parts are: of "Arms and legs" what the sentence calls them."""
        made = self.copies[0][0]
        said = kind_of(self.word)
        some = len(self.copies) < made.copies  # "arms and legs", all four of them, are two and two
        return said if some and said in made.kinds and len(made.kinds) > 1 and made.kind == "arm" else made.kind


@dataclass
class Feature:
    """Eyes, or something embroidered: what, on what, where."""

    what: str
    host: Copy | None
    region: str
    where: Where
    span: Span
    order: int
    color: RGB | None
    text: str
    guess: bool = False
    also: list[Span] = field(default_factory=list)


_NO_PART: Final = frozenset(
    """the its her his their each both either other one two three side sides top bottom back front rear middle center centre left right upper lower
    and with using over under place piece toy work shown photo picture pictured photograph diagram image guide reference matching yarn thread
    tail tails end ends sewing needle securely firmly neatly evenly whip stitch whipstitch stitches same way opposite face facing edge edges
    seam around all together desired needed from this that small long down just slightly""".split()
)
"""Words behind "to" that name no part."""
_YARNED: Final = re.compile(r"\w+(?: \w+)? (?:thread|yarn|floss|wool|cotton|embroidery|felt)")
"""A colour by which a place is called ("one on each side of the white muzzle") is none of what is put there."""


class Heard:
    """What the sentences say. parts : those that are there; text : all of it, in small letters; lost : sentences that put nothing anywhere."""

    def __init__(self, parts: list[Made], sentences: list[Sentence], text: str = "") -> None:
        self.parts = parts
        self.puts: list[Put] = []
        self.features: list[Feature] = []
        self.exact: list[tuple[Finish, int]] = []
        self.lost: list[Span] = []
        self.everything = False  # "sew everything as shown"
        self._text = text
        for order, sentence in enumerate(sentences):
            self._hear(sentence, order)

    def _hear(self, sentence: Sentence, order: int) -> None:
        """The statements of one sentence."""
        if sentence.exact is not None:
            if isinstance(sentence.exact, Placed):  # the last word on a part holds
                part = sentence.exact.part
                self.exact = [(r, k) for r, k in self.exact if not isinstance(r, Placed) or r.part != part]
            self.exact.append((sentence.exact, order))
            return
        low = sentence.text.lower().replace("\n", " ")
        low = BEFORE.sub("and sew them", low)
        low = WHEN.sub(lambda m: " " * len(m[0]), low)
        if ALL.search(low):
            self.everything = True
            return
        if self._hair(low, sentence, order):
            return
        heard, begin = False, 0
        own = [(at, rgb) for at, rgb in sentence.colors if not OF_PLACE.search(low[:at]) or _YARNED.match(low, at)]
        low = grouped(unlisted(self._once_more(below_eyes(low, [f.what for f in self.features]))), self.parts)
        for a, b in clauses(low):
            shades = [rgb for at, rgb in own if a <= at < b] or [rgb for _, rgb in own[:1]]
            # What says nothing alone belongs to what follows: "locate the nose 1 rnd below and embroider it".
            done = self._clause(low[a:b], sentence, order, shades[0] if shades else None) or (
                begin < a and self._clause(low[begin:b], sentence, order, shades[0] if shades else None)
            )
            heard, begin = heard or done, b if done else begin
        if not heard:
            self.lost.append(sentence.span)

    def _once_more(self, low: str) -> str:
        """What is done again for another part, said in full."""
        last = self.puts[-1] if self.puts else None
        return low if last is None or last.host is None else again(low, last.host[0].name, "sides" in last.where.words)

    def _hair(self, low: str, sentence: Sentence, order: int) -> bool:
        """Whether a sentence says how hair of yarn is made that no part is: along a parting, all over, in bunches."""
        if EYES.search(low) or any(p.hair or p.kind == "tuft" for p in self.parts):
            return False
        known = next((f for f in self.features if f.what == "hair"), None)
        if not is_hair(low) and (known is None or not COMBED.search(low)):
            return False
        color = sentence.colors[0][1] if sentence.colors else None
        if known is not None:
            known.text += f". {low}"
            known.also.append(sentence.span)
            known.color = known.color or color
            known.where = known.where if known.where.rounds is not None else where(low)
            return True
        host = next(((p, 1) for p in self.parts if p.single and p.kind == "head"), None)
        self.features.append(Feature("hair", host, "head", where(low), sentence.span, order, color, low))
        return True

    def _clause(self, low: str, sentence: Sentence, order: int, color: RGB | None) -> bool:
        low = plainly(low)
        if (more := lines.second(low)) and self._clause(low[:more], sentence, order, color) and self.features:
            before = self.features[-1:]
            self._clause(f"embroider {low[more:]}", sentence, order, color)
            before[0].host = before[0].host or self.features[-1].host
            return True
        low = _EDGES.sub(r"sew \1 to ", MEET.sub("neck of body" if _FROM_MEET.search(low) else "at neck of body", low))
        found = mentions(low, self.parts)
        if (under := UNDER_HEAD.search(low)) and self._limbs(found, under.start()):
            far = f"{under[2]} below" if under[2] else "just below"
            low = f"{low[: under.start()]}{far} the top of the body{low[under.end() :]}"
            found = mentions(low, self.parts)
        if (onto := ONTO_BASE.search(low)) and found and found[0].start >= onto.end():
            base = found[0].copies
            if base[0][0].kind == "base":
                self.puts.append(Put(list(base), None, "", where(""), sentence.span, order))
                return True
        at = where(low)
        hair = SEWN_HAIR.search(low)
        if hair and not any(p.hair for p in self.parts):
            if not any(f.what == "hair" for f in self.features):
                host = self._on([m for m in found if m.start > hair.start()], low)
                self.features.append(Feature("hair", host, "head", at, sentence.span, order, color, low))
            rest = low[: hair.start("hair")] + " " * len(hair["hair"]) + low[hair.end() :]
            if not (
                EYES.search(rest, hair.start(), hair.start("hair")) or any(m.end < hair.start("hair") for m in found)
            ):
                return True
            low = rest  # "sew eyes and hair to head" puts eyes too
        glass = re.search(r"\b(?:safety|plastic|toy|bead|button|googly)s? eyes?\b|\bbeads? for eyes\b", low)
        if glass:  # these are no eyelids that were crocheted
            found = [m for m in found if not (glass.start() <= m.start < glass.end())]
        named_eyes = any("eye" in m.copies[0][0].kinds for m in found) and not (glass and put_eyes(low, glass.start()))
        features = face.motifs(low) if DRAWN.search(low) or SAFETY_NOSE.search(low) or "felt" in low else []
        if features:  # a nose that is embroidered is no muzzle
            drawn = ("nose", "mouth", "eye", "cheek", "beak", "brow", "eyebrow")
            found = [m for m in found if m.word not in drawn or any(m.word in p.words for p, _ in m.copies)]
        features = [f for f in features if not any(f.rstrip("s") in m.word for m in found)]
        straight = features[:1] in (["lines"], ["cross"])
        features = [] if straight and lines.worked(low, [(m.start, m.end) for m in found]) else features
        felt = re.search(r"\bfelt\b", low)
        eyes = EYES.search(low)
        eyed = bool(
            eyes
            and EYED.search(low)
            and not _SEWN_EYES.search(low)
            and not named_eyes
            and not BLUSH.search(low)
            and put_eyes(low, eyes.start())
        )
        if (two := ONE_OTHER.search(low)) and (which := mentions(two[1], self.parts)):
            part = which[0].copies[0][0]
            if part.copies == 2 and VERB.search(low[: two.start()] + " "):
                host = next((m.copies[0] for m in found if m.copies[0][0] != part), None)
                also = BOTH.search(low, two.end())
                for k, words in ((1, two[2]), (2, two[3])):
                    place = where(f"{words}, {also[0]}" if also else words)
                    self.puts.append(Put([(part, k)], host, self._region(low), place, sentence.span, order))
                rest = low[: two.start()] + low[two.end() :]
                return self._clause(rest, sentence, order, color) or True
        if eyed or (
            features
            and (
                re.search(r"embroider|satin|knot|backstitch|straight st|whisker|blush|freckle|safety nose", low)
                or not found
                or felt
                or straight
                or ((drawn_at := face.found(features[0], low)) is not None and drawn_at[0] < found[0].start)
            )
        ):
            host = self._on(found, low) or self._stem(sentence)
            if straight and host is None:  # on a part that is made several times, or on the one that the words stand in
                worked = lines.behind_rounds(self._text, sentence.span.start)
                stands = next((p for p in self.parts if worked and p.name == sentence.part), None)
                host = found[-1].copies[0] if found else None if stands is None else (stands, 1)
            both = ["nose"] if re.search(r"\beyes? and (?:the )?(?:safety )?nose\b", low) else []
            names = ["safety eyes", *both] if eyed else [face.styled(f, low) for f in features]
            pieces = face.pieces(low, features) if len(features) > 1 and not eyed else [low] * max(len(names), 1)
            for name, piece in zip(names, pieces):
                own = where(piece)
                place = own if own.says or own.wide else at if piece is low or not at.beside else replace(at, beside=())
                self.features.append(Feature(name, host, self._region(low), place, sentence.span, order, color, low))
            return True
        if BLUSH.search(low) and not any(m.word == "cheek" for m in found):
            head = next((p for p in self.parts if p.single and p.kind == "head"), None)
            self.features.append(
                Feature("cheeks", None if head is None else (head, 1), "head", at, sentence.span, order, color, low)
            )
            return True
        if BUTTONS.search(low) and not re.search(r"\b(?:eyes?|nose|nostril)", low):
            head = next((p for p in self.parts if p.single and p.kind == "head"), None)
            place = replace(at, words=frozenset(), beside=())
            host = None if head is None else (head, 1)
            self.features.append(Feature("safety eyes", host, "head", place, sentence.span, order, None, "eyes"))
            return True
        if (THREAD.search(low) or "embroider" in low) and not re.search(r"\b(?:sew|attach|whipstitch)\b", low):
            return False  # "satin stitch over the bridge of the beak": no thing that is known is drawn there
        return self._put(low, found, at, sentence, order)

    @staticmethod
    def _limbs(found: list[Mention], end: int) -> bool:
        """Whether what is spoken of before a place are limbs of a body."""
        return any(m.end <= end and m.copies[0][0].kind in _OF_BODY for m in found)

    def _put(self, low: str, found: list[Mention], at: Where, sentence: Sentence, order: int) -> bool:
        verb = VERB.search(low)
        if not verb or not re.search(
            r"\b(?:sew|sewn|attach\w*|stitch\w*|pin\w*|position\w*|place\w*|join|fix|glue|fasten|secure|put|add|tack|whipstitch|set|insert|mount|center|centre|seam|applique|goes|go|scatter|arrange|distribute|button|joint)\b",
            low,
        ):
            return False
        if ALIKE.search(low) and self.puts and not at.words & {"sides", "top", "bottom", "front", "back"}:
            at = replace(at, words=at.words | (self.puts[-1].where.words & {"sides"}))
        to = TO.search(low, self._particle(low, verb, found, sentence))
        # "arms to the sides of the body and legs to its bottom" are two.
        more = [
            m for m in found if to and m.start > to.end() and _NEXT.match(low, m.end) and _MORE.search(low[: m.start])
        ]
        if more:
            joined = _MORE.search(low[: more[0].start])
            assert joined is not None
            rest = f"sew {low[joined.start() :].removeprefix('and').lstrip(' ,').removeprefix('with ')}"
            if found[0].start < more[0].start:
                rest = BY_IT.sub(rf"\1 the {found[0].word}", rest)
            low = low[: more[0].start]
            at, found = where(low), [m for m in found if m.end <= more[0].start]
            done = self._put(low, found, at, sentence, order)
            return self._put(rest, mentions(rest, self.parts), where(rest), sentence, order) or done
        objects = [m for m in found if m.start >= verb.end() and (not to or m.start < to.start())]
        hosts = [m for m in found if to and m.start >= to.end() and not _NEAR.search(low[: m.start])]
        hosts = [m for m in hosts if not m.copies[0][0].worn] or hosts
        if not hosts and to:  # "on each side of the wig"
            hosts = [m for m in found if m.start >= to.end() and m.copies[0][0].kind in ("hat", "head", "body")]
            hosts = [m for m in hosts if not _BEHIND.search(low[: m.start])]
        if to is not None and at.rounds is not None and _OF_IT.search(low[: to.start()]):
            # "the last round of the tail to the body": rounds of what is sewn say nothing of where.
            there = where(low[to.start() :])
            at = at if there.rounds is not None and there.rounds == at.rounds else replace(at, rounds=there.rounds)
        if objects and not ADJACENT.match(low[verb.end() : objects[0].start]):
            objects = []
        elif (
            not objects and found and found[0].end <= verb.start() and _PASSIVE.search(low[found[0].end : verb.start()])
        ):
            objects = [m for m in found if m.end <= verb.start()]
        if not objects and found and found[0].end <= verb.start() and _FIRST_DONE.search(low[: found[0].start]):
            objects = [m for m in found if m.end <= verb.start()]
            at = where(
                low[verb.start() :]
            )  # "fold down the top of the ear and sew it to the body" says no top of the body
        before = [m for m in found if m.end <= verb.start()]
        if not objects and before and (led := HANDLED.match(low)) is not None and before[0].end <= led.end():
            objects, at = before[:1], where(low[verb.start() :])
            hosts = [m for m in hosts if m is not before[0]]
        if not objects and (laid := [m for m in before if _FIRST_DONE.search(low[: m.start])]):
            # "Fill the pot, lay the soil in and sew it down all around just under the rim (R14)"
            objects, at = laid[-1:], where(low[verb.start() :])
            hosts = hosts or [m for m in before if m.copies[0][0].vessel and m is not laid[-1]]
        if not objects and before and IT.match(low[verb.start() :]):
            objects = before[:1]  # "Once you like where the ears sit, sew them on"
            hosts = [m for m in hosts if m is not before[0]]
        if not objects and _IT.match(low, verb.start()) and (meant := self._just_closed(sentence)):
            objects = meant
            hosts = [m for m in hosts if m.copies[0][0] != meant[0].copies[0][0]]
        if not objects and sentence.part and _IT.match(low, verb.start()):
            known = next((p for p in self.parts if p.name == sentence.part), None)
            if known is not None and not (known.copies == 1 and _THESE.search(low, verb.start())):
                every = tuple((known, k) for k in range(1, known.copies + 1))
                objects = [Mention(0, 0, known.words[-1] if known.words else "", every, True)]
                hosts = [m for m in hosts if m.copies[0][0] != known]
        if (
            not hosts
            and (at.rounds is None or SHUT_AT.search(low))
            and CLOSING.search(low)
            and len({c[0] for m in objects for c in m.copies}) < 2
        ):
            return bool(objects or sentence.part)
        if not objects:
            return False
        copies = list(
            dict.fromkeys(
                c for m in objects for c in self._counted(paired(its_own(m, sentence.part), "sides" in at.words), low)
            )
        )
        host = next((of_each(m, copies) for m in hosts for c in m.copies if c[0] not in [p for p, _ in copies]), None)
        if host is None and re.search(r"\btog(?:ether)?\b", low) and len({p.name for p, _ in copies}) == 2:
            host = copies.pop()
            host = (host[0], 0) if host[0].copies == len([c for c in copies if c[0] != host[0]]) > 1 else host
            copies = [c for c in copies if c[0] != host[0]]
        word = {p: m.word for m in objects for p, _ in m.copies}
        onto = set(re.findall(r"[a-z]{3,}", low[to.end() :])) if to is not None and host is None else set()
        strange = bool(onto - _NO_PART) and not self._region(low) and not at.beside and at.rounds is None
        for group in apart(copies):
            called = one(word[group[0][0]])
            if not (host or at.says or at.apart) and any(p.copies == group and p.where.says for p in self.puts):
                continue  # "Sew the closed tops", behind where they go
            self.puts.append(Put(group, host, self._region(low), at, sentence.span, order, False, called, strange))
        return True

    def _counted(self, mention: Mention, low: str) -> tuple[Copy, ...]:
        """The copies of a part that are meant: "one flower" is the next that has no place, "two flowers" are the two after it."""
        part, said = mention.copies[0][0], _COUNTED.search(low[: mention.start])
        many = int(quantity(said[1])) if said else 0
        if (
            not 0 < many < part.copies
            or part.copies < 3
            or len({p for p, _ in mention.copies}) > 1
            or _EACH.search(low)
        ):
            return mention.copies
        given = {c for p in self.puts for c in p.copies}
        free = [(part, k) for k in range(1, part.copies + 1) if (part, k) not in given]
        return tuple(free[:many]) if len(free) >= many else mention.copies

    def _just_closed(self, sentence: Sentence) -> list[Mention]:
        """The part of which the sentence before speaks: "Sew top of legs closed. Sew to bottom of body.", "Take the arms. Sew them on"."""
        before = [
            line
            for line in re.split(r"[.!\n]", self._text[max(0, sentence.span.start - _BACK) : sentence.span.start])
            if line.strip()
        ]
        named = IT.match(sentence.text.lower()) is not None
        for line in before[:-_FAR:-1] if named else before[-1:]:
            closed = _CLOSED.search(line) or HANDLED.match(line.lower().lstrip())
            found = mentions(line.lower(), self.parts) if named or closed else []
            if found:
                return found[:1] if found[0].copies[0][0].name != sentence.part else []
        return []

    @staticmethod
    def _particle(low: str, verb: re.Match[str], found: list[Mention], sentence: Sentence) -> int:
        """Where the words after a verb begin; "on" of "sew on the snout" belongs to it, not that of "sew on body"."""
        on = _ON.match(low, verb.start())
        after = next((m for m in found if on and m.start == on.end()), None)
        if on is None or after is None:
            return verb.end()
        kind = after.copies[0][0].kind
        limb = set(Made(sentence.part, 1).kinds) & {"leg", "arm", "tail", "foot", "body"}
        return on.end() if kind not in ("head", "body") or (kind == "head" and limb) else verb.end()

    def _stem(self, sentence: Sentence) -> Copy | None:
        """The stem of a toadstool, where a face is spoken of while it is worked: that is on it, and not on its cap."""
        here = next((p for p in self.parts if p.name == sentence.part and p.single and p.kind == "stem"), None)
        trunk = any(p.single and p.kind in ("head", "body") for p in self.parts)
        return None if here is None or trunk else (here, 1)

    def _on(self, found: list[Mention], low: str) -> Copy | None:
        """The part that a face is on: one that is named after "on", "of", "to", and made once."""
        single = [
            m
            for m in found
            if (len(m.copies) == 1 or m.word in ("foot", "paw", "leg", "arm", "hand"))
            and not _NEAR.search(low[: m.start])
        ]
        return single[-1].copies[0] if single else None

    @staticmethod
    def _region(low: str) -> str:
        """Whether the head or the body of a part that is both is meant."""
        low = _NEAR_HEAD.sub("", low)
        if re.search(r"\b(?:head|face|forehead)\b", low):
            return "head"
        return (
            "body"
            if re.search(
                r"\b(?:body|torso|belly|tummy|stomach|chest|waist|hips?|tunic|shirt|dress|coat|sweater|jacket|vest|apron)\b",
                low,
            )
            else ""
        )
