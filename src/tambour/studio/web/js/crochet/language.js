// How a crochet pattern is coloured: headings, labels of rounds, stitches, numbers, stated counts, remarks.

const STITCH = /^(?:inv(?:isible)? dec|[bf]lo?\b|(?:fp|bp)?(?:sc|hdc|dc|tr|dtr)(?:2tog|3tog| inc| dec)?|incs?\d?|decs?\d?|increase|decrease|sl ?st|ch(?:ain)?s?|ss|mr|magic (?:ring|circle)|bobble|popcorn|puff|picot|skip|sk|turn|(?:single|double|half double|treble) crochet)\b/i;

/** A stream language for CodeMirror. @param {boolean} own tambour's own language, where # begins a remark */
export const crochet = (own) => ({
  name: "crochet",
  startState: () => ({}),
  /** @param {any} stream */
  token(stream) {
    if (stream.sol()) {
      stream.eatSpace();
      if (own && stream.match(/^#.*/)) return "comment";
      if (stream.match(/^(?:#{1,6} .*|==.*|\*\*.*\*\*\s*$)/)) return "heading";
      if (stream.match(/^(?:#|\/\/).*/)) return "comment";
      if (stream.match(/^(?:R|Rnds?|Rounds?|Rows?|Rd)\.?\s*\d+(?:\s*[-–—]\s*(?:R|Rnd)?\s*\d+)?\s*[:.)]?/i)) return "labelName";
      if (stream.match(/^@\w+/)) return "keyword";
      if (stream.match(/^-?\s*[A-Z][\w ]{1,24}:/)) return "propertyName";
    }
    if (stream.eatSpace()) return null;
    if (stream.match(/^\[\s*\d+\s*\]|^\(\s*\d+\s*(?:sts?|sc|stitches)?\s*\)/)) return "number";
    if (stream.match(/^#[0-9a-f]{6}\b/i)) return "atom";
    if (stream.match(/^\d+(?:\.\d+)?\s*(?:mm|cm|m|in|g|oz)\b/i)) return "unit";
    if (stream.match(/^\d+/)) return "number";
    if (stream.match(STITCH)) return "keyword";
    if (stream.match(/^color\b|^change to\b|^with colou?r\b/i)) return "atom";
    if (stream.match(/^[\p{L}_]+/u)) return null;
    stream.next();
    return null;
  },
});
