"""Printed patterns, the colours of yarn: what makers call them → how they are dyed, never as pure as the colours of screens."""

from __future__ import annotations

import re
import unicodedata
from functools import cache, lru_cache
from typing import Final

from tambour.core.rgb import RGB, css_colors
from tambour.crochet.words.table import TERMS

YARNS: Final[dict[str, RGB]] = {
    "amethyst": (140, 98, 170),
    "apricot": (246, 190, 140),
    "aqua": (88, 188, 196),
    "aquamarine": (100, 196, 180),
    "aran": (238, 228, 204),
    "avocado": (122, 138, 62),
    "baby blue": (176, 210, 236),
    "baby pink": (250, 204, 214),
    "beige": (224, 206, 176),
    "berry": (142, 40, 88),
    "black": (28, 28, 30),
    "blue": (48, 86, 160),
    "bluebell": (118, 136, 200),
    "blush": (238, 190, 184),
    "bone": (228, 220, 204),
    "black currant": (70, 40, 78),
    "bone gray": (206, 200, 190),
    "bone grey": (206, 200, 190),
    "brick": (150, 62, 48),
    "bright pink": (240, 80, 150),
    "bright red": (222, 30, 38),
    "bright yellow": (252, 214, 42),
    "brown": (112, 70, 42),
    "buff": (220, 190, 146),
    "burgundy": (116, 28, 48),
    "camel": (186, 144, 96),
    "candy pink": (244, 142, 176),
    "caramel": (186, 122, 62),
    "carrot": (236, 118, 42),
    "charcoal": (62, 62, 66),
    "charcoal gray": (62, 62, 66),
    "charcoal grey": (62, 62, 66),
    "cherry": (178, 28, 46),
    "cherry red": (190, 26, 40),
    "chocolate": (78, 48, 34),
    "claret": (112, 26, 46),
    "clementine": (244, 138, 60),
    "coal": (48, 48, 50),
    "coffee": (84, 58, 44),
    "copper": (184, 110, 74),
    "coral": (238, 126, 104),
    "cornmeal": (244, 222, 150),
    "cream": (245, 235, 210),
    "crimson": (164, 28, 50),
    "cyan": (72, 178, 196),
    "daffodil": (250, 212, 64),
    "dark brown": (84, 54, 32),
    "dark pink": (200, 70, 120),
    "dark purple": (76, 34, 100),
    "dark red": (139, 0, 0),
    "denim": (74, 104, 146),
    "denim blue": (74, 104, 146),
    "dusty pink": (206, 152, 156),
    "ebony": (38, 34, 34),
    "ecru": (236, 224, 200),
    "eggshell": (240, 232, 214),
    "emerald": (24, 128, 84),
    "fern": (98, 138, 72),
    "flamingo": (246, 146, 158),
    "fawn": (194, 156, 116),
    "flesh": (240, 206, 176),
    "forest green": (40, 92, 62),
    "fuchsia": (196, 46, 124),
    "gold": (222, 168, 58),
    "grass": (82, 150, 66),
    "gray": (140, 140, 142),
    "green": (62, 134, 74),
    "grey": (140, 140, 142),
    "heather gray": (166, 166, 168),
    "heather grey": (166, 166, 168),
    "honey": (224, 164, 66),
    "hot pink": (232, 66, 138),
    "hunter green": (34, 78, 58),
    "indigo": (58, 54, 112),
    "iris": (104, 96, 170),
    "ivory": (246, 240, 222),
    "jade": (48, 146, 112),
    "lavender": (188, 170, 214),
    "leaf": (88, 146, 66),
    "leaf green": (88, 146, 66),
    "lemon": (250, 226, 96),
    "lettuce": (150, 196, 90),
    "light brown": (176, 134, 92),
    "light gray": (211, 211, 211),
    "light grey": (211, 211, 211),
    "light orange": (250, 186, 110),
    "light purple": (190, 160, 216),
    "light yellow": (255, 250, 190),
    "lilac": (196, 166, 206),
    "lime": (156, 200, 66),
    "linen": (226, 214, 190),
    "magenta": (184, 44, 116),
    "maize": (246, 206, 110),
    "maroon": (110, 30, 42),
    "mauve": (170, 126, 150),
    "medium brown": (128, 84, 48),
    "mint": (168, 220, 190),
    "mocha": (122, 90, 70),
    "moss": (112, 124, 66),
    "mustard": (208, 160, 48),
    "ochre": (204, 150, 56),
    "natural": (236, 224, 200),
    "navy": (34, 44, 84),
    "oatmeal": (218, 204, 178),
    "off white": (246, 240, 228),
    "offwhite": (246, 240, 228),
    "olive": (116, 118, 60),
    "orange": (232, 122, 48),
    "orchid": (190, 128, 190),
    "paddy green": (30, 124, 70),
    "pale pink": (250, 218, 221),
    "pale yellow": (252, 244, 180),
    "peach": (250, 205, 170),
    "perfect pink": (240, 130, 166),
    "periwinkle": (140, 146, 208),
    "petal pink": (246, 190, 202),
    "petrol": (20, 92, 104),
    "pewter": (128, 128, 130),
    "pink": (240, 160, 184),
    "pistachio": (186, 208, 150),
    "platinum": (204, 204, 202),
    "plum": (96, 48, 88),
    "pumpkin": (224, 112, 36),
    "purple": (112, 64, 140),
    "raspberry": (188, 42, 92),
    "red": (190, 38, 44),
    "rosa": (240, 160, 184),
    "rose": (226, 136, 150),
    "rose pink": (232, 142, 164),
    "royal blue": (42, 72, 156),
    "rust": (176, 82, 42),
    "sage": (156, 175, 136),
    "salmon": (240, 150, 130),
    "sand": (214, 190, 150),
    "seafoam": (150, 212, 188),
    "shocking pink": (240, 68, 140),
    "silver": (190, 192, 194),
    "skin": (240, 206, 176),
    "skipper blue": (36, 66, 138),
    "sky": (140, 190, 224),
    "sky blue": (140, 190, 224),
    "slate": (96, 108, 120),
    "soft white": (250, 246, 234),
    "spring green": (168, 206, 92),
    "straw": (232, 210, 150),
    "strawberry": (226, 88, 104),
    "sunflower": (244, 186, 44),
    "taffy": (244, 160, 190),
    "tan": (206, 172, 128),
    "tangerine": (242, 132, 46),
    "taupe": (146, 128, 114),
    "teal": (24, 112, 118),
    "terracotta": (190, 96, 66),
    "thyme": (126, 146, 120),
    "toffee": (168, 112, 64),
    "turqua": (52, 170, 178),
    "turquoise": (52, 170, 178),
    "violet": (138, 96, 170),
    "white": (250, 249, 245),
    "wine": (116, 28, 48),
    "anthracite": (62, 64, 70),
    "apple green": (150, 190, 80),
    "aubergine": (74, 40, 66),
    "bottle green": (26, 78, 58),
    "brick red": (158, 66, 54),
    "burnt orange": (198, 92, 40),
    "chestnut": (112, 66, 44),
    "chestnut brown": (112, 66, 44),
    "chocolate brown": (84, 54, 42),
    "dove grey": (186, 188, 190),
    "ginger": (196, 110, 54),
    "graphite": (82, 86, 92),
    "hazelnut": (160, 114, 78),
    "ice blue": (206, 228, 238),
    "jeans": (84, 112, 150),
    "lemon yellow": (250, 228, 96),
    "mustard yellow": (212, 160, 52),
    "straw yellow": (236, 214, 130),
    "toast brown": (160, 110, 66),
    "nude": (236, 200, 172),
    "old rose": (196, 138, 140),
    "powder pink": (240, 206, 208),
    "salmon pink": (244, 160, 146),
    "silver grey": (196, 200, 204),
    "walnut": (104, 76, 56),
    "wine red": (116, 28, 48),
    "yellow": (244, 208, 72),
    "cornflower blue": (110, 142, 206),
    "khaki": (166, 154, 108),
    "midnight blue": (32, 40, 78),
    "powder blue": (176, 204, 226),
    "slate blue": (96, 114, 146),
    "amber": (206, 138, 44),
    "army green": (92, 98, 62),
    "ash": (178, 178, 174),
    "airforce blue": (92, 122, 156),
    "ballet pink": (244, 212, 214),
    "biscuit": (214, 182, 140),
    "bubblegum": (244, 150, 186),
    "butter": (248, 228, 158),
    "buttercup": (248, 214, 96),
    "buttermilk": (250, 238, 196),
    "candyfloss": (246, 178, 204),
    "cinnamon": (168, 94, 56),
    "clay": (182, 114, 86),
    "cobalt": (38, 70, 150),
    "cocoa": (112, 76, 58),
    "cornflower": (110, 142, 206),
    "cranberry": (152, 30, 56),
    "duck egg": (184, 214, 208),
    "duck egg blue": (180, 212, 212),
    "dusty blue": (132, 156, 180),
    "dusty rose": (202, 150, 152),
    "eggplant": (74, 40, 66),
    "espresso": (66, 46, 38),
    "eucalyptus": (150, 176, 160),
    "fig": (92, 58, 78),
    "fog": (204, 208, 210),
    "french blue": (70, 106, 160),
    "garnet": (122, 28, 46),
    "glacier": (200, 220, 228),
    "grape": (104, 62, 128),
    "ink": (40, 50, 78),
    "ivy": (58, 98, 66),
    "lagoon": (44, 142, 156),
    "latte": (176, 140, 108),
    "marigold": (240, 168, 44),
    "midnight": (28, 34, 62),
    "mist": (206, 216, 220),
    "mulberry": (122, 42, 84),
    "mushroom": (184, 168, 150),
    "navy blue": (34, 44, 84),
    "nutmeg": (140, 90, 58),
    "oxblood": (92, 24, 32),
    "parchment": (238, 226, 200),
    "peacock": (18, 106, 122),
    "pear": (196, 204, 110),
    "pebble": (182, 176, 166),
    "petal": (246, 204, 208),
    "pine": (40, 88, 62),
    "rosewood": (150, 84, 84),
    "ruby": (164, 24, 56),
    "saffron": (240, 178, 58),
    "scarlet": (204, 34, 36),
    "shell pink": (248, 220, 212),
    "smoke": (156, 160, 166),
    "snow": (250, 250, 250),
    "spruce": (48, 96, 86),
    "stone": (184, 176, 162),
    "storm": (104, 112, 122),
    "stormy grey": (116, 122, 130),
    "sunshine": (250, 214, 80),
    "tea rose": (232, 170, 164),
    "tomato red": (206, 52, 40),
    "vanilla": (246, 234, 204),
    "watermelon": (236, 90, 104),
    "wisteria": (172, 158, 210),
}
"""Names of yarn → sRGB, by eye from shade cards."""

_DYED: Final[dict[str, RGB]] = {
    "adobe": (190, 104, 82), "aruba": (64, 178, 184), "atom": (206, 40, 44), "blackbird": (40, 40, 46),
    "blueberry": (70, 88, 148), "bluie": (96, 150, 206), "cafe": (180, 144, 108), "cloud": (236, 238, 242),
    "cotton": (250, 236, 236), "cub": (150, 106, 70), "dolphin": (138, 150, 164), "driftwood": (202, 186, 164),
    "elephant": (146, 148, 152), "fox": (206, 104, 48), "frosty": (206, 226, 230),
    "glowworm": (190, 210, 84), "golden": (232, 184, 70), "lamb": (244, 236, 220),
    "landshark": (120, 130, 142), "leafy": (98, 146, 74), "lily": (246, 240, 226),
    "misty": (196, 202, 206), "mossy": (112, 120, 70), "mouse": (150, 148, 146), "overcast": (152, 160, 168),
    "polar": (242, 245, 246), "potpourri": (214, 150, 164), "shrimp": (244, 152, 124),

    "sunsoaked": (240, 212, 130), "teddy": (156, 110, 70),
    "tickle": (150, 210, 196), "velveteal": (20, 108, 118), "whitey": (250, 249, 245),
    "wood": (150, 112, 76), "llama": (232, 214, 184), "monkey": (124, 84, 56), "cactus": (92, 150, 84), "koala": (150, 150, 156),
    "owl": (150, 116, 84), "robot": (160, 166, 172), "dragon": (92, 160, 110), "unicorn": (248, 246, 240),
    "sprout": (150, 190, 90), "peachie": (250, 190, 160), "sunny": (250, 216, 92), "shell": (246, 226, 206), "sushi": (250, 249, 245),
    "robin": (140, 206, 206), "ficus": (76, 120, 76), "ladybug": (200, 40, 44),
    "aquatic": (62, 140, 160), "melon": (246, 150, 120), "jam": (140, 40, 70),
    "dogwood": (222, 150, 160), "capri": (70, 176, 190), "daisy": (244, 206, 70),
}  # fmt: skip
"""Words of shade cards that name no colour elsewhere."""
_PALE: Final = frozenset(("mist", "misty", "frosty", "faded", "quiet", "dust", "whisper"))

_THINGS: Final = frozenset(
    (
        "amber amethyst aran ash avocado berry biscuit bluebell blush bone brick buff butter buttercup buttermilk candyfloss "
        "carrot cherry cinnamon clay clementine coal cocoa coffee cornmeal cranberry daffodil duck eggshell emerald eucalyptus "
        "fawn fig flamingo fog garnet glacier grape grass honey ink iris ivy jade lagoon latte leaf lemon lettuce linen "
        "maize marigold midnight mist mocha moss mulberry mushroom nutmeg oatmeal parchment peacock pear pebble petal pewter "
        "pine pistachio platinum pumpkin raspberry rosewood ruby saffron sand shell sky slate smoke spruce stone storm straw "
        "strawberry sunflower sunshine taffy tangerine thyme toffee vanilla watermelon wisteria"
    ).split()
)
"""Colours in a list of yarns; in other sentences the things themselves."""

_LIGHTER: Final = {"light": 0.4, "lt": 0.4, "pale": 0.5, "soft": 0.35, "baby": 0.5, "pastel": 0.5}
_DARKER: Final = {"dark": 0.35, "dk": 0.35, "deep": 0.3, "bright": 0.0, "hot": 0.0, "medium": 0.0, "med": 0.0, "mid": 0.0, "country": 0.1,
                  "warm": 0.0, "golden": 0.0, "real": 0.0, "heather": 0.0, "weathered": 0.15, "dusky": 0.1, "vivid": 0.0, "classic": 0.0, "true": 0.0}  # fmt: skip

_MUTED: Final = frozenset(("dusty", "antique", "vintage", "muted", "smoky"))
_DUST: Final = 205.0  # how light the dust on a colour is
_SAID: Final = frozenset((*_LIGHTER, *_DARKER, *_MUTED))
"""Words before a colour that make another of it."""
_PLAIN_HUES: Final = frozenset("red orange yellow green blue purple pink brown grey gray white black violet".split())
"""Words that only say what kind of colour the one before them is: "sage green", "mustard yellow"."""

# "Contrast A Pewter (1401)", "Main Color (MC) Teal", "Contrast A: (01612 Country Yellow)"; "0512 Turqua A, 0672 Spring Green B"
_NAME: Final = r"((?:[A-Z][A-Za-zé’'&]*[ -]?){1,4}?|[A-Z][a-z]+ [a-z]+)"
_NUMBER: Final = r"(?:\(?#?\d{3,6}\)?[\s,]*\(?\s*)?"
_LED: Final = re.compile(
    r"\b(?:(?i:main colou?r|contrast|colou?r))\s*\(?(MC|C[A-E]|mc|cc|[A-Ka-k])(?![A-Za-z])\)?[\s:,]*\(?"
    + _NUMBER
    + _NAME
    + r"\s*(?=[(),.;\d]|$)"
)
_ENDED: Final = re.compile(r"(?<![\w./])#?\d{2,6}\s+" + _NAME + r"\s*\(?\b(MC|C[A-E]|[A-K])\b\)?(?=[\s,.;)]|$)")
_AS: Final = re.compile(r"(?:^|[,:.]|\band)\s*" + _NAME + r"\s+as\s+(MC|C[A-E]|[A-K])\b")
# "Dark Dogwood (8820) 3 balls", "1 ball 9872 Llama": one yarn, and no letter
_ALONE: Final = re.compile(
    r"(?:^|[)™®\]]\s*)"
    + _NAME
    + r"\s*\(\d{3,6}\)\s*(?:\d|$|or\b)|\b(?:balls?|skeins?)\s+(?:of\s+)?\d{3,5}\s+"
    + _NAME
    + r"\s*(?=[(,.;]|$)"
)


_LETTERED: Final = re.compile(r"((?:[A-Za-z][\w’'é-]*[ ]){0,3}[A-Za-z][\w’'é-]*)\s*\((MC|C[A-E]|[A-K])\)")
"""Words that may end with a colour, before its letter: "DK cotton in red (A), cream (B) and a little white (C)"."""
_PLAIN: Final = re.compile(
    r"\b[Cc]olou?r\s+(MC|C[A-E]|[A-K])\b[\s:=–-]*([a-z][a-z -]{2,24}?)[ \t]*(?=[(),.;\d]|$)", re.MULTILINE
)
"""A letter before its colour in small letters: "Color A: black"."""
_BRACKETED: Final = re.compile(r"\b(MC|C[A-E]|[A-K])\s*\(([A-Za-z][A-Za-z -]{2,20})\)")


def _lettered(line: str) -> dict[str, str]:
    """The letters that stand in brackets behind colours, whatever else their words say."""
    found: dict[str, str] = {}
    for m in _LETTERED.finditer(line):
        words = m[1].split()
        at = next((k for k in range(len(words) - 1, -1, -1) if dyed(" ".join(words[k:])) is not None), None)
        while at and (
            shade(" ".join(words[at - 1 :])) is not None or (words[at][0].isupper() and words[at - 1][0].isupper())
        ):
            at -= 1  # "Navy Blue"
        if at is not None:
            found.setdefault(m[2].lower(), " ".join(words[at:]))
    for m in (*_BRACKETED.finditer(line), *_PLAIN.finditer(line)):
        if shade(m[2]) is not None:
            found.setdefault(m[1].lower(), m[2].strip())
    return found


YARN: Final = re.compile(r"\b(?:yarn|cotton|wool|acrylic|dk|worsted|aran|balls?|skeins?|\d+\s?g)\b", re.IGNORECASE)
NO_YARN: Final = re.compile(
    r"\b(?:stuffing|fib(?:er|re)fill|eyes?|felt|floss|thread|buttons?|hook|needle)\b", re.IGNORECASE
)
_SEVERAL: Final = re.compile(
    r"(?::|\bin|\bcolou?rs?)[ \t]+([A-Za-z][A-Za-z’' -]{2,30}?)[ \t]*(?:\([^)\n]*\)[ \t]*)?(?=,|;|\band\b|&)"
)


_LISTED: Final = re.compile(
    r"^[ \t•*–-]*(?:(?:[Yy]arn|[Cc]olou?r)[ \t]+)?(MC|CC|C[A-E]|[A-K])[ \t]*(?:[:=]|[-–—](?=[ \t]))[ \t]*(\S[^\n]{0,90})$",
    re.MULTILINE,
)
"""A line of a list that begins with a yarn's letter: "A: Mill's Soft Cotton, Old Rose (408), 2 balls"."""
_AMOUNT: Final = re.compile(
    r"^(?:(?:\d+ ?(?:g|m|yds?|yards|balls?|skeins?)|an? (?:little|bit|few \w+)|small amounts?|some|scraps?) )(?:of )?",
    re.IGNORECASE,
)
MILLS: Final = frozenset(("red heart",))
"""Mills whose names are colours."""


def _itemised(line: str) -> dict[str, str]:
    """The letters that begin the lines of a list: the colour is the last that a line names between its signs, behind the mill's name."""
    found: dict[str, str] = {}
    for m in _LISTED.finditer(line):
        said = [_AMOUNT.sub("", one.strip()) for one in re.split(r"[,;:()/]|\s[-–—]\s", m[2])]
        hues = [one for one in said if one and one.lower() not in MILLS and dyed(one) is not None]
        if hues and not NO_YARN.search(m[2]):
            found.setdefault(m[1].lower(), hues[-1])
    return found


def listed(line: str) -> dict[str, str]:
    """The letters that a list of materials gives to yarns → the names of their colours; "" for a yarn without a letter."""
    return dict(_listed(line))


@lru_cache(maxsize=256)
def _listed(line: str) -> dict[str, str]:
    found = {m[1].lower(): m[2].strip() for m in _LED.finditer(line) if m[2].strip().lower() not in MILLS}
    found = {**_itemised(line), **found}
    found = {**{m[2].lower(): m[1].strip() for pattern in (_AS, _ENDED) for m in pattern.finditer(line)}, **found}
    found = {**_lettered(line), **found} if ")" in line or "olo" in line else found
    alone = _ALONE.search(line)
    if not found and alone is None and (first := _first(line)) is not None:
        return {"": first}
    return found if found or alone is None else {"": (alone[1] or alone[2]).strip()}


def _first(line: str) -> str | None:
    """The first of several colours that a line names of one yarn: "Catona (cotton, 50 g): Light Grey (1 ball), Pink, White"."""
    for item in line.split("\n"):
        if YARN.search(item) and not NO_YARN.search(item):
            names = (m[1].strip() for m in _SEVERAL.finditer(item))
            names = (name for name in names if name.lower() not in MILLS)
            if found := next((name for name in names if len(name.split()[0]) > 1 and dyed(name) is not None), None):
                return found
    return None


def dyed(name: str) -> RGB | None:
    """The colour of a yarn in a list of materials, by any word of its name that tells one: "Grey Heather", "French Rose".

    In other sentences such words may mean the things themselves; None where no word tells a colour.
    """
    plain = "".join(c for c in unicodedata.normalize("NFKD", name.lower()) if not unicodedata.combining(c))
    words = [w.removesuffix("'s").removesuffix("’s") for w in plain.replace("-", " ").split()]
    if (found := shade(" ".join(words))) is not None:
        return found
    for long in range(len(words), 0, -1):
        for at in range(len(words) - long, -1, -1):
            part = words[at : at + long]
            hue = shade(" ".join(part)) or (_DYED.get(part[0]) if long == 1 else None)
            if hue is not None:
                pale = 0.35 if (set(words) - set(part)) & _PALE else 0.0
                red, green, blue = (round(c + (255 - c) * pale) for c in hue)
                return red, green, blue
    return None


def said(name: str) -> RGB | None:
    """The colour of yarn that ``name`` means in any sentence; None where it means none, or may mean a thing."""
    return None if name in _THINGS else shade(name)


@cache
def spoken(code: str) -> dict[str, RGB]:
    """What the words for colours mean in a pattern by people, the first word for each colour before the others: yarns, not lights."""
    terms = TERMS[code]
    english = YARNS if terms.colors["blue"][0] == "blue" else {}
    heard = {w: shade(name) for name, words in terms.heard.colors.items() for w in words}
    made = heard | {
        w.lower(): english.get(w.lower()) or shade(css) for css, words in terms.colors.items() for w in words
    }
    return {word: hue for word, hue in {**english, **made}.items() if hue is not None}


def shade(name: str) -> RGB | None:
    """The colour of a yarn of this name; None where no colour is known by it."""
    words = name.lower().replace("-", " ").split()
    whole = " ".join(words)
    if whole in YARNS:
        return YARNS[whole]
    mixed = len(words) > 1 and words[0] in _SAID and shade(" ".join(words[1:])) is not None
    if not mixed and whole.replace(" ", "") in css_colors():
        return css_colors()[whole.replace(" ", "")]
    if len(words) > 1 and words[0] not in _SAID | _PLAIN_HUES and words[-1] in _PLAIN_HUES:
        return shade(" ".join(words[:-1]))
    if len(words) < 2 or words[0] not in _SAID:
        return None
    base = shade(" ".join(words[1:]))
    if base is None:
        return None
    if words[0] in _MUTED:
        gray = sum(base) / 3
        red, green, blue = (round(0.7 * (0.6 * c + 0.4 * gray) + 0.3 * _DUST) for c in base)
        return red, green, blue
    white, black = _LIGHTER.get(words[0], 0.0), _DARKER.get(words[0], 0.0)
    red, green, blue = (round((c + (255 - c) * white) * (1 - black)) for c in base)
    return red, green, blue
