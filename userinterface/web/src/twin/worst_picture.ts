// The picture of the worst simulated robot; a click opens it large, above the view.
import { openAbove } from "../above_page.ts";
import { button, element } from "../dom.ts";

const caption = "The worst of the simulated robots";

export class WorstPicture {
  readonly figure: HTMLElement;
  private readonly canvas = element("canvas", { id: "twin-worst", role: "img", "aria-label": caption });
  private large: { dialog: HTMLDialogElement; canvas: HTMLCanvasElement } | undefined;

  constructor() {
    const press = button("", () => this.open(), { class: "enlarge", id: "twin-worst-open", title: "Show it large", "aria-haspopup": "dialog" });
    press.append(this.canvas);
    this.figure = element("figure", { class: "worst", hidden: true }, press, element("figcaption", {}, `${caption}. Click it to see it large.`));
  }

  // PNG. The page's policy lets no image come from a blob: it is decoded and drawn.
  async show(png: Uint8Array<ArrayBuffer>): Promise<void> {
    const bitmap = await createImageBitmap(new Blob([png], { type: "image/png" }));
    this.canvas.width = bitmap.width;
    this.canvas.height = bitmap.height;
    this.canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
    bitmap.close();
    this.figure.hidden = false;
    if (this.large) this.copyTo(this.large.canvas);
  }
  // It is of something else than what is told of now.
  hide(): void {
    this.figure.hidden = true;
    this.large?.dialog.close();
  }

  private open(): void {
    if (this.large) return;
    const canvas = element("canvas", { id: "twin-worst-large", role: "img", "aria-label": caption });
    const dialog = element("dialog", { class: "large-picture", id: "twin-worst-dialog", "aria-label": caption });
    dialog.append(canvas, button("Close", () => dialog.close(), { class: "plain", id: "twin-worst-close" }));
    canvas.addEventListener("click", () => dialog.close());
    this.copyTo(canvas);
    this.large = { dialog, canvas };
    openAbove(dialog, () => (this.large = undefined));
  }

  private copyTo(canvas: HTMLCanvasElement): void {
    canvas.width = this.canvas.width;
    canvas.height = this.canvas.height;
    canvas.getContext("2d")?.drawImage(this.canvas, 0, 0);
  }
}
