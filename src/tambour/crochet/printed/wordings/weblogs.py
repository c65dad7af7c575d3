"""Printed patterns, weblogs: words that pages of today have for what other patterns say otherwise, in the order in which they are put."""

from __future__ import annotations

from typing import Final

_ROUND: Final = r"(?:round|rnd|row)"
_LOOPS: Final = r"flo|blo|(?:front|back) loops?(?: only)?"
_STITCH: Final = "sts?|stitch|stitches|sc|hdc|dc"
_KIND: Final = "sc|hdc|dc|tr"
_TALL: Final = "sc|hdc|dc|tr|htr|dtr"
_HUE: Final = "black|white|cream|ivory|brown|tan|beige|gr[ae]y|red|pink|orange|yellow|gold|green|blue|purple"
_COUNTS: Final = (
    r"ch(?:ain)?(?: \.)? \d (?:does not|doesn't|do not|don't) count as (?:a |an )?(?:sts?|stitch|sc|hdc|dc|tr)"
)
_MR: Final = "mc|mr|magic ring|magic circle|magic loop"

SAID: Final = (
    # repeats
    (r"repeat(?= [\[(] [^\])*]+ [\])] (?:around|across|to (?:the )?end)(?: ?[.,;(]| ?$))", ""),
    (rf"(dec|decrease|invdec|sc2tog) over (?:the )?(?:first|next|last|following) 2 (?:{_STITCH})", "{1}"),
    (r"(sc|hdc|dc) in (?:the )?(2nd|second) and (?:3rd|third) (ch|chains?|chs) from (?:the )?hook", "{1} in {2} {3} from hook , {1} in next {3}"),
    (r"(?:single crochet|sc) (?:the )?(?:next|following) 2 (?:sts|stitches|sc) (?:tog|together) (?:for|as|to make) (?:a |one |1 )?(?:dec|decrease)", "dec"),
    (r"(rep|repeat) around all (?:the )?(?:sts|stitches)", "{1} around"),
    *(
        (rf"(in (?:the )?(?:{a})(?: (?:{_STITCH}))? , (?:\d+ )?(?:{_KIND})) in (?:the )?(?:{b})(?: (?:{_STITCH}))?(?= ?[,.;)\]]| ?$)", "{1} in next")
        for a, b in (("first|1st", "second|2nd"), ("next", "third|3rd"), ("next", "fourth|4th"), ("next", "fifth|5th"))
    ),
    (rf"(?<=[\[(*] )((?:\d+ )?(?:{_KIND})) in (?:the )?(?:first|1st)(?: (?:{_STITCH}))?(?= , (?:\d+ )?(?:{_KIND}) in next)", "{1} in next"),
    # rings
    (rf"(?:^|(?<=[.:)] ))({_MR}) (?:with|of) (\d+) ({_KIND})", "{2} {3} in {1}"),
    (rf"(?:^|(?<=[.:)] ))({_MR}) (?:with|of) (\d+) (?:sts?|stitch|stitches)", "{2} sc in {1}"),
    (rf"({_KIND}) (\d+) times (?:around|in|into|inside|through) (?:the |your )?(?:loop|ring|circle)", "{2} {1} in ring"),
    (rf"(in (?:an? |the )?(?:{_MR})) or ch 2 ,? ?(?:and )?(?:work |make )?(?:(?:{_KIND}) \d+|\d+ (?:{_KIND})) in(?:to)? (?:the )?(?:first|1st|second|2nd) (?:ch|chain)(?: from (?:the )?hook)?", "{1}"),
    (rf"ch(?:ain)? 2 or (?:an? |the )?({_MR})(?: or (?:start )?(?:however|whichever way|any way) you (?:like|prefer|want|wish))?", "{1}"),
    (rf"inside (?:of )?(?:the |your )?({_MR}|ring|circle)", "in {1}"),
    (rf"^(?:form|make|start with|begin with|create) (?:a |an |the )?({_MR}) (?:,|and) ch(?:ain)? \d ?\.?$", "{1}"),
    (r"close the (?:rnd|round) with (?:a |an )?(?:sl st|slst|slip stitch)", "join with sl st"),
    (r"(?:sl st|slst|slip stitch) back (?:in)?to (?:the )?(?:1st|first) (?:st|stitch|sc)", "join with sl st in first st"),
    # chains
    (rf"\( (?:is|equals|acts as|this is) (?:the |your |a )?(?:first|1st|1) ({_TALL}) \)", "( counts as {1} )"),
    (rf"\* {_COUNTS}(?: ?\.)?", ""),
    (r"(?:,|and then|then|and) (?:crochet|work|make) (\d+) (?:chs|chains)(?: very)?(?: tightly| loosely)?", ", ch {1}"),
    # loops
    (rf"(?:work(?:ed|ing)? )?(?:in )?(?:the )?({_LOOPS}) for (?:the |this )?(?:whole|entire|complete|full) {_ROUND}(?: ?[-:,.])?", "in {1} ,"),
    # yarns
    (rf"((?:switch|change|changing|with|in|using|to) (?:{_HUE})) or (?:{_HUE})(?= ?[.,;:]| ?$)", "{1}"),
    # counts
    (r"< (\d+) >(?= ?\.?(?: fasten| cut| join| turn| ?$))", "( {1} )"),
    (r"\( (\d+) / \d+ chs? \)", "( {1} )"),
    (rf"([(\[]) (\d+) ({_STITCH}) (?:made|total|in total|altogether) ?\.? ([)\]])", "{1} {2} {3} {4}"),
    # how often
    (r"(?<=[)\]] )x (twice|once)(?= ?[,.;(]| ?$)", "{1}"),
    (rf"(times|twice) ;(?= (?:\d+ )?(?:{_KIND}|inc|dec)(?!\S))", "{1} ,"),
    # what is told behind a count
    (rf"([)\]]) = \d+ {_ROUND}s?(?= ?\.?$)", "{1}"),
    (r"([)\]]) -(?= (?:work|weave|hide|crochet over|carry|don't|do not|remember|you) )", "{1} ."),
    (r"(?<=, )finish(?= ?[(.,;]| ?$)", "fasten off"),
    (r"^\*(?= (?:do not|don't|continue|now|this|you|at this) [^*]*$)", ""),
)  # fmt: skip
