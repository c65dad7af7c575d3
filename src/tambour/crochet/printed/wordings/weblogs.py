"""Printed patterns, weblogs: words that pages of today have for what other patterns say otherwise, in the order in which they are put."""

from __future__ import annotations

from typing import Final

from tambour.crochet.words.numbers import NUMBER

CHAINS: Final = r"vp|ch|chs|chain|chains|air loops?|links?"
ST: Final = "sts?|stitch|stitches|sc|hdc|dc|tr"
_ROUND: Final = r"(?:round|rnd|row)"
_LOOPS: Final = r"flo|blo|(?:front|back) loops?(?: only)?"
_STITCH: Final = "sts?|stitch|stitches|sc|hdc|dc"
_KIND: Final = "sc|hdc|dc|tr"
_TALL: Final = "sc|hdc|dc|tr|htr|dtr"
HUE: Final = "black|white|cream|ivory|brown|tan|beige|gr[ae]y|red|pink|orange|yellow|gold|green|blue|purple"
_COUNTS: Final = (
    r"ch(?:ain)?(?: \.)? \d (?:does not|doesn't|do not|don't) count as (?:a |an )?(?:sts?|stitch|sc|hdc|dc|tr)"
)
_WEIGHT: Final = "(?:(?:sport|dk|worsted|aran|bulky|chunky|fingering)(?: weight)? )?"
_NAME: Final = r"(?!(?:sts?|stitch|stitches|sc|hdc|dc|tr|ch|chain|loops?|rounds?|rnds?|rows?|hook|at)\b)[a-z]+"
_MR: Final = "mc|mr|magic ring|magic circle|magic loop"

SAID: Final = (
    (rf"^(?:gather|dial|cast(?: on)?|set|collect|pick up|make a set of) (?:a chain of )?(\d+) (?:{CHAINS})(?= ?[.,;]| ?$)", "ch {1}"),
    (rf"^((?:light |dark |pale )?(?:{HUE}))(?: yarn)? ,(?= (?:in )?(?:turning |flat )?rows(?!\S))", "with {1} yarn ."),
    (rf"(?:take|pick) up (?:the )?((?:light |dark |pale )?(?:{HUE}))(?: yarn)?(?= ?[.,;]| ?$| and\b)", "change to {1}"),
    (r"(?<=[*(\[] )(sl st|slst|slip stitch|ss|sc) in (?:the )?loops? ,", "{1} in next st ,"),
    (r"skip (?:the )?(?:next )?(\d+|one) (?:free )?loops?(?= ?[*,)\]])", "skip {1} st"),
    # minis
    (rf"(\d+ (?:{_KIND})(?: in (?:the )?next(?: \d+)? (?:sts?|stitch|stitches))?) then(?= \d+ (?:{_KIND}) in )", "{1} ,"),
    (rf"(\d+ (?:{_KIND})(?: in (?:the )?next(?: \d+)? (?:sts?|stitch|stitches))?) then 2 ?tog(?= ?[(\[=.]| ?$)", "{1} , dec"),
    (r"^((?:(?:rnd|round|row|r) ?)?\d+ [:.)]) \* ([^*=(]+) \*(?: \.)?$", "{1} [ {2} ] around"),
    (r"close (?:the |your )?(?:gap|opening|end|edge) with (\d+) sc", "fold in half and {1} sc through both layers"),
    (r"^([a-z]+(?: [a-z]+)?) yarn , (?:knit|knitting|crochet|work|worked) (?:it )?in (?:a |the )?(?:spiral|rounds?|circle|(?:swivel |turning )?rows)(?: ,[^.:]*)?(?: [.:])?$", "with {1} yarn"),
    (r"= (\( \d+ \))(?: - \d+ (?:rows|rounds|rnds))?(?= ?\.?$)", "{1}"),
    (r"(\d+) (?:ch|vp|air loops?) ,? ?(?:connect|connected|close|closed|join|joined)(?: (?:it|them))? (?:in|into|to) (?:a |the )?(?:ring|circle)", "ch {1} , join"),
    (r"(?<=, )(?:rotation|rotate)(?= ?[.,;=(]| ?$)", "turn"),
    (r"fold (?:the )?edges?(?: in half)? and (?:knit|crochet|work)(?: them)? together (\d+) (sc|dc)", "fold in half and {1} {2} through both layers"),
    (r"(?<=[:.] )(?:this|the) (?:round|rnd|row) is worked in (?:the )?(blo|flo|back loops only|front loops only) , (?:with )?(?:no|without) (?:increas|decreas)(?:es|ing)(?: or decreas(?:es|ing))?(?: \. (?:finish|end|close) with (?:1|a|one) (ss|sl st|slst|slip stitch))?(?: \.)?(?= [(\[=]| ?$)", "in {1} , sc around , {2}"),
    (r"\( (?:(?:on|in) (?:round|rnd|row) \d+ , )?(?:push|keep|hold|move|fold|bend) (?:the |your |both )?[^()\d]*\)", ""),
    (r"\( (?:in|with|using) (?:a|an|any) (?:[a-z]+ ,? ?){0,3}colou?r (?:like|such as|for example)[^()]*\)", ""),
    *((rf"{post} - (\d+) {kind}", f"{{1}} {post}{kind}") for post in ("bp", "fp") for kind in ("sc", "hdc", "dc")),
    (r"(fold(?: (?:it|the piece|the \w+|flat|in half))* (?:and|,) (?:then )?)(?:work )?(\d+) (sc|dc) across", "{1} {2} {3} through both layers"),
    (r"^((?:(?:rnd|round|row|r) ?)?\d+ [:.]) ([^:]*?) (= \d+|\( \d+ \)) (?:into|in|through) (?:the )?(back|front) loops?(?: only)?(?: \.)?$", "{1} in {4} loops only , {2} {3}"),
    (r", (?:push|fold|hold|move|keep|flip|bend|pull|tuck) (?:the |your |both )?(?:wing|fin|arm|leg|ear|tail|chain|tentacle|petal|flipper)s? (?:down|up|back|forwards?|out of the way|to the (?:front|back|side|inside|outside)|aside|away)(?= ?,)", ""),
    (r"(in (?:the )?last) loop of (?:the )?(ch|chain)", "{1} {2}"),
    (r"(?<=: )(?:starting|beginning) (?:in|with) (?:the )?(?:1st|first) (?:sc|st|stitch)(?: of (?:rnd|round|row|r) ?\d+)? ,", ""),
    (r"(sl st|slst|slip stitch|ss|join) (?:to|into|in) (?:the )?(first|1st) (ch|chain) to (?:create|make|form) (?:a |the )?(?:circle|ring|loop)", "join to form ring"),
    (r"(\d+ (?:sc|hdc|dc)) (?:in|on|along|over) (?:the )?(first|second|1st|2nd|other) (leg|arm)(?= ?,| ?[.;(\[=]| ?$| \d)", "{1} around {2} {3}"),
    (r"(?:continue |go on |starting |continuing )?from (?:the )?(?:second|2nd|other|last) (leg|arm) (?:and|,) (?:then )?(?:ch|chain) (\d+)(?= ?\.?$)", "ch {2} , join to first {1}"),
    (r"^\( (?:note|tip) : \W*(?:inc|dec|sc|hdc|dc|sl st|increase|decrease)\W* (?:=|means) [^()]*\)$", "marker"),
    (r"^(part|piece|petal|leaf|strand|lock|wing|leg|arm|ear|horn|fin|paw)s? (\d) (?:and|&) \d(?: :)?$", "{1} {2} ( make 2 )"),
    (r"^(?:we )?(?:knit|crochet|make|work) (?:the )?(?:second|2nd) (one|leg|arm|foot|paw)(?: in)? (?:exactly |just )?(?:the )?(?:same way|same|likewise|similarly) ,? ?(?:only|but|just) (?:(?:the )?(?:thread|yarn) is not cut|(?:we )?(?:do not|don't) (?:cut|break) (?:the )?(?:thread|yarn))(?: (?:and|but) (?:knit|crochet|work|continue|go)(?: on| further| to (?:knit|crochet|work))*)?", "make the second {1} and do not cut the yarn"),
    (rf"(each (?:{_STITCH})|\d+ (?:{_KIND})|{_KIND}|incs?|decs?|increase|decrease) around (?:the )?(?:circle|ring)(?= ?[.,;(\[=]| ?$)", "{1} around"),
    (r"(ss|sl st|slst|slip stitch|join with (?:a )?(?:ss|sl st|slst|slip stitch)|join) (?:to|in|into|on) (?:the |your )?(?:(?:first|starting|beginning) )?(ch|chain) ?-? ?([1-4])(?= ?[.,;(\[=]| ?$| and (?:fasten|cut|turn|change)\b)", "{1} to top of {2} {3}"),
    (r"(?:2|two) sctog", "sc 2 tog"),
    (r"(?:2|two) dctog", "dc 2 tog"),
    (r"(?:2|two) hdctog", "hdc 2 tog"),
    (r"\( (?:remember|remembering|mind)\b[^()]*\)", ""),
    (r"(change|switch|changing|switching) the (?:colou?r|yarn|thread) (?!to |in |from )[^\W\d]+ (to|into)", "{1} color {2}"),
    (r"((?:change|switch|changing|switching)[^.;]*) , (?:we (?:will )?)?(?:no longer|don't|do not) (?:use|need) (?:the )?[a-z]+(?: any ?more)?(?= ?\.?$)", "{1}"),
    (r"(using|with|in|change to|switch to|attach|join) (?:[a-z]+ ){1,4}yarn ,? (?:in )?colou?r (?:no\.? |# )?\d+ \( ([a-z]+(?: [a-z]+)?) \)", "{1} yarn ( {2} )"),
    (r"(?:fasten|fix) (?:the |your |both |safety |plastic )*(eyes?|noses?)(?= (?:in|on|between|at|to|with|through|here|now|, )| ?[.;]| ?$)", "insert {1}"),
    (r"(dec|decrease|decreasing) (?:to|until|till) (?:it is |you |it )?(?:clos(?:e|ed)|shut)(?: (?:the |up )?(?:hole|opening|ring|circle|piece|top|bottom))?(?= ?\.?$)", "dec around"),
    (r"(?<!\S)(\d+)(?: ')? nc(?= ?[(=\[]| ?[.;]?$)", "{1} inc"),
    (r"(rep|repeat) steps? (\d+(?: - \d+)?)(?= (?:\d+|one|two|three|four|five|six|seven|eight) (?:more )?times?\b| (?:once|twice)\b)", "{1} rounds {2}"),
    (r"(\d+) (?:vp|ch|air loops?) , (?:starting )?(?:in|into|from|with) (?:the )?(second|2nd|third|3rd) (?:loop|link|ch|chain) from (?:the )?hook(?: [a-z]+){0,2} ,? ?(?:we )?(?:begin|start) (?:to )?(?:knit|crochet|work|knitting|crocheting|working)(?: ?:)?", "ch {1} , from {2} ch from hook"),
    (rf"({_KIND}) (\d) times (?:in|into) each", "{2} {1} in each"),
    (r"(?:for|behind|by|over) (?:the )?back of (?:the )?(?:hinge|loop|stitch|wall)s?", "in blo"),
    (r"^((?:row|round|rnd|r) (?!1 )\d+(?: - \d+)? : [^.;]*?)(?:skip|sk|miss) (?:the )?(?:first|1st) (?:ch|chain|st|stitch)(?: from (?:the )?hook)? ,(?= [^.;]*ch 1 (?:and |, )?turn)", "{1}"),
    # shops
    (rf"join with (?:a |1 |one )?(?:{_KIND}) (?:to|into|in|on) ([^,;:.()]+) , this is (?:the )?first of (?:the )?(\d+ (?:{_KIND}))", "join to {1} , {2}"),
    (rf"(?:,|-)? that (?:is |makes |gives )?(?:{NUMBER}) (?!(?:sts?|stitch|stitches|{_KIND})(?!\S))[a-z]+(?= ?[.;]| ?$)", ""),
    (rf"(?<=[,:(\[] )(?:thumb|nose|toe|heel|finger|tail) :(?= \d+ (?:{_KIND}))", ""),
    (r"(\d) (hdc|dc|tr) (?:tog|together) in(?:to)? (?:the )?(?:1|one|same|next|the same) (?:st|stitch)", "{1} {2} bobble in next st"),
    (r"((?:\d+ )?(?:sts?|stitches)) of (?:the )?(?:cap|wig|hat|head|body|skirt)(?= ?[\]),.;])", "{1}"),
    (rf"(?:^|(?<=, ))(?:and )?then (?:the |a )?[a-z]+ (?:on|in|along|across) (?:the )?(?:{NUMBER}) (?:st|sts|stitches) (?:left|remaining|that (?:are left|remain)) :", ""),
    (rf"ch (\d+) , (?:go |going |work |working )?back from (?:the )?(2nd|second) ch(?:ain)?(?: from (?:the )?hook)?(?= \d+ (?:{_KIND}))", "ch {1} , from {2} ch from hook"),
    (r"stop , (?:sl|slst|sl st|ss) , (?:and )?cut(?: (?:the )?(?:yarn|thread))?(?= ?[.;]| ?$)", "sl st , fasten off"),
    (r"((?:little|thin|light|some|no) (?:filling|stuffing)) , fold(?: it)?(?: in half)? , (\d+) (x|sc)(?: (?:on|through|in|over) (?:both|the two|two) (?:sheets|layers|sides|walls))?(?= ?[.;]| ?$)", "{1} . fold in half and {2} {3} through both layers"),
    (r"(?:close : )?fold(?: it)?(?: in half)? , (\d+) (x|sc)(?: (?:on|through|in|over) (?:both|the two|two) (?:sheets|layers|sides|walls))?(?= ?[.;]| ?$)", "fold in half and {1} {2} through both layers"),
    (r"((?:(?:rnd|round|row|r) )?\d+ (?:-|[|:.)]) .*?) < -+ (?:now |then |here )?(change|switch|put|place|insert|add|attach|sew|stuff|fasten|cut|close|join|turn|start|begin|use|with|in)", "{1} . {2}"),
    (r"((?:(?:rnd|round|row|r) )?\d+ (?:-|[|:.)]) .*?) < -+ [^<>|]*$", "{1} , marker"),
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
    (rf"(ch(?:ain)? \d+ ,) (?:and |then )*(?:return|go back|come back|work back|crochet back|turn back)(?: (?:over|along|on|down|across|through) (?:the |this |that )?(?:{CHAINS}))? ?,? (?:beginning|starting|begin|start|from)(?: in| from| with| at)? (?:the )?(2nd|second|3rd|third) ({CHAINS}) from (?:the )?hook", "{1} beginning in {2} {3} from hook"),
    (rf"(in each)(?: one)? of (?:the )?(?:(?:remaining|other|last) )?(\d+) ({CHAINS}) (?:that remain|remaining|left|that are left)", "{1} of next {2} {3}"),
    (rf"(in each)(?: one)? of (?:the )?(?:remaining|other|last) (\d+) ({CHAINS})", "{1} of next {2} {3}"),
    (r"(in each) one of", "{1} of"),
    (r"(?<=, )(?:then )?(\d+ (?:sc|hdc|dc)) (?:in|on|into) (?:the )?(?:body|head|base)(?= ?[*)\].,;]| ?$)", "{1}"),
    (r"(?<=, )(?:then )?(\d+ (?:sc|hdc|dc) in (?:the )?next \d+ (?:sts|stitches|sc)) of (?:the )?(?:body|head|base)(?= ?[*)\].,;]| ?$)", "{1}"),
    # loops
    (rf"(?:work(?:ed|ing)? )?(?:in )?(?:the )?({_LOOPS}) for (?:the |this )?(?:whole|entire|complete|full) {_ROUND}(?: ?[-:,.])?", "in {1} ,"),
    (rf"(around|across|each (?:{_STITCH})|\d+ (?:{_KIND})) \. (?:this|the) {_ROUND} is worked in (?:the )?({_LOOPS})(?= ?[.(\[]| ?$)", "{1} in {2}"),
    # yarns
    (rf"(?:starting|beginning|start|begin) (with|in|using) ({_NAME}(?: {_NAME})?) at (?:the )?(?:{_NAME})(?: {_NAME})?(?= ?[,.;:)]| ?$)", "{1} {2}"),
    (rf"(?<=: )({HUE}) {_ROUND} :", "with {1} ,"),
    (rf"((?:switch|change|changing|with|in|using|use|to) (?:{HUE})) / (?:{HUE})(?: (?=yarn)|(?= ?[.,;:]| ?$))", "{1}"),
    (rf"(?<=\( )({HUE}) {_ROUND}(?= \))", "{1}"),
    (rf"((?:switch|change|changing|with|in|using|to) (?:{HUE})) or (?:{HUE})(?= ?[.,;:]| ?$)", "{1}"),
    # counts
    (r"< (\d+) >(?= ?\.?(?: fasten| cut| join| turn| ?$))", "( {1} )"),
    (r"\( (\d+) / \d+ chs? \)", "( {1} )"),
    (rf"([(\[]) (\d+) ({_STITCH}) (?:made|total|in total|altogether) ?\.? ([)\]])", "{1} {2} {3} {4}"),
    (r"(?<!: )= (\d+)(?: sts?| stitches| sc)? ,(?= (?:join|close|connect|finish|end|fasten|turn|sl st|slst|ss|slip stitch|ch 1 ,? ?turn|do not|don't)(?!\S))", "( {1} ) ,"),
    (r"(\d+ (?:sl st|slst|ss|ch|sc)) ,? (?:very |quite |rather )?loose(?= ?[.,;(\[=]| ?$)", "{1} loosely"),
    # how often
    (r"(?<=[)\]] )x (twice|once)(?= ?[,.;(]| ?$)", "{1}"),
    (rf"(times|twice) ;(?= (?:\d+ )?(?:{_KIND}|inc|dec)(?!\S))", "{1} ,"),
    # what is told behind a count
    (rf"([)\]]) = \d+ {_ROUND}s?(?= ?\.?$)", "{1}"),
    (r"([)\]]) -(?= (?:work|weave|hide|crochet over|carry|don't|do not|remember|you) )", "{1} ."),
    (r"(?<=, )finish(?= ?[(.,;]| ?$)", "fasten off"),
    (r"^\*(?= (?:do not|don't|continue|now|this|you|at this) [^*]*$)", ""),
    # of another day
    (rf"(?:^|(?<=[.:)] ))(?:2|two) (?:{CHAINS})(?: sts?| stitches)? ,? (?:and )?(?:then )?([4-9]|1\d) (sc|dc|single crochets?|double crochets?) (?:in|into) (?:the )?(?:first|1st) (?:st|stitch|ch|chain|loop)(?! from| sp| space)", "ch 2 , {1} {2} in second ch from hook"),
    (r"(with|using|in) ([a-z]+(?: [a-z]+)?) yarn and (?:a |an |the |your )?(?:size )?[a-p](?: ?[/-] ?\d+)? hook(?= |$)", "{1} {2} ,"),
    (r"(change|switch) (to|into) ((?:[a-z]+ ){1,4})# ?(\d+) (\( [a-z]+(?: [a-z]+)? \))(?: yarn)?(?= ?[.,;]| ?$)", "{1} {2} {3} {4} {5}"),
    (r"(with|using|in) (?:a |an |the )?([a-z]+(?: [a-z]+)?) colou?red yarn", "{1} {2} yarn"),
    (r"^([a-z]+(?: [a-z]+){0,2}) \( (make) (\w+) \) (in|with) ([a-z]+(?: [a-z]+)?)(?: :)?$", "{1} ( {2} {3} , {4} {5} )"),
    (rf"\( (?:in|with|using) ([a-z]+(?: [a-z]+)?) {_WEIGHT}yarn and (?:a )?[\d.]+ ?mm hook , (make) (\w+) \)", "( in {1} , {2} {3} )"),
    (rf"\( (?:in|with|using) ([a-z]+(?: [a-z]+)?) {_WEIGHT}yarn and (?:a )?[\d.]+ ?mm hook \)", "( in {1} )"),
    (r"(attach|join|change to) ([a-z]+(?: ?- ?[a-z]+| [a-z]+)?) by (?:pulling|drawing) (?:up )?a loop through (?:the )?last (?:two|2|three|3) (?:loops|sts|stitches)(?: worked| on (?:the )?hook)?", "{1} {2}"),
    (r"(?:(?<=[^\d:] )(?:and|then) |(?<=[.,;] ))sc (?:in|into) (?:the )?(?:first|1st) (?:sc|st|stitch) of (?:this |the )?(?:round|rnd)(?: \d+)?(?= ?[.;(\[]| ?$)", "marker"),
    (r"(?<=: )(?:this|the) (?:round|rnd|row) is worked in (?:the )?(blo|flo|back loops only|front loops only)(?= ?\.?(?: [(\[] ?\d+[^)\]]*[)\]]| = \d+)? ?\.?$)", "in {1} , sc around"),
    (r"(?<=: )(?:\( )?(?:this|the) (?:round|rnd|row) is worked in (?:the )?(blo|flo|back loops only|front loops only) [.)](?= \S)", "in {1} ,"),
    (r"^yarn colou?r (\d|[a-h])(?: \.)?$", "color {1}"),
    (r"change (?:the )?yarn to colou?r (\d|[a-h])", "change to color {1}"),
    (r"(eyes? (?:between|in|into|at|on) [^.]*?) \. there (?:must|should|will|has to) be (\d+) (sts|stitches|sc) between (?:them|the eyes|both(?: eyes)?)", "{1} , with {2} {3} between them"),
    (r"((?:change|switch) to [a-z]{3,}) and (?:stay|keep|continue|go on|carry on)(?: on)? (?:with|in) [a-z]{3,}(?: (?:until|till|to) (?:the )?(?:very )?end)?(?= ?[.;]| ?$)", "{1}"),
    (r"((?:begin|start) with [a-z]{3,}) for (?:the|his|her|its) [a-z]+(?: [a-z]+)?(?= ?[.;]| ?$)", "{1}"),
    (rf"^({HUE}) , (?:worked )?(?:from )?(?:the )?(?:bottom|top|base|neck|nose|crown|tip) (?:up |down )?to (?:the )?[a-z]+(?= ?\.?$)", "{1}"),
    (r"\( (?:that|this)(?: is| makes)? (?=\d)[^()]* \)", ""),
    (r"((?:change|switch|go back|return) (?:to|back to) (?:[a-z]+ )?[a-z]{3,}) , (?:it|this|that|these|which)(?:'s| will| is| are| was| makes?| becomes?) [^.,;:()]*(?= ?[.!]| ?$)", "{1}"),
    (r"(?:^|(?<=[.!] ))(?:now |then )?(?:next|further|onwards?|from (?:here|now)(?: on)?)(?: on)? ,? ?(?:we |you )?(?:work |crochet |use )?(?:only|just) (?:with |in )?([a-z]{3,})(?= ?\.?$)", "change to {1}"),
    (r"(?:we |you )?(cut|hide|break) (?:off )?(?:the |your )?thread", "{1} the yarn"),
    (r"picots? (?:of|from) (?:ch )?3(?: (?:ch|chs|chains))?", "picot"),
    (r"((?:=|\)) \d+|\d+ \)) ,(?= (?:fill|stuff|sew|insert|cut|fasten|leave|attach|start|begin|add|put|place|embroider)\b)", "{1} ."),
    (r", (?:the )?(?:torso|body|head|leg|arm) (?:is )?full$", ". stuff"),
    (r"^colou?rs ([a-k])$", "color {1}"),
    (r"^(\d+) \. - (\d+) \.", "{1} - {2} ."),
    (r"^(\d+ (?:-|to) \d+ (?:rows|rounds|rnds)) / \d+ (?:rows?|rounds?|rnds?) / -?", "{1} -"),
    (r"(?<=[.:] )(?:\( \d+ (?:rows?|rounds?|rnds?) \) )?unchanged(?= [(\[]| ?$)", "sc around"),
    (r"^(\d+(?: - \d+)?) \) (\d+)$", "{1} : {2} sc"),
    (r"\[ ?(?:rep|repeat) (rnds?|rounds?|rows?) (\d+) and (\d+) alternately ?\] (twice|\d+ times)", "rep {1} {2} and {3} {4}"),
    (r"(?:form|make) (?:a )?slip ring", "magic ring"),
    (r"in (?:the )?slip ring", "in ring"),
    (r"(\( \d+(?: (?:sts?|sc|stitches))? \)|\[ \d+(?: (?:sts?|sc|stitches))? \]) -(?= (?:add|place|insert|put|attach|note|this|you|here|if|now|at this|use|make sure|don't|do not|before|remember|i|we|it|start|begin|mark|move|embroider|sew|pause|stop)\b)", "{1} ."),
    (r"(?<!\d )(?:2|two) (sc|hdc|dc|tr) (?:together|tog)(?! (?:around|with|through|in)\b)", "{1} 2 tog"),
    (r"(?:,|and|then) (?:repeat|rep) \* ?- ?\* (?:(?:un)?till?|to|through) (?:the )?(?:very )?end(?: of (?:the |this )?(?:round|rnd|row))?", "repeat from * around"),
    (r"(\*) ?[.,] ?(?:repeat|rep) \* ?- ?\* (?:(?:(?:un)?till?|til|to|through) )?(?:the )?(?:very )?end(?: of (?:the |this )?(?:round|rnd|row))?", "{1} around"),
    (r"(?:on|in) (?:the )?last (?:round|rnd|row) ,? ?sc (?:in|into) (?:the )?first (?:sc|st|stitch)(?: of (?:the |this )?(?:round|rnd|row))?(?= ?[.;]| ?$)", "marker"),
    (r"(?<!\d )(sc|work|crochet) (?:down|along|up) (?:the )?(?:chain|ch|row)(?= ?[.,;(\[]| ?$)", "{1} across"),
    (r"(?:make|do|work) (?:a |1 |one )?(ss|sl st|slst|slip stitch)(?: -| ,)? only (?:in|into) (?:the )?(?:first|1st|next) (st|stitch)", "{1} in next {2}"),
    (r"(colou?r) (?:\d|[a-h]) \( ((?!skip|see)[a-z]+(?: [a-z]+)?) \)(?= (?:for|:)| ?[.,;]| ?$)", "{1} {2}"),
    (r"^(?:the )?colou?r (?:scheme|plan|order|sequence) (?:for|of) (?:(?:rnds?|rounds?|rows?) )?\d+ (?:-|to) \d+(?: (?:rnds?|rounds?|rows?))? ?[:.]?$", "marker"),
    (r"^((?:start |begin )?(?:with )?(?:a |the )?(?:magic ring|magic circle|mr|mc) with \d+ sc) - 1 (?:rnd|round) ?\.?$", "round 1 : {1}"),
    (r"(?:around )?(?:until|till) (?:you )?(?:reach|get to|come to|are at|are back at) (?:the |your )?(?:marked (?:st|stitch)|(?:stitch )?marker|(?:very )?end(?: of (?:the |this )?(?:round|rnd|row))?)", "around"),
    (r"(?:do not|don't) (?:sl st|slip stitch|ss) (?:to|in|into) (?:the )?(?:beg|beginning|first|1st)(?: (?:st|stitch|sc))?", "do not join"),
    (r"((?:magic ring|magic circle) and work) (\d+ (?:single crochets?|sc)) in it", "{1} {2} in ring"),
    (r"- note : pm (?:on|in) (?:the )?(?:1st|first) (?:sc|st|stitch)", "marker"),
    (r"(?:start|begin) with either (?:\S+ ){3,14}?or (?:a |an |the )?(?:mc|mr|magic ring|magic circle|magic loop)", "magic ring"),
    (r"(in|into) (?:the )?(?:mc|mr|magic ring|magic circle) or (?:the )?ring", "{1} ring"),
    (r"(back|front) loops? only for (?:this|the) (?:round|rnd|row)(?: :| ,)?(?= (?:\d+ |\( |\[ |\* )?(?:sc|hdc|dc|inc|dec))", "in {1} loops only ,"),
    (r"\* (?:for )?\d+ (?:rounds?|rnds?|rows?) \*(?= \d| sc| \()", ""),  # "7-10. *4 rows* 36 sc": the numbers of the rounds say it
    (rf"(?:start|begin) (?:with|by) (?:making )?(?:(?:2|two) ({CHAINS})|({CHAINS}) (?:2|two)) ?,? (?:and )?(?:then )?(?:make|work|crochet|put|do )?(?: ?([4-9]|1[0-2]) (sc|dc|single crochets?|double crochets?)) (?:in|into) (?:the )?(?:first|1st|2nd|second) (?:st|stitch|ch|chain)(?: made| from (?:the )?hook)?", "{3} {4} in mr"),
    (r"close (?:the )?(?:circle|ring) (?:by|with) (?:making |working )?(?:a |an )?(ss|sl st|slst|slip stitch) (?:in|into|to) (?:the )?(?:first|1st) (\w+)", "join with {1} in first {2}"),
    (rf"(in (?:the )?first (?:{ST}) , (?:\d+ )?\w+) in (?:the )?second ({ST}) (, (?:\d+ )?\w+) in (?:the )?third ({ST})(?! from)", "{1} in next {2} {3} in next {4}"),
    (rf"(in (?:the )?first (?:{ST}) , (?:\d+ )?\w+) in (?:the )?second ({ST})(?! from)", "{1} in next {2}"),
    (r"\( (?:you )?should (?:now |still )?(?:have|be left with|be) (\d+) (?:sts?|stitches)(?: by the end of (?:the )?(?:row|round|rnd)(?: \d+)?)?(?: \.)? \)", "( {1} )"),
)  # fmt: skip
