// The pattern's text: CodeMirror in a shadow root, so that its sheets need no exception in the page's policy.
import {
  Decoration, EditorState, EditorView, HighlightStyle, StateEffect, StateField, StreamLanguage, defaultKeymap, drawSelection,
  highlightActiveLine, hoverTooltip, keymap, lineNumbers, lintGutter, setDiagnostics, syntaxHighlighting, tags,
} from "../../lib/editor.js";
import { crochet } from "./language.js";

/** @typedef {import("../wire.js").Problem} Problem */

const LOOK = HighlightStyle.define([
  { tag: tags.heading, color: "var(--ink)", fontWeight: "700", fontSize: "1.12em" },
  { tag: tags.labelName, color: "var(--ink)", fontWeight: "600" },
  { tag: tags.propertyName, color: "var(--ink)", fontWeight: "600" },
  { tag: tags.keyword, color: "var(--word)" },
  { tag: tags.number, color: "var(--number)" },
  { tag: tags.unit, color: "var(--number)" },
  { tag: tags.atom, color: "var(--leaf)" },
  { tag: tags.comment, color: "var(--note)", fontStyle: "italic" },
]);

const THEME = EditorView.theme({
  "&": { height: "100%", fontSize: "14px", background: "var(--card)", color: "var(--ink)" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.6", overflow: "auto" },
  ".cm-content": { padding: "14px 10px 40vh 0", caretColor: "var(--thread)" },
  "&.cm-focused": { outline: "none" },
  "&.cm-focused .cm-scroller": { boxShadow: "inset 2px 0 var(--focus)" },
  ".cm-gutters": { background: "var(--card)", color: "var(--soft)", border: "none", paddingLeft: "6px" },
  ".cm-activeLine, .cm-activeLineGutter": { background: "color-mix(in srgb, var(--sunk) 60%, transparent)" },
  ".cm-here": { background: "var(--thread-wash)", borderRadius: "3px", boxShadow: "0 0 0 2px var(--thread-wash)" },
  ".cm-next": { textDecoration: "underline 2px var(--thread)", textUnderlineOffset: "4px" },
  ".cm-tooltip": { background: "var(--card)", color: "var(--ink)", border: "1px solid var(--line)", borderRadius: "9px", boxShadow: "var(--shade)", overflow: "hidden" },
  ".cm-tooltip-hover .cm-told": { padding: "7px 11px", fontFamily: "var(--sans)", fontSize: "13.5px" },
  ".cm-diagnostic": { fontFamily: "var(--sans)", fontSize: "13.5px", padding: "7px 11px", whiteSpace: "pre-wrap", maxWidth: "420px" },
  ".cm-diagnostic-error": { borderLeft: "4px solid var(--thread)" },
  ".cm-diagnostic-warning": { borderLeft: "4px solid var(--amber)" },
  ".cm-lintRange-error": { backgroundImage: "none", textDecoration: "underline wavy 1.5px var(--thread)", textUnderlineOffset: "4px" },
  ".cm-lintRange-warning": { backgroundImage: "none", textDecoration: "underline wavy 1.5px var(--amber)", textUnderlineOffset: "4px" },
  ".cm-lint-marker": { width: "11px", height: "11px", marginTop: "5px" },
  ".cm-lint-marker-error": { content: "none", background: "var(--thread)", borderRadius: "50%" },
  ".cm-lint-marker-warning": { content: "none", background: "var(--amber)", borderRadius: "50%" },
  ".cm-cursor": { borderLeftColor: "var(--thread)", borderLeftWidth: "2px" },
  ".cm-selectionBackground, &.cm-focused .cm-selectionBackground": { background: "color-mix(in srgb, var(--focus) 26%, transparent) !important" },
});

const markHere = StateEffect.define();
const marks = StateField.define({
  create: () => Decoration.none,
  update(held, change) {
    let now = held.map(change.changes);
    for (const effect of change.effects)
      if (effect.is(markHere)) {
        const n = change.newDoc.length;
        const all = effect.value.filter((/** @type {any} */ m) => m.from < m.to && m.to <= n).map((/** @type {any} */ m) => Decoration.mark({ class: m.kind }).range(m.from, m.to));
        now = Decoration.set(all, true);
      }
    return now;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** Code points to places in a JavaScript text, and back. @param {string} text */
export function places(text) {
  const plain = !/[\ud800-\udbff]/.test(text);
  return {
    /** @param {number} point */
    at: (point) => (plain ? point : [...text].slice(0, point).join("").length),
    /** @param {number} place */
    point: (place) => (plain ? place : [...text.slice(0, place)].length),
  };
}

export class Editor {
  /**
   * @param {HTMLElement} host
   * @param {{text: string, own: boolean, onchange: (text: string) => void, back: (way: "undo"|"redo") => void, onspot: (point: number) => void, tell: (point: number) => string|null}} how
   * own: it is tambour's own language; back: undo and redo, of the piece: there is one row of changes, whatever made them; onspot: the caret was moved by hand; tell: what is made at a place, for the hover
   */
  constructor(host, { text, own, onchange, back, onspot, tell }) {
    const shadow = host.attachShadow({ mode: "open" });
    const frame = document.createElement("div");
    shadow.append(frame);
    this.quiet = false;
    const hover = hoverTooltip((_, pos) => {
      const told = tell(places(this.text).point(pos));
      if (!told) return null;
      const line = this.view.state.doc.lineAt(pos);
      return { pos: line.from, end: line.to, above: true, create: () => {
        const dom = document.createElement("div");
        dom.className = "cm-told";
        dom.textContent = told;
        return { dom };
      } };
    }, { hoverTime: 250 });
    this.view = new EditorView({
      root: shadow,
      parent: frame,
      state: EditorState.create({ doc: text, extensions: [
        lineNumbers(), lintGutter(), drawSelection(), highlightActiveLine(), marks, EditorView.lineWrapping, THEME,
        StreamLanguage.define(/** @type {any} */ (crochet(own))), syntaxHighlighting(LOOK), hover,
        keymap.of([
          { key: "Mod-z", run: () => (back("undo"), true), preventDefault: true }, { key: "Mod-Shift-z", run: () => (back("redo"), true), preventDefault: true },
          { key: "Mod-y", run: () => (back("redo"), true), preventDefault: true }, ...defaultKeymap,
        ]),
        EditorView.contentAttributes.of({ "aria-label": "the pattern", spellcheck: "false", autocapitalize: "off" }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged && !this.quiet) onchange(this.text);
          else if (update.selectionSet && update.transactions.some((t) => t.isUserEvent("select"))) onspot(places(this.text).point(update.state.selection.main.head));
        }),
      ] }),
    });
    frame.style.height = "100%";
  }

  get text() {
    return this.view.state.doc.toString();
  }

  /** Another text, from undo or another page: only what differs changes, the caret stays. @param {string} text @param {boolean} [look] what became otherwise comes into sight */
  set(text, look = false) {
    const now = this.text;
    if (text === now) return;
    let from = 0, end = now.length, to = text.length;
    while (from < Math.min(end, to) && now[from] === text[from]) from++;
    while (end > from && to > from && now[end - 1] === text[to - 1]) (end--, to--);
    this.quiet = true;
    this.view.dispatch({ changes: { from, to: end, insert: text.slice(from, to) }, ...(look ? { effects: EditorView.scrollIntoView(from, { y: "center" }) } : {}) });
    this.quiet = false;
  }

  /** Underline problems. @param {Problem[]} problems */
  problems(problems) {
    const text = this.text, { at } = places(text), doc = this.view.state.doc;
    const found = problems.flatMap((p) => {
      let from, to;
      if (p.span) [from, to] = [at(p.span[0]), at(p.span[1])];
      else if (p.line && p.line <= doc.lines) {
        const line = doc.line(p.line);
        from = Math.min(line.to, line.from + Math.max(0, (p.column ?? 1) - 1));
        to = p.length ? from + p.length : line.to;
      } else return [];
      from = Math.min(from, doc.length);
      to = Math.min(Math.max(to, from + 1), doc.length);
      return [{ from: Math.min(from, to), to, severity: /** @type {"error"|"warning"} */ (p.warning ? "warning" : "error"), message: p.message + (p.hint ? `\n${p.hint}` : "") }];
    });
    this.view.dispatch(setDiagnostics(this.view.state, found.sort((a, b) => a.from - b.from)));
  }

  /** Mark the round that is being worked, and the stitch that is next. @param {[number, number]|null|undefined} round @param {[number, number]|null} [next] */
  mark(round, next) {
    const { at } = places(this.text), all = [];
    if (round) all.push({ from: at(round[0]), to: at(round[1]), kind: "cm-here" });
    if (next) all.push({ from: at(next[0]), to: at(next[1]), kind: "cm-next" });
    this.view.dispatch({ effects: markHere.of(all) });
  }

  /** Show what was just written by other means than keys. @param {number} from @param {number} length in characters of JavaScript */
  show(from, length) {
    const to = Math.min(from + length, this.view.state.doc.length);
    this.view.dispatch({ effects: [EditorView.scrollIntoView(from, { y: "center" }), markHere.of([{ from, to, kind: "cm-here" }])] });
  }

  /** @param {number} point @param {boolean} [focus] */
  reveal(point, focus = false) {
    const pos = Math.min(places(this.text).at(point), this.view.state.doc.length);
    this.view.dispatch({ effects: EditorView.scrollIntoView(pos, { y: "center" }), ...(focus ? { selection: { anchor: pos } } : {}) });
    if (focus) this.view.focus();
  }
}
