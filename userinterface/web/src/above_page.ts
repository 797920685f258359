// What opens above the page without being modal: the stops are reached as ever, by pointer and by key. Escape closes it, and stops.

// `closed` is called whichever way it closes.
export function openAbove(dialog: HTMLDialogElement, closed: () => void): void {
  const key = (event: KeyboardEvent) => event.key === "Escape" && dialog.close(); // the stop goes further
  window.addEventListener("keydown", key, { capture: true });
  dialog.classList.add("above");
  dialog.addEventListener("close", () => {
    window.removeEventListener("keydown", key, { capture: true });
    dialog.remove();
    closed();
  });
  document.body.append(dialog);
  dialog.show();
}
