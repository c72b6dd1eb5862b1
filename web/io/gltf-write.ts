import { faceCount, type Model } from '../core/model';
import { buildGltf } from './gltf-build';
import { packGltf } from './gltf-container';
import { ownMorphs } from './gltf-morphs';
import type { GltfExtra } from './gltf-read';
import { rewriteGltf } from './gltf-rewrite';
import { ownRig } from './gltf-rig-write';

/**
 * glTF 2.0 as one file. What came from glTF and still has its triangles goes back into its own document: names,
 * transforms, materials, pictures, skins and animations stay. Anything else becomes a document with a single
 * mesh, its morphs as targets, its joints as a skin.
 */
export function writeGltf(model: Model, format: 'glb' | 'gltf'): Uint8Array {
  const extra = ownDocument(model);
  const { json, binary } = extra
    ? rewriteGltf(model, extra)
    : buildGltf(model, ownMorphs(model), ownRig(model));
  return packGltf(json, binary, format);
}

function ownDocument({ origin, positions, ...model }: Model): GltfExtra | undefined {
  if (origin?.format !== 'glb' && origin?.format !== 'gltf') return undefined;
  const extra = origin.extra as GltfExtra;
  const kept =
    extra.positions.length === positions.length &&
    3 * faceCount({ ...model, positions }) === extra.faceVertices.length &&
    sameIndices(extra.faceVertices, model.faceVertices);
  return kept ? extra : undefined;
}

const sameIndices = (a: Uint32Array, b: Uint32Array): boolean =>
  a === b || (a.length === b.length && a.every((value, i) => value === b[i]));
