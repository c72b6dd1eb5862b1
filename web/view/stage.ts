import { type BufferGeometry, Group, type Scene, type WebGLRenderer } from 'three';
import { Background } from './background';
import { Grid } from './grid';
import { GroundShadow } from './ground-shadow';
import { PALETTES, type Palette } from './palette';
import { ENVIRONMENT, evenLight, KEY_SLANT, Studio } from './studio';
import type { ViewSpace } from './view-space';

/** Everything around the model: backdrop, ground with grid and shadows, light. */
export class Stage {
  readonly #background = new Background();
  readonly #grid = new Grid();
  readonly #floor = new Group();
  #palette: Palette = PALETTES.dark;
  readonly #contact = new GroundShadow({ height: 0.6, falloff: 2, slant: [0, 0], blurs: [1.6, 0.8] });
  readonly #cast = new GroundShadow({ height: 2.4, falloff: 1.2, slant: KEY_SLANT, blurs: [1.8, 1] });
  readonly #studio: Studio;
  #ground = -1;
  #shadowsStale = false;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly scene: Scene,
    /** An even light in place of the room's: computing that takes software rendering seconds. */
    private readonly plain = false,
  ) {
    this.#studio = new Studio(renderer);
    if (plain) scene.add(evenLight());
    else scene.environment = this.#studio.environment();
    scene.environmentIntensity = ENVIRONMENT;
    this.#floor.add(this.#contact.mesh, this.#cast.mesh, this.#grid.mesh);
    scene.add(this.#background.mesh, this.#floor, this.#studio.lights);
    this.setModel(undefined);
  }

  setPalette(palette: Palette): void {
    this.renderer.toneMappingExposure = palette.exposure;
    this.#palette = palette;
    this.#paintBackground();
    this.#grid.setPalette(palette);
    this.#contact.setStrength(palette.shadowStrength);
    this.#cast.setStrength(0.6 * palette.shadowStrength);
  }

  showGrid(shown: boolean): void {
    this.#grid.mesh.visible = shown;
  }

  /** A studio, or the bare sheet of a drawing: no grid, no shadows. */
  showGround(shown: boolean): void {
    if (shown === this.#floor.visible) return;
    this.#floor.visible = shown;
    this.#paintBackground();
  }

  /** The ground lies just below the lowest of the model's places (3 numbers each, drawn units). */
  setModel(model: { readonly space: ViewSpace; readonly places: Float32Array } | undefined): void {
    this.#contact.mesh.visible = model !== undefined;
    this.#cast.mesh.visible = model !== undefined;
    if (!model) return;
    let low = Infinity;
    for (let i = 1; i < model.places.length; i += 3) low = Math.min(low, model.places[i]!);
    this.#ground = low - 0.004;
    this.#grid.place(model.space, this.#ground);
    this.shapeChanged();
  }

  /** The shadows are drawn again with the next picture. */
  shapeChanged(): void {
    this.#shadowsStale = true;
  }

  prepare(model: BufferGeometry | undefined): void {
    if (!this.#shadowsStale || !model) return;
    this.#contact.update(this.renderer, model, this.#ground);
    this.#cast.update(this.renderer, model, this.#ground);
    this.renderer.shadowMap.needsUpdate = true;
    this.#shadowsStale = false;
  }

  /** After the graphics card has lost everything. */
  restore(): void {
    if (!this.plain) this.scene.environment = this.#studio.environment();
    this.shapeChanged();
  }

  dispose(): void {
    for (const part of [this.#background, this.#grid, this.#contact, this.#cast, this.#studio])
      part.dispose();
  }

  #paintBackground(): void {
    const { sky, floor, sheet } = this.#palette;
    if (this.#floor.visible) this.#background.set(sky, floor);
    else this.#background.set(...sheet);
  }
}
