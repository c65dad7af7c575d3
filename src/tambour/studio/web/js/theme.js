// Light, dark, or as the machine has it.
import { computed, signal } from "../lib/ui.js";

const ORDER = /** @type {const} */ (["auto", "light", "dark"]);
const machine = matchMedia("(prefers-color-scheme: dark)");
const systemDark = signal(machine.matches);
machine.addEventListener("change", () => (systemDark.value = machine.matches));

/** What was chosen. */
export const theme = signal(/** @type {string} */ (read()));
/** Whether it is dark now. */
export const night = computed(() => theme.value === "dark" || (theme.value === "auto" && systemDark.value));

night.subscribe((dark) => (document.documentElement.dataset.theme = dark ? "dark" : "light"));

export function turnTheme() {
  theme.value = ORDER[(ORDER.indexOf(/** @type {any} */ (theme.value)) + 1) % 3];
  try {
    localStorage.setItem("tambour.theme", theme.value);
  } catch {
    // a browser that keeps nothing: it is chosen again next time
  }
}

function read() {
  try {
    return localStorage.getItem("tambour.theme") ?? "auto";
  } catch {
    return "auto";
  }
}
