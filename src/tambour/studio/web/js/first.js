// Before the first picture: light or dark as theme.js has it, and no shelf where a piece is to be opened.
(() => {
  let chosen = "";
  try {
    chosen = localStorage.getItem("tambour.theme") ?? "";
  } catch {} // no storage: as the machine has it
  const dark = chosen === "dark" || (chosen !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  if (location.hash.length > 1) document.documentElement.classList.add("opening");
})();
