// Asks for the token, as often as it takes. It is kept in memory only.
import { byId, setText } from "./dom.ts";

export function askForToken(why: string): Promise<string> {
  const dialog = byId<HTMLDialogElement>("token");
  const text = byId<HTMLInputElement>("token-text");
  setText(byId("token-why"), why);
  text.value = "";
  return new Promise((resolve) => {
    // Nothing can be done without it, so the dialog stays.
    dialog.oncancel = (event) => event.preventDefault();
    dialog.onclose = () => {
      if (text.value === "") dialog.showModal();
      else resolve(text.value.trim());
    };
    dialog.showModal();
    text.focus();
  });
}
