import { describe, expect, test } from 'vitest';
import { type Model, withPositions } from '../../web/core/model';
import { writeModel } from '../../web/io';
import { gltf, NORMALS, one, type Piece, POSITION, UVS } from './gltf-support';
import { facesOf, makeModel, read, text } from './support';

const jsonOf = (file: Uint8Array) => JSON.parse(text(writeModel(read(file, 'a.glb'), 'gltf')));
const moved = (model: Model, from = 0, to = model.positions.length) =>
  withPositions(
    model,
    model.positions.map((c, i) => (i >= from && i < to ? c + 0.5 : c)),
  );

describe('writing back', () => {
  const pieces: Piece[] = [
    POSITION,
    { values: NORMALS, type: 'VEC3' },
    { values: UVS, type: 'VEC2' },
    { values: Uint16Array.of(0, 1, 2, 2, 1, 3), type: 'SCALAR' },
  ];
  const scene = {
    scene: 0,
    scenes: [{ name: 'stage', nodes: [0] }],
    nodes: [
      { name: 'root', children: [1, 2], scale: [2, 2, 2] },
      { name: 'left', mesh: 0 },
      { name: 'right', mesh: 0, translation: [3, 0, 0] },
    ],
    meshes: [
      {
        name: 'card',
        primitives: [
          { attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2, TANGENT: 1 }, indices: 3, material: 0 },
        ],
      },
    ],
    materials: [{ name: 'paper', doubleSided: true }],
    extras: { mine: 1 },
  };
  const file = gltf(pieces, scene);

  test('a model that did not move keeps its document', () => {
    const before = JSON.parse(text(file));
    const { buffers: a, ...after } = jsonOf(file);
    const { buffers: b, ...expected } = before;
    expect(after).toEqual(expected);
    expect(a[0].uri).toBe(b[0].uri);
  });

  test('moved vertices go back into their nodes, everything else stays', () => {
    const model = moved(read(file));
    for (const format of ['glb', 'gltf'] as const) {
      const again = read(writeModel(model, format));
      const { positions, origin, ...rest } = again;
      const { positions: wanted, origin: _, ...expected } = model;
      expect(rest).toEqual(expected);
      expect([...positions]).toEqual([...wanted]);
      const { json } = (origin!.extra as { document: { json: ReturnType<typeof JSON.parse> } }).document;
      expect(json).toMatchObject({ scenes: scene.scenes, materials: scene.materials, extras: scene.extras });
      expect(json.nodes.map((n: { name: string }) => n.name)).toEqual(['root', 'left', 'right']);
    }
  });

  test('of two nodes that share a mesh only the moved one changes', () => {
    const model = read(file);
    const json = JSON.parse(text(writeModel(moved(model, 0, 12), 'gltf')));
    expect(json.meshes.length).toBe(2);
    expect(json.nodes[2].mesh).toBe(0);
    expect(json.meshes[0]).toEqual(scene.meshes[0]);
    expect(json.meshes[1].primitives[0].attributes.TANGENT).toBeUndefined();
    expect(read(JSON.stringify(json)).positions).toEqual(moved(model, 0, 12).positions);
  });

  test('a file does not grow from trip to trip', () => {
    let model = read(gltf(pieces, { ...scene, nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }] }));
    const sizes = [1, 2, 3].map(() => {
      const out = writeModel(moved(model), 'gltf');
      model = read(out, 'a.gltf');
      const { bufferViews, accessors, buffers } = JSON.parse(text(out));
      return [bufferViews.length, accessors.length, buffers[0].byteLength];
    });
    expect(sizes[1]).toEqual(sizes[0]);
    expect(sizes[2]).toEqual(sizes[0]);
  });

  test('normals are new, smooth where they were smooth and creased where they were creased', () => {
    const roof = Float32Array.of(0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0);
    const flat = Float32Array.of(...Array(6).fill([0, 0, 1]).flat());
    const creased = flat.map((c, i) => (i < 9 ? c : i % 3 === 1 ? 1 : 0));
    const fold = (normals: Float32Array) => {
      const piece = gltf(
        [
          { values: roof, type: 'VEC3' },
          { values: normals, type: 'VEC3' },
        ],
        one({ attributes: { POSITION: 0, NORMAL: 1 } }),
      );
      const model = read(piece);
      const lifted = withPositions(
        model,
        model.positions.map((c, i) => (i === 8 ? 1 : c)),
      );
      const json = JSON.parse(text(writeModel(lifted, 'gltf')));
      const view = json.bufferViews[json.accessors[1].bufferView];
      const raw = Buffer.from(json.buffers[0].uri.split(',')[1], 'base64');
      const at = (v: number) => [0, 4, 8].map((k) => raw.readFloatLE(view.byteOffset + 12 * v + k));
      return { first: at(0), second: at(3) };
    };
    const smooth = fold(flat);
    expect(smooth.first).toEqual(smooth.second);
    const sharp = fold(creased);
    expect(sharp.first).not.toEqual(sharp.second);
    expect(Math.hypot(...sharp.first)).toBeCloseTo(1, 6);
  });

  test('quantised vertices become floats in their place', () => {
    const quantised: Piece = {
      values: Int16Array.of(0, 0, 0, 32767, 0, 0, 0, 32767, 0, 0, 0, 0),
      type: 'VEC3',
      normalized: true,
    };
    const model = read(gltf([quantised], one({}, { scale: [2, 2, 2] })));
    expect(read(writeModel(moved(model), 'glb')).positions).toEqual(moved(model).positions);
  });

  test('a model whose triangles changed becomes a new document', () => {
    const model = read(file);
    const other = { ...model, faceVertices: model.faceVertices.map((_, i, all) => all[all.length - 1 - i]!) };
    expect(facesOf(read(writeModel(other, 'glb')))).toEqual(facesOf(other));
  });
});

describe('writing anew', () => {
  const square: Model = {
    ...makeModel(
      [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0],
      [
        [0, 1, 2],
        [0, 2, 3],
      ],
    ),
    groups: [{ name: 'upper', material: 'red', start: 1, end: 2 }],
  };

  test('groups and materials keep their names', () => {
    expect(read(writeModel(square, 'glb')).groups).toEqual([
      { name: 'made', start: 0, end: 1 },
      { name: 'upper', material: 'red', start: 1, end: 2 },
    ]);
  });

  test('a model in millimetres with z up comes back in metres with y up', () => {
    const model = {
      ...square,
      positions: square.positions.map((c) => c + 1),
      unitMetres: 0.001,
      upAxis: 'z' as const,
    };
    const again = read(writeModel(model, 'glb'));
    const wanted = Array.from({ length: 12 }, (_, i) => {
      const [x, y, z] = model.positions.subarray(i - (i % 3), i - (i % 3) + 3) as unknown as [
        number,
        number,
        number,
      ];
      return [x, z, -y][i % 3]! / 1000;
    });
    again.positions.forEach((c, i) => {
      expect(c).toBeCloseTo(wanted[i]!, 12);
    });
  });

  test('a model far from its origin loses no detail', () => {
    const far = withPositions(
      square,
      square.positions.map((c) => c + 1e8),
    );
    expect([...read(writeModel(far, 'glb')).positions]).toEqual([...far.positions]);
  });

  test('vertices are split only where their texture coordinates differ, the others keep their numbers', () => {
    const model = {
      ...square,
      uvs: Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5),
      uvIndices: Uint32Array.of(0, 1, 2, 4, 2, 3),
    };
    const again = read(writeModel(model, 'glb'));
    expect([...again.positions.subarray(0, 12)]).toEqual([...model.positions]);
    expect([...again.positions.subarray(12)]).toEqual([0, 0, 0]);
    expect([...again.uvs!]).toEqual([0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5]);
    expect(facesOf(again)).toEqual([
      [0, 1, 2],
      [4, 2, 3],
    ]);
  });

  test('a concave polygon is cut inside itself, a quad along the diagonal that keeps it flat', () => {
    const arrow = makeModel([0, 0, 0, 2, 2, 0, 4, 0, 0, 2, 5, 0], [[0, 1, 2, 3]]);
    expect(facesOf(read(writeModel(arrow, 'glb')))).toEqual([
      [1, 2, 3],
      [1, 3, 0],
    ]);
    const star = [
      [0, 0],
      [4, 0],
      [4, 4],
      [3, 1],
      [0, 4],
    ].flatMap(([x, y]) => [x!, y!, 1]);
    const cut = read(writeModel(makeModel(star, [[0, 1, 2, 3, 4]]), 'glb'));
    expect(cut.faceVertices.length).toBe(9);
    const areas = facesOf(cut).map(([a, b, c]) => {
      const at = (v: number, k: number) => cut.positions[3 * v + k]!;
      return (
        ((at(b!, 0) - at(a!, 0)) * (at(c!, 1) - at(a!, 1)) -
          (at(c!, 0) - at(a!, 0)) * (at(b!, 1) - at(a!, 1))) /
        2
      );
    });
    expect(Math.min(...areas)).toBeGreaterThan(0);
    expect(areas.reduce((a, b) => a + b)).toBeCloseTo(10, 12);
  });
});
