// The tools that take what a pointer does in the picture: one at a time, or none, and then the camera has it.

export interface PictureTool {
  readonly on: boolean;
  setOn(on: boolean): void;
}

export class PictureTools {
  private readonly tools: PictureTool[] = [];
  private before: PictureTool | undefined; // the one whose place the present one has taken

  add(...tools: PictureTool[]): void {
    this.tools.push(...tools);
  }

  // This one is turned on: the other is turned off for as long.
  choose(chosen: PictureTool): void {
    const other = this.tools.find((tool) => tool !== chosen && tool.on);
    other?.setOn(false);
    this.before = other;
  }

  // A person has done with this one: the one before has its turn again.
  done(tool: PictureTool): void {
    if (!tool.on) return;
    const { before } = this;
    tool.setOn(false);
    before?.setOn(true);
  }
}
