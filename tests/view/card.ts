// A graphics card that keeps count, for tests of layers without a browser.

import {
  BufferGeometry,
  type EventDispatcher,
  type IUniform,
  Material,
  type Object3D,
  RenderTarget,
  Texture,
  Vector3,
  type WebGLRenderer,
} from 'three';
import type { Layer, LayerContext, LayerKind } from '../../web/view/layer';

type Held = EventDispatcher<{ dispose: object }>;

/** What a layer is given where nothing is drawn: one drawn unit is a hundred CSS pixels, y up, seen along −z. */
export function contextOf(parts: Partial<LayerContext> = {}): LayerContext {
  const gl = { getExtension: () => null, getParameter: () => 'a card', RENDERER: 0 };
  return {
    renderer: {
      getContext: () => gl,
      capabilities: { maxTextureSize: 4096 },
      domElement: { style: {} },
    } as unknown as WebGLRenderer,
    test: true,
    redraw: () => {},
    reshaped: () => {},
    settle: () => {},
    onScreen: ({ x, y, z }) => new Vector3(100 * x, -100 * y, 5 - z),
    ...parts,
  };
}

/** A layer of a kind, by itself. */
export const made = <P>(kind: LayerKind<P>, parts: Partial<LayerContext> = {}): Layer & P =>
  kind.make(contextOf(parts));

/** Everything of a layer that the card has to be told to forget. */
export function heldBy(layer: Layer): Set<Held> {
  const held = new Set<Held>();
  const take = (value: unknown): void => {
    if (value instanceof BufferGeometry || value instanceof RenderTarget) held.add(value);
    // The texture of a target goes with it.
    if (value instanceof Texture) held.add(value.renderTarget ?? value);
    if (value instanceof Material) {
      held.add(value);
      takeAll((value as { uniforms?: Record<string, IUniform> }).uniforms);
    }
  };
  const takeAll = (uniforms: Readonly<Record<string, IUniform>> = {}): void => {
    for (const { value } of Object.values(uniforms)) take(value);
  };
  layer.group.traverse((part: Object3D & { geometry?: unknown; material?: unknown }) => {
    take(part.geometry);
    take(part.material);
  });
  takeAll(layer.shade?.uniforms);
  return held;
}

/** Those of a layer's things that it does not free when it is disposed of, by name. */
export function leftBy(layer: Layer): string[] {
  const left = heldBy(layer);
  for (const each of left) each.addEventListener('dispose', () => left.delete(each));
  layer.dispose();
  return Array.from(left, (each) => each.constructor.name);
}
