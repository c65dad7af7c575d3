// A press beside a dialog closes it. One that began inside, as when words are chosen and the hand lets go outside, does not.

/** The modal dialog that an event is beside. @param {MouseEvent} event @returns {HTMLDialogElement|null} */
function beside(event) {
  const box = /** @type {HTMLDialogElement} */ (event.target);
  if (!box.matches("dialog:modal")) return null;
  const r = box.getBoundingClientRect();
  return event.clientX < r.left || event.clientX > r.right || event.clientY < r.top || event.clientY > r.bottom ? box : null;
}

/** @param {HTMLElement} over where dialogs stand */
export function closing(over) {
  let down = /** @type {HTMLDialogElement|null} */ (null);
  over.addEventListener("pointerdown", (event) => (down = beside(event)));
  over.addEventListener("click", (event) => {
    const box = beside(event);
    if (box && box === down) box.close();
  });
}
