import type { Model } from '../../core/model';
import { type Groom, strandCount } from '../../core/strands';
import { type AbcObject, type Compound, MetadataList, topObject } from './alembic-tree';
import { bounds, type Curves, curveCount, curvesOf, curvesToWrite, greatest, pointCount } from './curves';
import { engineGroups } from './groups';
import { closestGuides } from './guides';
import { OgawaWriter } from './ogawa';
import type { StrandWriteOptions } from './options';
import { type HeadMesh, headMesh, headToWrite } from './space';

// Alembic curves with the attributes of Unreal's groom schema 1.5 (Epic Games, "Using Alembic for Grooms").

/** Engines refuse strands of more points. */
export const MOST_POINTS = 255;
/** The version of Alembic whose files these are: 1.8.12. */
const LIBRARY = 10812;
const GEOM_BASE = 'schemaBaseType=AbcGeom_GeomBase_v1';
const CURVE = 'AbcGeom_Curve_v2';
const MESH = 'AbcGeom_PolyMesh_v1';
const POINTS = 'geoScope=vtx;interpretation=point';

/** Which guides lead a strand: 3 numbers and 3 weights per strand. */
interface Led {
  readonly guideIds: Int32Array;
  readonly weights: Float32Array;
}

/**
 * The strands as one curves object, the guides as another (engines do not draw those, so they are there twice) and
 * the head as a mesh.
 */
export function writeAlembic(groom: Groom, options: StrandWriteOptions): Uint8Array {
  const strands = curvesToWrite(groom, options, MOST_POINTS);
  const head = headToWrite(groom, options);
  const guides = guidesOf(groom, options);
  const objects = [
    curvesObject('Strands', strands, options.guidesOnly === true, guides && led(groom, strands, guides)),
    ...(guides ? [curvesObject('Guides', guides.curves, true)] : []),
    ...(head ? [headObject(head)] : []),
  ];
  const file = new OgawaWriter(32 * (pointCount(strands) + (guides ? pointCount(guides.curves) : 0)) + 65536);
  const metadata = new MetadataList();
  const top = topObject(file, metadata, objects);
  const text = (content: string) => file.data(new TextEncoder().encode(content));
  const root = file.group([
    file.data(new Uint8Array(4)),
    file.data(new Uint8Array(Int32Array.of(LIBRARY).buffer)),
    top,
    text('_ai_AlembicVersion=Alembic 1.8.12;_ai_Application=Lissom'),
    file.data(everyFrame()),
    file.data(metadata.bytes()),
  ]);
  return file.finish(root);
}

/** One time sampling, that of things that do not move: a frame a second from 0 on. */
function everyFrame(): Uint8Array {
  const view = new DataView(new ArrayBuffer(24));
  view.setUint32(0, 1, true);
  view.setFloat64(4, 1, true);
  view.setUint32(12, 1, true);
  return new Uint8Array(view.buffer);
}

/** The groom's guides, numbered after its strands; none where only guides are written anyway. */
function guidesOf(groom: Groom, options: StrandWriteOptions): Guides | undefined {
  if (options.guidesOnly || !groom.guides) return undefined;
  const curves = curvesOf(groom, groom.guides, options, MOST_POINTS);
  const first = strandCount(groom.strands);
  if (curveCount(curves) === 0) return undefined;
  return { curves: { ...curves, ids: curves.ids.map((_, place) => first + place) }, strands: curves.ids };
}

interface Guides {
  readonly curves: Curves;
  /** The strand that each is. */
  readonly strands: Uint32Array;
}

function led(groom: Groom, strands: Curves, guides: Guides): Led {
  const groups = groom.strands.groups && engineGroups(groom.strands.groups);
  const { places, weights } = closestGuides(groom.strands, guides.strands, groups);
  const from = (i: number) => 3 * strands.ids[(i / 3) | 0]! + (i % 3);
  const length = 3 * curveCount(strands);
  return {
    guideIds: Int32Array.from({ length }, (_, i) => guides.curves.ids[places[from(i)]!]!),
    weights: Float32Array.from({ length }, (_, i) => weights[from(i)]!),
  };
}

function curvesObject(name: string, curves: Curves, areGuides: boolean, led?: Led): AbcObject {
  return {
    name,
    metadata: `schema=${CURVE};${GEOM_BASE};schemaObjTitle=${CURVE}:.geom`,
    properties: (object) =>
      object.compound(
        '.geom',
        (geom) => writeCurves(geom, curves, areGuides, led),
        `schema=${CURVE};${GEOM_BASE}`,
      ),
  };
}

function writeCurves(geom: Compound, curves: Curves, areGuides: boolean, led: Led | undefined): void {
  const { offsets, points, widths } = curves;
  writeBounds(geom, points, greatest(widths) / 2);
  geom.array('P', 'float32', points, 3, POINTS);
  const counts = Int32Array.from({ length: curveCount(curves) }, (_, i) => offsets[i + 1]! - offsets[i]!);
  geom.array('nVertices', 'int32', counts);
  // Linear, not periodic, without a basis.
  geom.scalar('curveBasisAndType', 'uint8', Uint8Array.of(1, 0, 0, 0));
  geom.param('width', 'vtx', 'float32', widths);
  geom.compound('.arbGeomParams', (params) => writeGroomParams(params, curves, areGuides, led));
  // What holds for the groom as a whole is read from here, as single values.
  geom.compound('.userProperties', (properties) => {
    properties.scalar('groom_version_major', 'int16', Int16Array.of(1));
    properties.scalar('groom_version_minor', 'int16', Int16Array.of(5));
    properties.text('groom_tool', 'Lissom');
  });
}

function writeGroomParams(params: Compound, curves: Curves, areGuides: boolean, led: Led | undefined): void {
  const { offsets, colors, ids, rootUvs, groups } = curves;
  params.param('groom_guide', 'con', 'int32', Int32Array.of(areGuides ? 1 : 0));
  params.param('groom_id', 'uni', 'int32', ids);
  params.param('groom_group_id', 'uni', 'int32', groups ? engineGroups(groups) : new Int32Array(ids.length));
  if (groups) params.param('groom_clumpid', 'uni', 'int32', groups);
  if (rootUvs) params.param('groom_root_uv', 'uni', 'float32', rootUvs, 2);
  if (led) {
    params.param('groom_closest_guides', 'uni', 'int32', led.guideIds, 3);
    params.param('groom_guide_weights', 'uni', 'float32', led.weights, 3);
  }
  const perPoint = new Float32Array(3 * pointCount(curves));
  for (let i = 0; i < ids.length; i++)
    for (let p = offsets[i]!; p < offsets[i + 1]!; p++)
      for (let k = 0; k < 3; k++) perPoint[3 * p + k] = colors[3 * i + k]!;
  params.param('groom_color', 'vtx', 'float32', perPoint, 3);
}

function headObject(head: Model): AbcObject {
  return {
    name: 'Head',
    metadata: `schema=${MESH};${GEOM_BASE};schemaObjTitle=${MESH}:.geom`,
    properties: (object) =>
      object.compound('.geom', (geom) => writeMesh(geom, head), `schema=${MESH};${GEOM_BASE}`),
  };
}

function writeMesh(geom: Compound, head: Model): void {
  const { points, counts, corners, uvs } = clockwise(headMesh(head));
  writeBounds(geom, points, 0);
  geom.array('P', 'float32', points, 3, POINTS);
  geom.array('.faceIndices', 'int32', corners);
  geom.array('.faceCounts', 'int32', counts);
  if (uvs) geom.param('uv', 'fvr', 'float32', uvs, 2);
}

/** Alembic's faces turn clockwise seen from outside. */
function clockwise(mesh: HeadMesh): HeadMesh {
  const { counts, uvs } = mesh;
  const corners = mesh.corners.slice();
  const turnedUvs = uvs?.slice();
  let start = 0;
  for (const count of counts) {
    for (let k = 0; k < count; k++) {
      const from = start + count - 1 - k;
      corners[start + k] = mesh.corners[from]!;
      if (uvs) turnedUvs!.set(uvs.subarray(2 * from, 2 * from + 2), 2 * (start + k));
    }
    start += count;
  }
  return { ...mesh, corners, ...(turnedUvs && { uvs: turnedUvs }) };
}

function writeBounds(geom: Compound, points: Float32Array, margin: number): void {
  const { min, max } = bounds(points, margin);
  geom.scalar('.selfBnds', 'float64', Float64Array.of(...min, ...max), 'interpretation=box');
}
