// The tools that take what a pointer does in the picture: one at a time, or none, and then the camera has it.

export interface PictureTool {
  setOn(on: boolean): void;
}

export class PictureTools {
  private readonly tools: PictureTool[] = [];

  add(...tools: PictureTool[]): void {
    this.tools.push(...tools);
  }

  // This one has been turned on: the others are turned off.
  choose(chosen: PictureTool): void {
    for (const tool of this.tools) if (tool !== chosen) tool.setOn(false);
  }
}
