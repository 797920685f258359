// Keeps what is known of the world's solids up to date: asks for them, part by part, whenever the simulator says that they are others. Passive.
import type { Triple } from "../description.ts";
import type { GeometryPart, Solid } from "./solids.ts";

export class WorldKeeper {
  private known: number | undefined;
  private asks = false;
  private failed_ms = -Infinity;

  // `part`: the solids from this one on.
  constructor(
    private readonly part: (first: number) => Promise<GeometryPart>,
    private readonly show: (solids: Solid[], floorColour: Triple) => void,
    private readonly failed: (error: Error) => void,
  ) {}

  // It may be another simulator, which counts anew.
  forget(): void {
    this.known = undefined;
  }

  // The simulator has this geometry by now.
  async take(geometry: number, now_ms: number): Promise<void> {
    if (geometry === this.known || this.asks || now_ms - this.failed_ms < 2000) return;
    this.asks = true;
    try {
      const { solids, floorColour, number } = await this.all();
      this.known = number;
      this.show(solids, floorColour);
    } catch (error) {
      this.failed_ms = now_ms;
      this.failed(error as Error);
    } finally {
      this.asks = false;
    }
  }

  // Where it changes meanwhile, from the beginning.
  private async all(): Promise<{ solids: Solid[]; floorColour: Triple; number: number }> {
    const solids: Solid[] = [];
    let number: number | undefined;
    for (;;) {
      const part = await this.part(solids.length);
      if (number !== undefined && part.geometry !== number) {
        solids.length = 0;
        number = undefined;
        continue;
      }
      number = part.geometry;
      solids.push(...part.solids);
      if (solids.length >= part.total) return { solids, floorColour: part.floorColour, number };
      if (part.solids.length === 0) throw new Error(`the world has ${part.total} solids, of which only ${solids.length} came`);
    }
  }
}
