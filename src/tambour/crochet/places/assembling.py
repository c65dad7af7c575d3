"""Assembling: whether a sentence puts parts or a face somewhere."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.places import face
from tambour.crochet.places.hairdo import COMBED, is_hair
from tambour.crochet.places.names import Made, kind_of, one
from tambour.crochet.places.said import VERB, where

EYES: Final = re.compile(r"\b(?:safety|plastic|toy|button|googly|bead|doll)?\s*(?:eyes?|beads for eyes)\b")
EYED: Final = re.compile(
    r"\b(?:insert\w*|place[ds]?|placing|attach(?:ed)?|add(?:ed)?|put|position(?:ed|ing)?|secure|fix|sew|glue|install|push|mount|use|pin|make|set|"
    r"go|goes|sit|sits|belong|pop(?:ped)?|snap(?:ped)?|fit(?:ted)?|press|screw|slot|clip)\b"
)
DRAWN: Final = re.compile(
    r"\b(?:embroider\w*|stitch(?:ed)?|sew|backstitch|satin|straight st\w*|make|create|draw|add|french knots?|whiskers|apply)\b"
)
CLOSING: Final = re.compile(r"\b(?:closed|shut|tog|together|in half|seams?|opening|flat)\b")
"""A sentence that closes a part, and puts it nowhere."""
SHUT_AT: Final = re.compile(
    r"\b(?:closed|shut)\s+(?:flat\s+)?(?:at|along|across|on|after)\s+(?:the\s+)?(?:\d|last|final|rounds?|rnds?|rows?)"
)
"""The round at which a part's own end is closed: "sew the end of the tail closed at the 7th rnd"."""
ALL: Final = re.compile(
    r"\b(?:sew|attach|assemble|stitch|join|put)\s+(?:on\s+)?(?:everything|all (?:of )?(?:the |your )?(?:pieces|parts|limbs|bits)|the (?:pieces|parts)|(?:pieces|parts)|all together)\b"
)
_STITCHES: Final = re.compile(r"\b(?:sc|hdc|dc|sl st|ch \d+|inc|dec|magic|marker|hook|seam)\b")
TO: Final = re.compile(
    r"\b(?:to|onto|on|in|into|inside|over|at|along|around|atop|between|under|below|above|behind|against|through|underneath|down|beside|near|alongside|(?:either|each) side|both sides)\b"
)
_WOUND: Final = re.compile(r"\b(?:loop|wrap|wind)\w* (?:the )?(?:yarn|thread|floss)\b")
"""How noses are made that are not called embroidered."""

BUTTONS: Final = re.compile(
    r"\b(?:buttons|beads)\s+(?:and\s+(?:sew|glue|stitch|attach)\s+(?:them\s+)?)?(?:(?:for|as)\s+(?:the\s+)?eyes\s+)?(?:\w+ly\s+)?(?:to|on|onto)\s+"
    r"(?:(?:each|either)\s+side\s+of\s+)?(?:the\s+)?(?:front\s+of\s+(?:the\s+)?)?(?:head|face)\b"
)
"""Buttons on a head that nobody calls eyes."""
THREAD: Final = re.compile(
    r"\b(?:satin|straight|stem|chain|split|running|lazy daisy) (?:st|sts|stitch|stitches)\b|\bback-?stitch\b|\bfrench knots?\b"
)
"""Stitches that draw with thread."""
MEET: Final = re.compile(
    r"\b(?:where|at which) (?:the )?(?:head and (?:the )?body|body and (?:the )?head) (?:meet|join|are joined)\b"
)
UNDER_HEAD: Final = re.compile(
    r"\b(?:(just|right|directly|immediately|straight) |(rounds?|rnds?|rows?|cm|mm|inch(?:es)?|in) (?:down )?)?(?:below|beneath|under|underneath|from) (?:of )?(?:the )?"
    r"(?:head(?! of)|neck(?:line)?|place (?=where the head))\b"
)
"""How far below its head something is sewn to a body."""
AGAIN: Final = re.compile(
    r"^\W*(?:then\s+|and\s+)*(?:(?:do|work)\s+the\s+same|the\s+same\s+goes|repeat(?:\s+(?:this|that|the\s+same|these steps))?|likewise)\s*,?\s*(?:with|for|on)\s+(?:the\s+|both\s+)*"
    r"(?P<what>(?:[a-z]+\s+){0,2}?[a-z]+)\b,?\s*(?P<rest>(?:at|on|to|over|between|but|in|along)\b.*)$"
)
"""Another part that is sewn on as the one before it: "Do the same with the legs at Rnd 4"."""
IT: Final = re.compile(
    r"^\W*(?:(?:then|now|next|finally|and)\W+)*(?:sew|attach|pin|place|position|glue|stitch|fasten|put|secure|whipstitch)\s+(?:them|it|these|both|each one)\b"
)
"""What is done with something that was named before."""
SAFETY_NOSE: Final = re.compile(r"\b(?:safety|plastic|animal|button) nose\b")
"""A nose that is bought, as safety eyes are."""
BLUSH: Final = re.compile(
    r"\b(?:brush|dab|paint|rub|colou?r|dust|apply|put|add|use|give)\w*\b[^.;]*\b(?:blush(?:er)?|rouge|make-?up|chalk|pastels?)\b(?! here)|\bblush\b[^.;]*\bcheeks?\b|\bstitch(?:es)?\b[^.;]*\beyes?\b[^.;]*\bblush\b|\bcheeks?\b[^.;]*\bblush\b|"
    r"\bcolou?r (?:in )?(?:the |his |her |its )?cheeks?\b"
)
"""Cheeks that are painted."""
ONTO_BASE: Final = re.compile(
    r"\b(?:sew|attach|glue|stitch|place|fix|set|put|pin)\s+(?:the\s+|your\s+)?(?:finished\s+|whole\s+|complete\s+)?"
    r"(?:house|cottage|castle|mushroom|toadstool|tree|plant|cactus|toy|figure|snowman|gnome|thing)\s+(?:on\s*)?(?:to|onto|on|in)\b"
)
"""What is said of the whole toy that is set on its base: "Sew the house to the back of the lawn"."""
ADJACENT: Final = re.compile(
    r"(?:\W*\b(?:the|an?|each|both|all|your|of|two|four|three|one|six|eight|\d+|open|ends?|edges?|tops?|bottom|base|lower|upper|wide|narrow|"
    r"last|first|rnd|round|row|\d(?:st|nd|rd|th)|rounds?|rnds?|stuffed|piece|pieces|completed|finished|sides?|back|front|hind|fore|left|"
    r"right|inner|outer|small|large|big|little|short|long|flat|straight|pair|safety|plastic|on|its|their|other|crocheted|unstuffed|cast|"
    r"remaining|rem|same|colou?red|felt|up|foundation|ch|chain|opening|closed|rem|corner|second|white|black|pink)\b)*\W*(?:[a-z'’]+\s+)?$"
)
"""What may stand between a verb and what is put."""


SCULPTED: Final = re.compile(
    r"\b(?:tightening|tighten|indent\w*|sculpt\w*|indentation)\b[^.;]*\beyes?\b|\beyes?\b[^.;]*\b(?:tightening|indentations?|sculpting)\b"
)
"""A thread that draws the eyes into a head, and puts nothing anywhere."""
WHEN: Final = re.compile(
    r"\b(?:after|before|once|until|while)\b[^,.;]*\b(?:has|have|is|are|been|sewing|attaching)\b[^,.;]*"
    r"|,\s*with\s+(?:a|an|the|one|its)\s+(?:\w+\s+){1,3}(?:peep|stick|show|pok|look)\w*\s+out\b[^.;]*"
)
"""When something is done, and what is seen then, which says no place: "after the head has been sewn to the neck", ", with a paw peeping out"."""


def assembling(text: str, names: list[str]) -> bool:
    """Whether a sentence (any letters) puts parts or a face somewhere. names : of parts that are known so far."""
    low = text.lower()
    if SCULPTED.search(low) and re.search(r"\b(?:needle|thread|pull|yarn)\b", low) and where(low).rounds is None:
        return False
    if len(low) <= 600 and _WOUND.search(low) and face.motifs(low):
        return True
    if len(low) <= 600 and (
        is_hair(low)
        or (COMBED.search(low) and re.search(r"\bhair|tails?\b|braid|\b(?:them|it) (?:in|into)\b[^.]*\bbunches", low))
    ):
        return True
    if len(low) <= 600 and BLUSH.search(low):
        return True
    if len(low) <= 600 and AGAIN.match(low) and where(low).rounds is not None and not _STITCHES.search(low):
        return True
    if len(low) > 600 or not VERB.search(low):
        return False
    if SAFETY_NOSE.search(low):
        return True
    if IT.match(low) and where(low).says:
        return True
    if ALL.search(low):
        return True
    if EYES.search(low) and EYED.search(low) and not re.search(r"\beye of\b|\bneedle eye\b", low):
        return True
    if re.search(r"\bembroider\w*\b", low):
        return True
    if DRAWN.search(low) and face.motifs(low) in (["lines"], ["cross"]):
        return True
    if re.search(r"\bsatin st\w*|\bfrench knot", low) and (face.motifs(low) or TO.search(low)):
        return True
    if re.search(
        r"\b(?:whiskers?|eyelash\w*|eyebrows?|freckles?|smile|cheeks|blush|mouth|nostrils?)\b", low
    ) and DRAWN.search(low):
        return True
    if _STITCHES.search(low) and not re.search(r"\bsew\b|\bpin\b", low):
        return False
    if not re.search(
        r"\b(?:sew|sewn|attach(?:ed)?|pin|position|place|glue|join|stitch|fasten|tack|fix|put|add|secure|cent(?:er|re)|whipstitch|go(?:es)?|seam|applique|scatter|arrange|distribute|button|joint)\b",
        low,
    ):
        return False
    if re.match(r"(?:\W*\w+){0,4}?\W*(?:sew|attach|pin|position)\s+(?!clos|shut|up\b|yarn)", low) and re.search(
        r"\b(?:to|onto|on)\b", low
    ):
        return True
    known = {w for name in names for w in Made(name, 1).words}
    words = [one(w) for w in re.findall(r"[^\W\d_]+", low)]
    return any(w in known or kind_of(w) for w in words) and bool(
        TO.search(low)
        or where(low).end is not None
        or where(low).apart is not None
        or re.search(r"\b(?:as shown|as pictured|in place|tog|together|photo)\b", low)
    )


def put_eyes(low: str, eyes: int) -> bool:
    """Whether eyes are what is put, not where something is put."""
    verb = VERB.search(low)
    between = low[verb.end() : eyes] if verb and verb.end() <= eyes else ""
    return not re.search(
        r"\b(?:below|under|beneath|underneath|above|between|beside|from|to|of|as|with|around|over|atop|near|behind|center|centre)(?:\s+the|\s+each|\s+both)*\s*$",
        between,
    )
