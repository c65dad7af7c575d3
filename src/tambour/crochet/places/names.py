"""Names: which parts a sentence means ("the body" is BELLY AND BODY), and what kind of thing a part is by its name."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Final

from tambour.crochet.words.gloss import folded, nouns

# Kind → words that name it, singular, English first; then Spanish, German, French, Dutch.
_KINDS: Final[dict[str, str]] = {
    "head": "head skull noggin kopf cabeza tête tete hoofd",
    "body": "body torso tummybody körper koerper rumpf cuerpo corps lijf lichaam",
    "ear": "ear eartuft ohr oreja oreille oor",
    "face": "face gesicht cara visage gezicht",
    "eye": "eye eyeball pupil iris eyelid eyepatch auge ojo oeil œil oog",
    "muzzle": "muzzle snout trunk mouth schnauze hocico museau snuit",
    "nose": "nose nase nariz nez neus proboscis",
    "beak": "beak bill schnabel pico bec snavel",
    "cheek": "cheek eyebrow brow",
    "beard": "beard mustache moustache wattle",
    "arm": "arm hand armflipper glove mitten brazo bras",
    "claw": "claw pincer",
    "branch": "branch",
    "leg": "leg bein pierna jambe been hindleg foreleg thigh pant",
    "foot": "foot shoe boot bootie sandal slipper paw hoof fuß fuss pie pied voet pata patte poot",
    "tail": "tail schwanz cola queue staart",
    "fluke": "fluke",
    "wing": "wing flügel ala aile vleugel",
    "fin": "fin flipper flosse aleta nageoire vin",
    "horn": "horn antler antenna antennae antennaes feeler ossicone tusk cuerno corne hoorn",
    "hat": "hat cap beanie helmet crown bonnet roof slope lid mütze dach gorro sombrero chapeau bonnet hoed dak hair wig hood fleece",
    "tuft": "mane bang fringe curl pigtail ponytail topknot tuft pompom comb crest bun bobble forelock",
    "stem": "stem stalk stiel tallo tige steel twig chimney wall tower",
    "leaf": "leaf petal sepal blatt hoja feuille blad calyx frond",
    "bow": "bow flower rose heart star button ribbon schleife blume lazo flor",
    "spike": "spike spine scale plate dorsal",
    "belly": "belly stomach tummy chest bib bauch barriga ventre buik",
    "spot": "spot dot patch stripe",
    "collar": "collar ruff bowtie",
    "shell": "shell backpack carapace hump",
    "wheel": "wheel tire tyre",
    "bumper": "bumper grill grille fender",
    "lamp": "headlight lamp light taillight",
    "door": "door window porthole pocket windshield windscreen",
    "tentacle": "tentacle tentacles",
    "neck": "neck",
    "base": "base bottom sole lawn grass ground meadow",
    "inner": "inner",
    "tooth": "tooth fang tongue",
    "handle": "handle spout",
    "fender": "fender mudguard",
    "worn": "dress nightgown gown necktie skirt sweater cape coat bodice shirt tunic robe apron jacket vest cardigan undershirt overall dungaree jumper "
    "trouser short legging jean knicker diaper tutu swimsuit romper pajama bandana necklace headband tiara bag purse basket blanket "
    "strap lace tie gusset scarf belt sleeve emblem bracelet armband band glasses edging trim ruffle garland wreath clothe saddle bridle",
}
KINDS: Final[dict[str, str]] = {word: kind for kind, words in _KINDS.items() for word in words.split()}
"""Word → kind."""
_VESSELS: Final = frozenset(
    "bag purse basket cup teacup mug bowl pail bucket pot flowerpot planter vase saucer plate dish tray box tasche beutel korb tasse schale "
    "eimer topf teller bolsa bolso cesta taza cuenco cubo maceta plato sac panier tasse bol seau pot assiette tas mand kop kom emmer bord".split()
)
"""Words of things that stand with their opening upwards."""
_HAIR: Final = frozenset("hair wig fleece haar perücke pelo peluca cheveux perruque pruik".split())
_SHOES: Final = frozenset(
    "shoe boot bootie sandal slipper schuh stiefel zapato bota chaussure botte schoen laars".split()
)
_TROUSERS: Final = frozenset("pant trouser hose pantalón pantalon broek".split())
_HANDS: Final = frozenset("hand glove mitten handschuh fäustling mano guante main gant want".split())
_HALVES: Final = frozenset("half hälfte mitad moitié helft".split())
LIKE: Final = (
    {"fluke", "tail"},
    {"fin", "arm", "wing"},
    {"muzzle", "nose", "beak"},
    {"leg", "foot"},
    {"hat", "tuft"},
    {"face", "head"},
    {"claw", "arm"},
    {"spot", "door"},
)
"""Kinds that one word may mean for another, where no part has the word itself."""
_ODD: Final = {
    "feet": "foot", "leaves": "leaf", "antennae": "antenna", "teeth": "tooth", "halves": "half", "hooves": "hoof",
    "pieces": "piece", "eyes": "eye", "nose": "nose", "noses": "nose", "bodies": "body", "tummies": "tummy",
    "shoes": "shoe", "toes": "toe", "bras": "bras",
    "scarves": "scarf", "loaves": "loaf",
}  # fmt: skip
_FILLER: Final = frozenset(("the", "a", "an", "and", "of", "for", "with", "each", "both", "&"))
_OF: Final = frozenset(("of", "on", "for", "from", "at"))
_WITH: Final = frozenset("with mit avec con met".split())
_TRUNK: Final = frozenset(("head", "body", "neck", "leg"))
_WORD: Final = re.compile(r"[^\W\d_]+(?:['’]s)?|\d+")
_SECOND: Final = frozenset(("right", "second", "other", "2nd"))
_FIRST: Final = frozenset(("left", "first", "one", "1st"))
SIDED: Final = _FIRST | _SECOND
"""Words that tell the two of a pair apart."""
_NAMELESS: Final = re.compile(r"(?:part|piece)(?:_\d+)?$")
"""What parts are called that no heading names."""
_YARN: Final = frozenset(
    ("long", "yarn", "beg", "beginning", "leaving", "using", "rem", "remaining", "with", "ending", "ch", "chain")
)
"""Words before the tail of yarn."""
_EACH: Final = frozenset(("each", "either", "every", "both"))


@dataclass(frozen=True)
class Made:
    """A part that is there to be sewn: its name, its copies, and what it is by its shape where its name does not say it, or says it wrongly.

    halved : its two copies are the halves of one thing; alone : it stands by itself, as no body is there that could wear it
    """

    name: str
    copies: int
    likely: str = ""
    halved: bool = False
    alone: bool = False

    @property
    def single(self) -> bool:
        """Whether a toy has one of it."""
        return self.copies == 1 or self.halved

    @cached_property
    def words(self) -> list[str]:
        """The words of its name, singular, without small ones and numbers."""
        return list(_words(self.name))

    @cached_property
    def noun(self) -> int:
        """Behind which of its words its noun ends: "Back of head" is a back."""
        words = [one(w) for w in _WORD.findall(self.name.lower().replace("_", " "))]
        cut = next((k for k, w in enumerate(words) if k and w in _OF), len(words))
        return len([w for w in words[:cut] if w not in _FILLER and not w.isdigit()])

    @cached_property
    def kinds(self) -> list[str]:
        """What its name says that it is, the last noun first; "top of head" is no head."""
        words = [one(w) for w in _WORD.findall(self.name.lower().replace("_", " "))]
        words = words[: next((k for k, w in enumerate(words) if k and w in _OF), None)]
        cut = next((k for k, w in enumerate(words) if k and w in _WITH), len(words))
        if {kind_of(w) for w in words[:cut]} - {""} and not {kind_of(w) for w in words[cut:]} & _TRUNK:
            words = words[:cut]  # a head with a trunk is a head
        return list(dict.fromkeys(kind_of(w) for w in reversed(words) if kind_of(w)))

    @cached_property
    def kind(self) -> str:
        """What it is by its name; "" unknown. Of several joined by "and" a body or a head, else the last noun."""
        found = self.kinds
        if self.likely or not found:
            return self.likely
        if self.copies == 1 and self.vessel:
            return ""  # a plate to eat from is no dragon's
        if found[0] == "worn" and "bow" in found:
            return "bow"
        if {"arm", "leg"} <= set(found):
            return "arm"
        if found[0] == "spot" and "eye" in found:
            return "eye"  # patches about the eyes
        if "beard" in found and "hat" in found:
            return "beard"  # with the hair beside it
        if found[:2] == ["tuft", "ear"]:
            return "ear"  # an owl's
        joined = set(found) <= {"head", "body", "neck", "leg"} or re.search(r"\band\b|&", self.name.lower())
        return next((k for k in ("body", "head") if joined and k in found), found[0])

    @property
    def worn(self) -> bool:
        """Whether it is put on a toy, and not sewn to make it."""
        cuffed = self.words[-1:] == ["cuff"] and len(self.words) > 1 and not self.kinds  # of breeches, not of a cone
        worn = (cuffed or "worn" in self.kinds) and not self.likely and self.kind != "bow"
        return self.likely == "worn" or (worn and not self.alone)

    @property
    def vessel(self) -> bool:
        """Whether it holds something, by the last word of its name, and stands with its opening upwards."""
        return bool(self.words) and self.words[-1] in _VESSELS

    @property
    def hair(self) -> bool:
        """Whether it is hair, and no hat, though either lies on a head."""
        return bool(_HAIR & set(self.words))

    @property
    def shod(self) -> bool:
        """Whether it is a shoe, by the last word of its name."""
        return bool(self.words) and self.words[-1] in _SHOES

    @property
    def clad(self) -> bool:
        """Whether its name speaks of trousers: what is called a leg is one of theirs."""
        return bool(_TROUSERS & set(self.words))

    @property
    def tipped(self) -> bool:
        """Whether it is a hand, which an arm may end in, by the last word of its name."""
        return bool(self.words) and self.words[-1] in _HANDS

    @property
    def half(self) -> bool:
        """Whether two of it make one thing."""
        return bool(_HALVES & set(self.words))

    def copy(self, k: int) -> str:
        """The name of its k-th copy, from 1."""
        return self.name if self.copies == 1 else f"{self.name}.{k}"


@lru_cache(maxsize=4096)
def one(word: str) -> str:
    """A word as its singular, roughly."""
    word = re.sub(r"['’]s$", "", word)
    if word in _ODD:
        return _ODD[word]
    if len(word) > 4 and word.endswith("ies"):
        return word[:-3] + "y"
    if len(word) > 4 and re.search(r"(?:x|ch|sh|ss)es$", word):
        return word[:-2]
    return word[:-1] if len(word) > 3 and word.endswith("s") and not word.endswith(("ss", "us")) else word


@lru_cache(maxsize=1024)
def _words(name: str) -> tuple[str, ...]:
    """The words of a part's name, singular, without small ones and numbers."""
    found = [one(w) for w in _WORD.findall(name.lower().replace("_", " "))]
    return tuple(w for w in found if w not in _FILLER and not w.isdigit())


@lru_cache(maxsize=4096)
def kind_of(word: str) -> str:
    """The kind that a word (singular) names; compounds by their end ("hindleg", "Hinterbein"); "" for none."""
    if word in KINDS:
        return KINDS[word]
    known, plain = nouns(), folded(word)
    if (said := one(known.get(plain) or known.get(f"{plain}s", ""))) in KINDS:
        return KINDS[said]  # "corps" loses its end where it is taken for a plural
    found = [k for k in KINDS if len(k) >= 3 and len(word) > len(k) + 2 and word.endswith(k)]
    return KINDS[max(found, key=len)] if found else ""


@dataclass(frozen=True)
class Mention:
    """Parts that a sentence names at a place of its text, with the copies that are meant.

    copies : (part, copy from 1) in order; word : the noun that names them; plural : more than one may be meant
    """

    start: int
    end: int
    word: str
    copies: tuple[tuple[Made, int], ...]
    plural: bool


def mentions(text: str, parts: list[Made]) -> list[Mention]:
    """The parts that ``text`` (in small letters) names, in order, none overlapping."""
    words = [(m.start(), m.end(), m[0], one(m[0])) for m in _WORD.finditer(text)]
    found: list[Mention] = []
    at = 0
    while at < len(words):
        n, hit = _best(words, at, parts)
        if not hit or (words[at][3] == "tail" and at and words[at - 1][2] in _YARN):
            at += 1
            continue
        found.append(_mention(words, at, n, hit))
        at += n
    meant = {c for m in found if _named(m) for c in m.copies}
    return [m for m in found if _named(m) or not meant & set(m.copies)]


def its_own(mention: Mention, part: str) -> Mention:
    """What is meant where ``part`` is worked: "the handle" is that one, and not that of another cup."""
    if mention.plural or any(p.kind != "handle" for p, _ in mention.copies):
        return mention
    own = tuple(c for c in mention.copies if c[0].name == part)
    return replace(mention, copies=own) if own else mention


def _named(m: Mention) -> bool:
    """Whether a word names a part itself: a curl on a cap is not the cap, where both are spoken of."""
    kind = kind_of(m.word)
    return not kind or any(kind in p.kinds or kind == p.likely or m.word in p.words for p, _ in m.copies)


def _best(words: list[tuple[int, int, str, str]], at: int, parts: list[Made]) -> tuple[int, list[Made]]:
    """How many words from ``at`` on name parts, and which: the longest run of a name's words that holds its noun."""
    best, hit = 0, list[Made]()
    for part in parts:
        name = part.words
        if words[at][3] not in name or _NAMELESS.match(part.name):
            continue
        for begin in (k for k, word in enumerate(name) if word == words[at][3]):
            n = 0
            i = at
            while i < len(words) and begin + n < len(name) and (
                words[i][3] == name[begin + n] or (n and words[i][2] in _FILLER)
            ):  # fmt: skip
                n += words[i][3] == name[begin + n]
                i += 1
            while i > at and words[i - 1][2] in _FILLER:
                i -= 1
            noun = any(kind_of(w) not in ("", "inner") for w in name[begin : begin + n]) or begin + n in (
                len(name),
                part.noun,
            )
            if n == 1 and name[begin] in ("centre", "center", "middle") and len(name) > 1:
                continue  # "at the centre back" is no "Bow centre"
            if noun and begin + n > part.noun and _elsewhere(name[max(begin, part.noun) : begin + n], part, parts):
                continue  # "the top of the head" is no "fleece on top of head" where there is a head
            if n and noun:
                if i - at > best:
                    best, hit = i - at, [part]
                elif i - at == best and part not in hit:
                    hit.append(part)
    whole = [p for p in hit if p.words == [w[3] for w in words[at : at + best] if w[2] not in _FILLER]]
    if whole:
        hit = whole
    said = [w[3] for w in words[at : at + best] if w[2] not in _FILLER]
    ending = [p for p in hit if p.words[-len(said) :] == said]
    if ending and said[-1] == words[at + best - 1][2]:
        hit = ending  # "the cap" is the mushroom's cap, and not its spots
    if hit:
        plain = [p for p in hit if "inner" not in p.words]
        return best, plain if plain and words[at][3] != "inner" else hit
    word = words[at][3]
    kind = kind_of(word)
    if not kind or words[at][2] == "short":  # "3 short stitches" are no shorts
        return 0, []
    alike = [p for p in parts if kind in p.kinds or kind == p.likely]
    if not alike:
        alike = [p for p in parts for group in LIKE if kind in group and set(p.kinds) & group]
    return (1, alike) if alike else (0, [])


def _elsewhere(said: list[str], part: Made, parts: list[Made]) -> bool:
    """Whether words behind a part's noun name another part."""
    kinds = {kind_of(w) for w in said} - {"", "inner"}
    return any(p is not part and kinds & set(p.kinds) for p in parts)


def _mention(words: list[tuple[int, int, str, str]], at: int, n: int, hit: list[Made]) -> Mention:
    last = words[at + n - 1]
    plural = last[2] != last[3] or last[2] in ("antennae", "feet")
    before = {w[2] for w in words[max(0, at - 3) : at]}
    if len(hit) > 1 and not plural:
        near = {w[3] for w in words[max(0, at - 2) : at + n + 1]}
        closer = [p for p in hit if set(p.words) & (near - {last[3]})]
        hit = closer or hit
    copies = [(p, k) for p in hit for k in range(1, p.copies + 1)]
    if len(hit) == 1 and hit[0].copies == 4:
        # Of four the first two are arms, or front legs.
        both = {"arm", "leg"} <= set(hit[0].kinds) and kind_of(last[3]) in ("arm", "leg")
        low = kind_of(last[3]) == "arm" if both else bool(before & {"front", "fore"})
        if (both and not {"arm", "leg"} <= {kind_of(w[3]) for w in words[at : at + n]}) or (
            kind_of(last[3]) in ("leg", "foot") and before & {"front", "fore", "back", "hind", "rear"}
        ):
            copies = copies[:2] if low else copies[2:]
    after = {w[2] for w in words[at + n : at + n + 5]}
    if not plural and len(copies) > 1 and len(hit) == 1 and before & (_FIRST | _SECOND) and not after & _EACH:
        k = 2 if before & _SECOND else 1
        copies = [(hit[0], k)]
    number = words[at + n][2] if at + n < len(words) else ""
    if number.isdigit() and len(hit) == 1 and 1 <= int(number) <= hit[0].copies and not plural:
        return Mention(words[at][0], words[at + n][1], last[3], ((hit[0], int(number)),), False)
    return Mention(words[at][0], last[1], last[3], tuple(copies), plural)
