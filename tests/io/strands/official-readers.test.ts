import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import type { Groom } from '../../../web/core/strands';
import { chooseGuides, closestGuides, type StrandWriteOptions, writeStrands } from '../../../web/io';
import { findPython } from './python';
import { greatestGap, HEAD, inCentimetres, LOOK, MILLIMETRES, makeGroom } from './support';

// The libraries of the formats' own makers read what is written here.

const python = findPython();
const skipped = python.missing ? ` (skipped: ${python.missing})` : '';

const plain = makeGroom(60, (s) => 2 + (s % 31));
const GROOM: Groom = { ...plain, guides: chooseGuides(plain.strands, 9) };
const HEAD_CM = Array.from(HEAD.positions, (c) => Math.fround(0.1 * c));

let folder: string;
beforeAll(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'lissom-strands-'));
});
afterAll(() => rmSync(folder, { recursive: true }));

function readBack<T>(
  script: string,
  format: 'usda' | 'abc',
  groom: Groom,
  options: Partial<StrandWriteOptions> = {},
): T {
  const file = path.join(folder, `groom.${format}`);
  writeFileSync(file, writeStrands(groom, format, { ...MILLIMETRES, ...options }));
  return python.run(script, [file]) as T;
}

/** Diameters in centimetres by rule: thickness at the root, `taper` of it at the tip. */
function widthsOf({ strands: { offsets } }: Groom): number[] {
  const out: number[] = [];
  for (let s = 0; s + 1 < offsets.length; s++) {
    const segments = offsets[s + 1]! - offsets[s]! - 1;
    for (let k = 0; k <= segments; k++)
      out.push(0.1 * LOOK.thickness * (1 + ((LOOK.taper - 1) * k) / segments));
  }
  return out;
}

const countsOf = ({ strands: { offsets } }: Groom) =>
  [...offsets.slice(1)].map((end, s) => end - offsets[s]!);
const idsOf = ({ strands }: Groom) => countsOf({ strands } as Groom).map((_, s) => s);

const USD = `
import json, sys
from pxr import Usd, UsdGeom
stage = Usd.Stage.Open(sys.argv[1])
def prim(path):
    p = stage.GetPrimAtPath(path)
    if not p: return None
    out = {'prim': str(p.GetTypeName())}
    for a in p.GetAttributes():
        v = a.Get()
        if v is None: continue
        if hasattr(v, '__len__') and not isinstance(v, str):
            v = [x for e in v for x in (e if hasattr(e, '__len__') else [e])]
        out[a.GetName()] = v
        if a.HasMetadata('interpolation'): out[a.GetName() + ':interpolation'] = a.GetMetadata('interpolation')
    return out
strands, head = prim('/Hair/Strands'), prim('/Hair/Head')
curves = UsdGeom.BasisCurves(stage.GetPrimAtPath('/Hair/Strands'))
computed = UsdGeom.Boundable.ComputeExtentFromPlugins(curves, Usd.TimeCode.Default())
print(json.dumps({'strands': strands, 'head': head, 'default': stage.GetDefaultPrim().GetName(),
  'metres': UsdGeom.GetStageMetersPerUnit(stage), 'up': str(UsdGeom.GetStageUpAxis(stage)),
  'extent': [c for v in computed for c in v]}))
`;

interface ReadUsd {
  strands: Record<string, number[] & string>;
  head: Record<string, number[]> | null;
  default: string;
  metres: number;
  up: string;
  extent: number[];
}

describe.skipIf(skipped)(`USD, opened by usd-core${skipped}`, () => {
  test('the stage is in centimetres with y up, the strands keep points, widths and attributes', () => {
    const { strands, default: first, metres, up, extent } = readBack<ReadUsd>(USD, 'usda', GROOM);
    expect([first, metres, up, strands.prim]).toEqual(['Hair', 0.01, 'Y', 'BasisCurves']);
    expect(strands.type).toBe('linear');
    expect([...strands.curveVertexCounts!]).toEqual(countsOf(GROOM));
    expect(greatestGap(strands.points!, inCentimetres(GROOM))).toBeLessThan(2e-6);
    expect(greatestGap(strands.widths!, widthsOf(GROOM))).toBeLessThan(1e-7);
    expect(strands['widths:interpolation']).toBe('vertex');
    expect(strands['primvars:displayColor']!.length).toBe(3 * 60);
    expect(greatestGap(strands['primvars:st']!, GROOM.strands.rootUvs!)).toBeLessThan(1e-6);
    expect(strands['primvars:st:interpolation']).toBe('uniform');
    expect(strands['primvars:groom_id']).toEqual(idsOf(GROOM));
    expect(strands['primvars:groom_group_id']).toEqual([...GROOM.strands.groups!]);
    expect(greatestGap(strands.extent!, extent)).toBeLessThan(1e-5);
    expect(strands.normals).toBeUndefined();
  });

  test('the head lies in the same space', () => {
    const { head } = readBack<ReadUsd>(USD, 'usda', GROOM);
    expect(greatestGap(head!.points!, HEAD_CM)).toBeLessThan(2e-6);
    expect(head!.faceVertexCounts).toEqual([4, 4, 4, 4, 4, 4]);
    expect(head!.faceVertexIndices).toEqual([...HEAD.faceVertices]);
    expect(head!['primvars:st']!.length).toBe(48);
    expect(readBack<ReadUsd>(USD, 'usda', GROOM, { withHead: false }).head).toBeNull();
  });

  test('a cubic through the points is pinned to its ends', () => {
    const { strands } = readBack<ReadUsd>(USD, 'usda', GROOM, { curve: 'catmullRom' });
    expect([strands.type, strands.basis, strands.wrap]).toEqual(['cubic', 'catmullRom', 'pinned']);
  });
});

const ALEMBIC = `
import json, sys
from alembic3d import Abc, AbcGeom
archive = Abc.IArchive(sys.argv[1])
def flat(values):
    out = []
    for e in values:
        if isinstance(e, (int, float, str)): out.append(e)
        elif hasattr(e, '__len__'): out.extend(e[i] for i in range(len(e)))
        elif hasattr(e, 'z'): out.extend([e.x, e.y, e.z])
        elif hasattr(e, 'x'): out.extend([e.x, e.y])
        else: out.append(ord(e) if isinstance(e, str) else int(e))
    return out
KINDS = {('int32', 1): AbcGeom.IInt32GeomParam, ('int32', 3): AbcGeom.IV3iGeomParam, ('float32', 1): AbcGeom.IFloatGeomParam,
  ('float32', 2): AbcGeom.IV2fGeomParam, ('float32', 3): AbcGeom.IV3fGeomParam}
def params(compound):
    out = {}
    for header in compound.propertyheaders:
        name = header.getName()
        data = header.getDataType()
        pod = {'kInt32POD': 'int32', 'kFloat32POD': 'float32'}[str(data.getPod()).split('.')[-1]]
        param = KINDS[(pod, data.getExtent())](compound, name)
        sample = param.getExpandedValue()
        out[name] = {'values': flat(sample.getVals()), 'scope': str(sample.getScope()).split('.')[-1]}
    return out
def curves(o):
    schema = AbcGeom.ICurves(o.getParent(), o.getName()).getSchema()
    sample = schema.getValue()
    box = sample.getSelfBounds()
    width = schema.getWidthsParam().getExpandedValue()
    users = schema.getUserProperties()
    return {'kind': 'curves', 'points': flat(sample.getPositions()), 'counts': flat(sample.getCurvesNumVertices()),
      'type': str(sample.getType()).split('.')[-1], 'basis': str(sample.getBasis()).split('.')[-1], 'wrap': str(sample.getWrap()).split('.')[-1],
      'widths': flat(width.getVals()), 'scope': str(width.getScope()).split('.')[-1],
      'params': params(schema.getArbGeomParams()),
      'bounds': flat([box.min(), box.max()]),
      'major': Abc.IInt16Property(users, 'groom_version_major').getValue(),
      'minor': Abc.IInt16Property(users, 'groom_version_minor').getValue(),
      'tool': Abc.IStringProperty(users, 'groom_tool').getValue(),
      'samples': schema.getNumSamples(), 'constant': schema.isConstant()}
def mesh(o):
    schema = AbcGeom.IPolyMesh(o.getParent(), o.getName()).getSchema()
    sample = schema.getValue()
    uv = schema.getUVsParam()
    return {'kind': 'mesh', 'points': flat(sample.getPositions()), 'counts': flat(sample.getFaceCounts()), 'corners': flat(sample.getFaceIndices()),
      'uvs': flat(uv.getExpandedValue().getVals())}
top = archive.getTop()
print(json.dumps({o.getName(): (curves if AbcGeom.ICurves.matches(o.getMetaData()) else mesh)(o) for o in top.children}))
`;

interface ReadCurves {
  points: number[];
  counts: number[];
  widths: number[];
  params: Record<string, { values: number[]; scope: string }>;
  [name: string]: unknown;
}
interface ReadAlembic {
  Strands: ReadCurves;
  Guides?: ReadCurves;
  Head?: { points: number[]; counts: number[]; corners: number[]; uvs: number[] };
}

describe.skipIf(skipped)(`Alembic, opened by alembic3d${skipped}`, () => {
  test('the strands keep their points to the bit, widths and bounds', () => {
    const { Strands } = readBack<ReadAlembic>(ALEMBIC, 'abc', GROOM);
    expect(Strands).toMatchObject({
      type: 'kLinear',
      basis: 'kNoBasis',
      wrap: 'kNonPeriodic',
      scope: 'kVertexScope',
    });
    expect(Strands).toMatchObject({ samples: 1, constant: true });
    expect(Strands.counts).toEqual(countsOf(GROOM));
    expect(Float32Array.from(Strands.points)).toEqual(inCentimetres(GROOM));
    expect(greatestGap(Strands.widths, widthsOf(GROOM))).toBeLessThan(1e-9);
    const low = Math.min(...Strands.points.filter((_, i) => i % 3 === 1)) - 0.1 * LOOK.thickness * 0.5;
    expect((Strands.bounds as number[])[1]).toBeCloseTo(low, 6);
  });

  test('engines find version, ids, groups, root coordinates and colours', () => {
    const { Strands } = readBack<ReadAlembic>(ALEMBIC, 'abc', GROOM);
    expect(Strands).toMatchObject({ major: 1, minor: 5, tool: 'Lissom' });
    const { params } = Strands;
    expect(params.groom_guide).toEqual({ values: [0], scope: 'kConstantScope' });
    expect(params.groom_id).toEqual({ values: idsOf(GROOM), scope: 'kUniformScope' });
    expect(params.groom_group_id!.values).toEqual([...GROOM.strands.groups!]);
    expect(params.groom_root_uv!.scope).toBe('kUniformScope');
    expect(Float32Array.from(params.groom_root_uv!.values)).toEqual(GROOM.strands.rootUvs);
    expect(params.groom_color!.scope).toBe('kVertexScope');
    expect(params.groom_color!.values.length).toBe(Strands.points.length);
  });

  test('guides are curves of their own, and every strand names three and how much they weigh', () => {
    const { Strands, Guides } = readBack<ReadAlembic>(ALEMBIC, 'abc', GROOM);
    expect(Guides!.params.groom_guide).toEqual({ values: [1], scope: 'kConstantScope' });
    expect(Guides!.counts).toEqual([...GROOM.guides!].map((s) => countsOf(GROOM)[s]));
    expect(Guides!.params.groom_id!.values).toEqual(Array.from({ length: 9 }, (_, i) => 60 + i));
    const { places, weights } = closestGuides(GROOM.strands, GROOM.guides!, GROOM.strands.groups);
    expect(Strands.params.groom_closest_guides).toEqual({
      values: Array.from(places, (place) => 60 + place),
      scope: 'kUniformScope',
    });
    expect(Float32Array.from(Strands.params.groom_guide_weights!.values)).toEqual(weights);
  });

  test('the head lies in the same space, its faces turned as Alembic turns them', () => {
    const { Head } = readBack<ReadAlembic>(ALEMBIC, 'abc', GROOM);
    expect(Head!.points.map(Math.fround)).toEqual(HEAD_CM);
    expect(Head!.counts).toEqual([4, 4, 4, 4, 4, 4]);
    expect(Head!.corners.slice(0, 4)).toEqual([1, 2, 3, 0]);
    expect(Head!.uvs.slice(0, 8)).toEqual([0, 1, 1, 1, 1, 0, 0, 0]);
    expect(readBack<ReadAlembic>(ALEMBIC, 'abc', GROOM, { withHead: false }).Head).toBeUndefined();
  });

  test('guides alone are one object, marked as guides, and no strand has more than 255 points', () => {
    const long = makeGroom(3, () => 700, { guides: Uint32Array.of(1) });
    const { Strands, Guides } = readBack<ReadAlembic>(ALEMBIC, 'abc', long, { guidesOnly: true });
    expect(Guides).toBeUndefined();
    expect(Strands.params.groom_guide!.values).toEqual([1]);
    expect(Strands.params.groom_closest_guides).toBeUndefined();
    expect(Strands.counts).toEqual([255]);
    const wanted = inCentimetres(long).slice(3 * 700, 3 * 1400);
    expect(Strands.points.slice(0, 3).map(Math.fround)).toEqual([...wanted.slice(0, 3)]);
    expect(Strands.points.slice(-3).map(Math.fround)).toEqual([...wanted.slice(-3)]);
  });
});
