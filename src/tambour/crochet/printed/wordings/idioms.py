"""Printed patterns, idioms: English that only some write, old booklets, translations and talk, put as most others do: "dec. 1", "As 7th", "behind the back wall"."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.gaps import spaced
from tambour.crochet.printed.wordings.reworded import reworded
from tambour.crochet.printed.wordings.sellers import CHAT, ranged
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.printed.wordings.weblogs import CHAINS, SAID, ST
from tambour.crochet.words.numbers import NUMBER, NUMBERS, TEENS, TENS
from tambour.crochet.words.sayings import Sayings

_NTH: Final = r"\d+(?:st|nd|rd|th)|first|second|third|fourth|fifth|sixth|seventh|eighth|ninth|tenth"
_SC: Final = r"\w{2,6}"
_KIND: Final = "sc|hdc|dc|tr|single crochet|half double crochet|double crochet"
_UNLETTERED: Final = r"(?! (?:\(|:|mc|cc|[a-k])(?: |$))"
_TURNED: Final = "(?:sc|single crochet)"

_IDIOMS: Final = tuple(
    (rf"(?<!\S){said}(?!\S)", meant)
    for said, meant in (
        *CHAT,
        *SAID,
        (r"(?:held|used|taken|worked|working) (?:double|doubled)(?! crochet| treble|-)", "held together"),
        (r"(?:a |one |1 )?single strands? of", "yarn"),
        (r"(?:until|till) (?:the )?(?:very )?end of (?:the |this )?(?:round|rnd|row)(?= ?[.,;:(<\[]| ?$)", "around"),
        # booklets of the fifties
        (r"(inc|dec|increase|decrease)(?: \.)? (?:1|one)(?= [,;.)*]| ?$)", "{1}"),
        (r"(inc|dec|increase|decrease) (?:\. )?(?:all|right) (?:round|around)", "{1} around"),
        (r", thus (?:completing|making|having) \d+ (?:rounds|rows|rnds)(?: in all)?", ""),
        (rf"({NUMBER}) (?:more )?(rounds?|rnds?|rows?) straight(?: in (?:dc|sc|tr|double crochet|single crochet))?", "{1} {2} even"),
        (rf"(work|and|,|;) ({NUMBER}) (rounds?|rnds?|rows?) more(?= [.,;]| ?$)", "{1} {2} {3} even"),
        (r"ch(?:ain)? (?:1|one) (?:for|to) (?:the )?(?:colou?r change|change (?:the )?colou?rs?)(?: ,? ?\(? ?(?:does not|doesn't) count(?: as (?:a |an )?(?:st|sc|dc|hdc|stitch))?(?: \))?)?", "marker"),  # kept with its round, and no stitch
        (r"work(?:ing)? (?:rounds?|rnds?|rows?) 1 (?:-|to|through) \d+ (?:using|with|in) (\w+)(?= ,? ?(?:and |then )*(?:chang|switch))", "using {1}"),
        (r"all (?:the way )?(?:a)?round (sc|dc|hdc|htr|tr|single crochet|double crochet)", "{1} around"),
        (r"(cut|break|leave|change|attach|hide|tie off|fasten off) (?:the |your |a |long )*ropes?", "{1} the yarn"),
        (r"\( \d+ (?:tufts|bobbles|popcorns|puffs|picots|loops|shells|blocks) \)", ""),
        (r"(times|x) without (?:cutting|breaking)(?: off)? (?:the |your )?(?:yarn|thread|wool)(?: (?::|-) (?:[a-z]+ ){1,3}(?:hanging|sitting|joined|held)(?: [a-z]+){0,5})?", "{1}"),
        (r", where (?:your|the) (?:very )?first (?:sc|dc|st|stitch) (?:is|was|sits|lies)", ""),
        (r"counting (?:the|your) (?:turning|first|starting) ch(?:ain)?", ""),
        (r"(every|each|all) (chains?|ch|sts?|stitch|stitches) (?:after(?:wards)?|thereafter|from there|after that|till the end|until the end)", "{1} {2}"),
        (r"(sc|dc|htr|hdc|tr|double crochet|single crochet) (?:all )?(?:the way )?round(?= [\[(.,;!]| ?$)", "{1} around"),
        (r"(make|work|crochet) (\w+ more) (?:the same|alike|just the same|exactly the same|in the same way|the same way|like (?:this|that|it)|to match)", "{1} {2}"),
        (r"(?:,? ?(?:and|so)|-) (?:then )?(?:you|we)(?:'ll| will| should)? (?:now )?(?:have|get|see) \d+ (?!sts?\b|stitch|sc\b|dc\b|single|double)[a-z]+(?: , [a-z]+)?(?= [.!;]| ?$)", ""),
        (rf"until (?:there are |you have )?(?:only )?({NUMBER}) (st|sts|stitch|stitches) before (?:the )?end(?: of (?:the |this )?(?:round|rnd|row))?", "until {1} {2} remain"),
        (r"(?:but )?(?:(?:work|working|crochet|crocheting|sc) )?(?:the )?last (?:2|two) (?:sts |stitches |sc )?(?:tog|together)(?= ?[.,;(=-]| ?$)", "dec"),
        (rf"leave ({NUMBER}) (?:sts|stitches|st|sc)(?: unworked| free| out)?(?= , (?:then )?(?:\d+|sc|hdc|dc|inc|dec)\b)", "skip {1}"),
        (rf"(?:leave|leaving) (?:the )?(?:(?:last|final|remaining|rem|other|rest of the) )?({NUMBER}) (?:sts|stitches|st|sc)(?: free| out| alone| as they are| behind)?(?= ?[.;!)]| and turn| , turn| ?$)", "leave {1} sts unworked"),
        (rf"(?:do not|don't|not) (?:work|crochet|touch)(?:ing)? (?:in |into |on )?(?:the )?(?:last|final|remaining|rem|other) ({NUMBER}) (?:sts|stitches|st|sc)(?: at all)?", "leave {1} sts unworked"),
        (rf"(?:the )?(?:(?:last|final|remaining|rem|other) )?({NUMBER}) (?:sts|stitches|st|sc) (?:are |is |will be |will |should )?(?:remain(?:s|ing)?|left|not|stay|be left)(?: being)? (?:un)?(?:worked|crocheted)(?= ?[.;!)]| and turn| , turn| ?$)", "leave {1} sts unworked"),
        (r"(?:stop|end|pause) here ?,? ?(?:and |then )*turn", "turn"),
        (r"(\d+ \w{2,8}) without (?:any )?changes?(?= [,;.(\[{=]| ?$)", "{1}"),
        (r"^(?:now |then |and )?(?:begin |start |cont |continue )?(?:to )?(?:inc|dec|increase|decrease|increasing|decreasing) as (?:folls?|follows|follow)(?: [:.])?$", ""),
        (r"(sts?|stitch|stitches|sc|dc|hdc) (?:of|from|in) (?:the )?(?:previous|prev|preceding) (?:round|rnd|row)", "{1}"),
        (r"(every|each) single (st|stitch)", "{1} {2}"),
        (r"(?:keep going|keep on|carry on|go on|continue|continue on)(?: like this)? :", ""),
        (r"(\d+) scblo", "{1} sc in blo"),  # without a number it may be a stitch of the pattern's own
        (r"(\d+) scflo", "{1} sc in flo"),
        (r"(blo|flo) -", "{1} :"),
        (r"(?<!rnd )(?<!round )(?<!rd )(?<!row )(?<!r )(\d+) (mr|mc|magic ring|magic circle)(?= [(\[=]| ?$)", "{1} sc in mr"),
        # pages of today
        (r"^you need(?: :)?(?: [~*=-])*$", "you will need"),
        (r"= (\d+) (close|fill|stuff|cut|fasten off|finish off|fold)(?= [.a-z]| ?$)", "= {1} . {2}"),
        (r", (?:and |then )?(?:work|working|crochet) (?:all )?around (?:both sides of )?(?:the )?(?:chain|ch)(?: \( oval \))?(?= [:.]| ?$)", ""),
        (r"(?:along|on|in|across) (?:the )?(?:lower|bottom|second|under) side(?: of (?:the )?(?:chain|ch))?(?= [,:]| (?:sc|dc|hdc|inc|\d))", "on the other side of the chain"),
        (r"\* (inc|dec) \* (twice|\w+ times)", "{1} {2}"),
        (r"^(?:and |then |now )?back to (?:the )?([a-z]+)(?: yarn| again)? for (?:his|her|its|the) [a-z]+(?= \.| ?$)", "change to {1}"),
        (r"turn with (?:a )?(?:ch|chain) (1|2|3|one|two|three)(?= [.;,]| ?$)", "ch {1} , turn"),
        (rf"({_KIND}) in (?:the )?(2nd|second|3rd|third) (?:ch|chain)(?: from (?:the )?hook)? and (?:across|to (?:the )?end)", "{1} in {2} ch from hook and in each ch across"),
        (r"(?:hold|turn|keep|flip)(?:ing)? (?:the |your )?[a-z]+(?: head)? (?:upside down|head down)(?: ,)?(?: and)?(?: then)?(?= (?:join|attach|insert))", ""),
        (r"(?:finish (?:off )?(?:with|by) )?(?:a |one |1 )?(sl st|slst|ss) , (?:then )?cut(?: (?:the |your )?yarn)?(?: ,| and)? (?:leave |leaving )?(?:a )?long (?:tail|end|thread)", "{1} , fasten off , leave a long tail"),
        (r"(?:finish (?:off )?(?:with|by) )?(?:a |one |1 )?(sl st|slst|ss) , (?:then )?cut(?: (?:the |your )?yarn)?(?: , (?:done|finished|that's it))?(?= [.!,]| and|$)", "{1} , fasten off"),
        (r"(?:a |the )?(?:last|final)(?: little)? (?:bit|pinch|handful|tuft) (?:more )?of (stuffing|filling|fibrefill|fiberfill)", "{1}"),
        (r"after (?:this|that) (?:row )?and (?:every|each)(?: other)? (row|round)", "after each {1}"),
        (r"(times|x|\*|\d+) , (?:for |makes |making )?(?:\d+ )(?:scallops|blades|shells|petals|points|teeth|waves|spikes|fans)(?= [.!;]| ?$)", "{1}"),
        (rf"({NUMBER}) (?:whole|full|entire|complete) (rounds?|rnds?|rds?|rows?)", "{1} {2}"),
        (r"(inc|dec|sc|hdc|dc|incs|decs) \( (\d+) (?:times|x) \)", "{2} {1}"),
        (rf"(to|with|using|in|join|attach|use) (?:the |your )?main (?:colou?r|yarn){_UNLETTERED}", "{1} mc"),
        (rf"(to|with|using|in|join|attach|use) (?:the |your )?(?:contrast|contrasting|secondary|accent) (?:colou?r|yarn){_UNLETTERED}", "{1} cc"),
        (r"(?:-|,) \d+ (?:rounds?|rnds?|rows?)(?: in)? total", ""),
        (r"(leg|arm|ear|piece) one", "{1} 1"),
        (r"(leg|arm|ear|piece) two", "{1} 2"),
        (r"(?:the )?back of (?:the )?(?:connecting|joining) (chain|ch)s?", "other side of the {1}"),
        (r"(?:connecting|joining) (chain|ch)s?", "{1}"),
        (r"(?:align|line up|place) (?:both|the|the two) legs(?: side by side| next to each other)? ,", ""),
        (r"in (?:the )?(?:invisible )?fasten(?:ed)? ?-? ?off (?:stitch|st) of", "around"),
        (r"this (?:will )?(?:be|forms?|makes?|becomes?) the (?:bottom|top|base|front|back|nose|snout|tip) of [^.,;:()]*(?= \.| ?$)", "marker"),
        (r"^\* (fill|stuff|sew|attach|fasten|leave|insert|place|embroider|weave|note|cut)(?=[^*]*$)", "{1}"),
        # edgings, baskets, blankets
        (rf"(?:working |work )?(?:from )?left to right(?: ,)?(?: (?:instead of|rather than|and not|not) (?:from )?right to left)?(?: ,)?(?: as (?:is )?(?:usual|normal))?(?: ,)? (?:work |make )?((?:1|one|a) )?(?:reverse |rev )?{_TURNED}", "{1} rev sc"),
        (r"(double|half double|treble|single) crochet (front|back) post", "{2} post {1} crochet"),
        (r"button - hole", "buttonhole"),
        (r"in each (?:ch|chain) - \d+ or (?:ch|chain) - \d+ (sps?|spaces?)", "in each {1}"),
        (rf"each ({ST}) or ((?:ch|chain) - 1 (?:sps?|spaces?))", "each {1} and {2}"),
        (rf"(\d+) more ({_KIND}) in(?:to)? (?:the )?(ring|loop)", "{1} {2} in {3}"),
        (r"[(\[] (rep|repeat) (rows?|rnds?|rounds?) (\d+) (and|-|to) (\d+) [)\]] (\d+) times", "{1} {2} {3} {4} {5} , {6} times"),
        (r"(rep|repeat) [(\[] (rows?|rnds?|rounds?) (\d+) (and|-|to) (\d+) [)\]] (\d+) times", "{1} {2} {3} {4} {5} , {6} times"),
        (r"for (?:pat|patt|pattern)(?= until)", ""),
        (r"in (?:the )?bottoms? of (?:the )?same (\d+) (chs?|chains?)", "in next {1} {2}"),
        (rf"((?:1|2|3|one|two|three) (?:{_KIND})) (first|next|last) ({ST})", "{1} in {2} {3}"),
        (r"evenly spaced", "evenly"),
        (r"evenly (across|around|over|on) (?:the )?(?:row|last row|last round|rnd|round)", "evenly {1}"),
        (r"(?:each|every) (ch|chain|chains) (?:of|in) (?:the )?(?:next )?(?:ch|chain) - (\d+) (?:sp|space|loop|lp)", "next {2} {1}"),
        (rf"in (?:the )?(?:sps?|spaces?) between (?:each|every) (?:(?:2|two) )?({ST})", "in each {1}"),
        (rf"in (?:the )?(?:sps?|spaces?) between (first|next|last) (?:2|two) ({ST})", "in {1} {2}"),
        (r"(?:continue|cont|continuing) to work in (sc|hdc|dc|single crochet|double crochet)", "work in {1}"),
        (rf"(?:work|working|worked) (?:even )?in ({_KIND})(?: sts?| stitch(?:es)?)? (?:to (?:the )?end of (?:the )?(?:row|rnd|round)|across|around)", "{1} in each st around"),
        (r"with (?:the )?(?:1st|2nd|3rd|4th|first|second|third|fourth|small|other|new) (?:small )?balls? of (\w+)", "with {1}"),
        (r"with (?:the )?(?:1st|2nd|3rd|4th|first|second|third|fourth|small|other|new) (?:small )?ball(?: ,)?", ""),
        (r"using (?:the )?(?:1st|2nd|3rd|4th|first|second|third|fourth|small|other|new) (?:small )?balls? of (\w+)", "using {1}"),
        (rf"in (?:the )?(?:closest|nearest) ({ST})", "in any {1}"),
        # the same round once more
        (r"(?:and )?(?:the )?(?:same again|ditto|the same again|same as (?:before|above)|once more the same)", "repeat last round"),
        (r"pop(?: (?:in|on))?(?= (?:the|your|both|them|those|these|two) (?!next|same|first|last|st|sts|sc|ring|loops?)\w)", "put in"),
        # translations
        (r"(?:behind|for|by|in|at|from|through|into|on|under) (?:the )?(?:back|rear|far) (?:half )?(?:walls?|threads?|strands?|halves|half(?: -)? ?loops?)(?: of (?:the )?(?:loops?|stitch|stitches|sts?))?(?: only)?", "in blo"),
        (r"(?:behind|for|by|in|at|from|through|into|on|under) (?:the )?(?:front|near) (?:half )?(?:walls?|threads?|strands?|halves|half(?: -)? ?loops?)(?: of (?:the )?(?:loops?|stitch|stitches|sts?))?(?: only)?", "in flo"),
        (rf"(?:dial|dials|type|recruit|collect|gain|cast on|cast|set) (\d+) ({CHAINS})", "ch {1}"),
        (rf"(?:from|in|into|starting from|starting in) (?:the )?({_NTH}) (?:loop|link|air loop) from (?:the )?hook", "in {1} ch from hook"),
        (r"(?:knit|knitting) (\d+|a|one|around|in)", "{1}"),
        (r"in (?:one|1) (?:loop|column)", "in 1 st"),
        (r"in the same (?:loop|column)", "in same st"),
        (r"(?<!way )to (?:the )?end of (?:the )?(?:row|round|circle)", "around"),  # "made in the same way to the end of Round 9" names it
        (r"(?:with|by) (?:a )?(?:connecting|half) (?:post|column|loop)", "with sl st"),
    )
)  # fmt: skip
_AS: Final = rf"(?<!\S)as (?:the |for |in )?({_NTH})(?= [.,;]| ?$)"
_IN_ROWS: Final = Sayings(((_AS, "as {1} row"), *_IDIOMS))
_IN_ROUNDS: Final = Sayings(((_AS, "as {1} round"), *_IDIOMS))
_ROWS: Final = frozenset(("row", "rows"))


_NAMED: Final = frozenset((*TENS, *TEENS))
_SPECIAL: Final = re.compile(r"^to (?:work|make) (?:1|one|a|an|the) (\w+) [.:-]+(.*)$")
_DROPPED: Final = ("slip loop", "drop", "off hook", "off the hook", "remove hook", "take hook")


def plainly(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with such words as most others have them."""
    for row in rows[:_LOOKED_AT]:
        found = (
            _SPECIAL.match(" ".join(t.word for t in row.tokens)) if row.tokens and row.tokens[0].word == "to" else None
        )
        if found is not None and not vocabulary.read([t for t in row.tokens if t.word == found[1]][:1])[0].value:
            vocabulary.define(found[1], "popcorn" if any(w in found[2] for w in _DROPPED) else "bobble")
            vocabulary.define(f"{found[1]}s", "popcorn" if any(w in found[2] for w in _DROPPED) else "bobble")
    return [row if not row.tokens else _row(ranged(row)) for row in rows]


_LOOKED_AT: Final = 100  # lines


def _numbered(tokens: list[Token]) -> list[Token]:
    """``sixty-one``, ``twenty four`` and ``sixteen`` as numbers."""
    if not _NAMED.intersection([t.word for t in tokens]):
        return tokens
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        token, end = tokens[at], at + 1
        value = TEENS.get(token.word) or TENS.get(token.word) or 0
        if token.word in TENS:
            end += end < len(tokens) and tokens[end].word == "-" and tokens[end].glued
            if end < len(tokens) and NUMBERS.get(tokens[end].word, 10) < 10:
                value, end = value + NUMBERS[tokens[end].word], end + 1
            else:
                end = at + 1
        number = Token("number", str(value), token.start, tokens[end - 1].end, value, token.glued, token.capital)
        made.append(number if value else token)
        at = end
    return made


def _row(row: Row) -> Row:
    tokens = row.tokens
    flat = any(t.word in _ROWS for t in tokens[:6])
    tokens = spaced(_numbered(tokens))
    tokens = reworded(tokens, _IN_ROWS if flat else _IN_ROUNDS)
    return row if tokens is row.tokens else replace(row, tokens=tokens)
