import type { Model } from '../../core/model';
import type { Groom } from '../../core/strands';
import { ByteWriter } from '../byte-writer';
import { bounds, type Curves, curveCount, curvesToWrite, greatest, pointCount } from './curves';
import { FixedText, placesFor } from './fixed-text';
import { engineGroups } from './groups';
import type { StrandWriteOptions } from './options';
import { headMesh, headToWrite } from './space';

// Universal Scene Description as text: a BasisCurves prim for the strands and a Mesh prim for the head. Normals are
// left out on purpose: with them the curves would be ribbons, not tubes.

type Interpolation = 'uniform' | 'vertex' | 'faceVarying' | '';

export function writeUsd(groom: Groom, options: StrandWriteOptions): Uint8Array {
  const curves = curvesToWrite(groom, options);
  const head = headToWrite(groom, options);
  const out = new ByteWriter(48 * pointCount(curves));
  const usd = new UsdText(out);
  usd.line('#usda 1.0');
  usd.line('(\n    defaultPrim = "Hair"\n    metersPerUnit = 0.01\n    upAxis = "Y"\n)\n');
  usd.line('def Xform "Hair" (\n    kind = "component"\n)\n{');
  writeStrands(usd, curves, options);
  if (head) writeHead(usd, head);
  usd.line('}');
  usd.flush();
  return out.finish();
}

function writeStrands(usd: UsdText, curves: Curves, { curve = 'linear' }: StrandWriteOptions): void {
  const { offsets, points, widths, colors, ids, rootUvs, groups } = curves;
  usd.line('    def BasisCurves "Strands"\n    {');
  if (curve === 'linear') usd.line('        uniform token type = "linear"');
  else {
    usd.line('        uniform token type = "cubic"');
    usd.line('        uniform token basis = "catmullRom"');
    // Pinned curves reach both end points.
    usd.line('        uniform token wrap = "pinned"');
  }
  const counts = Uint32Array.from({ length: curveCount(curves) }, (_, i) => offsets[i + 1]! - offsets[i]!);
  const coordinates = placesFor(greatest(points));
  usd.integers('int[] curveVertexCounts', counts);
  usd.extent(points, greatest(widths) / 2);
  usd.tuples('point3f[] points', points, 3, coordinates);
  // A width is small beside the head: digits of its own.
  usd.tuples('float[] widths', widths, 1, placesFor(greatest(widths), 6), 'vertex');
  usd.tuples('color3f[] primvars:displayColor', colors, 3, 5, 'uniform');
  if (rootUvs) usd.tuples('texCoord2f[] primvars:st', rootUvs, 2, 7, 'uniform');
  usd.integers('int[] primvars:groom_id', ids, 'uniform');
  if (groups) {
    usd.integers('int[] primvars:groom_clumpid', groups, 'uniform');
    usd.integers('int[] primvars:groom_group_id', engineGroups(groups), 'uniform');
  }
  usd.line('    }');
}

function writeHead(usd: UsdText, head: Model): void {
  const { points, counts, corners, uvs } = headMesh(head);
  usd.line('    def Mesh "Head"\n    {');
  usd.line('        uniform token subdivisionScheme = "none"');
  usd.extent(points, 0);
  usd.integers('int[] faceVertexCounts', counts);
  usd.integers('int[] faceVertexIndices', corners);
  usd.tuples('point3f[] points', points, 3, placesFor(greatest(points)));
  if (uvs) usd.tuples('texCoord2f[] primvars:st', uvs, 2, 7, 'faceVarying');
  usd.line('    }');
}

/** Attributes of prims. Lists have a dozen entries a line, so that the file stays fit for editors. */
class UsdText extends FixedText {
  line(text: string): void {
    this.text(text);
    this.text('\n');
  }

  integers(name: string, values: ArrayLike<number>, interpolation: Interpolation = ''): void {
    this.#open(name);
    for (let i = 0; i < values.length; i++) {
      if (i > 0) this.#comma(i);
      this.integer(values[i]!);
    }
    this.#close(interpolation);
  }

  /** @param size  numbers per entry; from two on they stand in brackets */
  tuples(
    name: string,
    values: ArrayLike<number>,
    size: number,
    places: number,
    interpolation: Interpolation = '',
  ): void {
    this.#open(name);
    for (let i = 0; i < values.length; i++) {
      const k = i % size;
      if (k > 0) this.text(', ');
      else if (i > 0) this.#comma(i / size);
      if (size > 1 && k === 0) this.text('(');
      this.decimal(values[i]!, places);
      if (size > 1 && k === size - 1) this.text(')');
    }
    this.#close(interpolation);
  }

  extent(points: Float32Array, margin: number): void {
    const { min, max } = bounds(points, margin);
    this.tuples('float3[] extent', [...min, ...max], 3, placesFor(greatest([...min, ...max])));
  }

  #open(name: string): void {
    this.text(`        ${name} = [`);
  }

  #comma(entry: number): void {
    this.text(entry % 12 === 0 ? ',\n' : ', ');
  }

  #close(interpolation: Interpolation): void {
    this.text(']');
    if (interpolation) this.text(` (\n            interpolation = "${interpolation}"\n        )`);
    this.text('\n');
  }
}
