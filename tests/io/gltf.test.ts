import { describe, expect, test } from 'vitest';
import { type Model, withPositions } from '../../web/core/model';
import { writeModel } from '../../web/io';
import { bytes, codeOf, codes, facesOf, makeModel, read, text } from './support';

const FLOATS = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
const UVS = Float32Array.of(0, 0, 1, 0, 0, 1, 1, 1);
const NORMALS = Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1);

interface Piece {
  readonly values: Float32Array | Uint16Array | Uint8Array | Int16Array | Uint32Array;
  readonly type: string;
  readonly normalized?: boolean;
}

const TYPES = new Map<unknown, number>([
  [Float32Array, 5126],
  [Uint32Array, 5125],
  [Uint16Array, 5123],
  [Int16Array, 5122],
  [Uint8Array, 5121],
]);
const WIDTH: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** A .gltf whose accessors hold `pieces`, one buffer view each, with the rest of the document as given. */
function gltf(pieces: readonly Piece[], rest: object): Uint8Array {
  const views: object[] = [];
  const content: number[] = [];
  const accessors = pieces.map(({ values, type, normalized }, bufferView) => {
    while (content.length % 4) content.push(0);
    views.push({ buffer: 0, byteOffset: content.length, byteLength: values.byteLength });
    content.push(...new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
    const componentType = TYPES.get(values.constructor);
    return {
      bufferView,
      componentType,
      type,
      count: values.length / WIDTH[type]!,
      ...(normalized && { normalized }),
    };
  });
  const uri = `data:application/octet-stream;base64,${Buffer.from(content).toString('base64')}`;
  return bytes(
    JSON.stringify({
      asset: { version: '2.0' },
      buffers: [{ byteLength: content.length, uri }],
      bufferViews: views,
      accessors,
      ...rest,
    }),
  );
}

const POSITION: Piece = { values: FLOATS, type: 'VEC3' };
const one = (primitive: object, node: object = {}) => ({
  nodes: [{ mesh: 0, ...node }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 }, ...primitive }] }],
});
const jsonOf = (file: Uint8Array) => JSON.parse(text(writeModel(read(file, 'a.glb'), 'gltf')));
const moved = (model: Model, from = 0, to = model.positions.length) =>
  withPositions(
    model,
    model.positions.map((c, i) => (i >= from && i < to ? c + 0.5 : c)),
  );

describe('reading', () => {
  test.each([Uint8Array, Uint16Array, Uint32Array])('indices of any width', (Type) => {
    const indices: Piece = { values: Type.of(0, 1, 2, 2, 1, 3), type: 'SCALAR' };
    expect(facesOf(read(gltf([POSITION, indices], one({ indices: 1 }))))).toEqual([
      [0, 1, 2],
      [2, 1, 3],
    ]);
  });

  test('triangles without indices, strips and fans', () => {
    expect(facesOf(read(gltf([POSITION], one({}))))).toEqual([[0, 1, 2]]);
    expect(facesOf(read(gltf([POSITION], one({ mode: 5 }))))).toEqual([
      [0, 1, 2],
      [2, 1, 3],
    ]);
    expect(facesOf(read(gltf([POSITION], one({ mode: 6 }))))).toEqual([
      [0, 1, 2],
      [0, 2, 3],
    ]);
  });

  test('an index beyond its own primitive names no vertex, not one of the next', () => {
    const indices: Piece = { values: Uint8Array.of(0, 1, 4), type: 'SCALAR' };
    const file = gltf([POSITION, indices], {
      nodes: [{ mesh: 0 }, { mesh: 0 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    });
    expect(facesOf(read(file))).toEqual([
      [0, 1, 0xffffffff],
      [4, 5, 0xffffffff],
    ]);
  });

  test('transforms add up along the tree, and a mirror turns the faces over', () => {
    const half = Math.SQRT1_2;
    const file = gltf([POSITION], {
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [
        { children: [1, 2], translation: [10, 0, 0], rotation: [0, 0, half, half] },
        { mesh: 0, scale: [2, 1, 1] },
        { mesh: 0, matrix: [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 3, 1], name: 'mirror' },
        { mesh: 0, name: 'not in the scene' },
      ],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    });
    const model = read(file);
    const rounded = [...model.positions].map((c) => Math.round(c * 1e9) / 1e9 + 0);
    expect(rounded.slice(0, 9)).toEqual([10, 0, 0, 10, 2, 0, 9, 0, 0]);
    expect(rounded.slice(12, 21)).toEqual([10, 0, 3, 10, -1, 3, 9, 0, 3]);
    expect(facesOf(model)).toEqual([
      [0, 1, 2],
      [4, 6, 5],
    ]);
    expect(model.groups?.map((g) => g.name)).toEqual(['mesh 0', 'mirror']);
    expect(model).toMatchObject({ unitMetres: 1, upAxis: 'y' });
  });

  test('quantised, interleaved and sparse positions', () => {
    const quantised: Piece = {
      values: Int16Array.of(0, 0, 0, 32767, 0, 0, 0, -32767, 0),
      type: 'VEC3',
      normalized: true,
    };
    expect([...read(gltf([quantised], one({}))).positions]).toEqual([0, 0, 0, 1, 0, 0, 0, -1, 0]);

    const rows: Piece = { values: Float32Array.of(0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9), type: 'VEC3' };
    const interleaved = JSON.parse(text(gltf([rows], one({}))));
    interleaved.bufferViews[0].byteStride = 16;
    interleaved.accessors[0].count = 3;
    expect([...read(JSON.stringify(interleaved)).positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);

    const at: Piece = { values: Uint8Array.of(2), type: 'SCALAR' };
    const value: Piece = { values: Float32Array.of(7, 8, 9), type: 'VEC3' };
    const sparse = JSON.parse(text(gltf([POSITION, at, value], one({}))));
    sparse.accessors[0].sparse = {
      count: 1,
      indices: { bufferView: 1, componentType: 5121 },
      values: { bufferView: 2 },
    };
    expect([...read(JSON.stringify(sparse)).positions]).toEqual([0, 0, 0, 1, 0, 0, 7, 8, 9, 1, 1, 0]);
  });

  test('texture coordinates start at the bottom, colours are sRGB', () => {
    const uv: Piece = { values: UVS, type: 'VEC2' };
    const color: Piece = {
      values: Uint8Array.from({ length: 16 }, (_, i) => (i % 4 === 3 ? 128 : 55)),
      type: 'VEC4',
      normalized: true,
    };
    const attributes = { POSITION: 0, TEXCOORD_0: 1, COLOR_0: 2 };
    const model = read(gltf([POSITION, uv, color], one({ attributes })));
    expect([...model.uvs!]).toEqual([0, 1, 1, 1, 0, 0, 1, 0]);
    expect([...model.colors!.subarray(0, 4)]).toEqual([128, 128, 128, 128]);
    expect(model.colorAlpha).toBe(true);
  });

  test('points, morph targets and skins are told of', () => {
    const file = gltf([POSITION], {
      nodes: [{ mesh: 0, skin: 0, translation: [5, 5, 5] }],
      skins: [{ joints: [0] }],
      meshes: [
        {
          primitives: [
            { attributes: { POSITION: 0 }, mode: 0 },
            { attributes: { POSITION: 0 }, targets: [{}] },
          ],
        },
      ],
    });
    expect(codes(file)).toEqual(['skin-at-rest', 'lines-left-out', 'morph-targets']);
  });
});

describe('refusing', () => {
  const compressed = (extension: string) =>
    codeOf(() => read(gltf([POSITION], { ...one({}), extensionsRequired: [extension] })));

  test('compressed geometry by name', () => {
    expect(compressed('KHR_draco_mesh_compression')).toBe('format-unsupported');
    expect(compressed('EXT_meshopt_compression')).toBe('format-unsupported');
    expect(compressed('KHR_mesh_quantization')).toBe('no error');
    const draco = JSON.parse(text(gltf([POSITION], one({ extensions: { KHR_draco_mesh_compression: {} } }))));
    delete draco.accessors[0].bufferView;
    expect(() => read(JSON.stringify(draco))).toThrow(/compressed with Draco/);
  });

  test('version 1, buffers elsewhere, no triangles, broken references, circles and JSON', () => {
    const with_ = (change: (json: ReturnType<typeof JSON.parse>) => void) => {
      const json = JSON.parse(text(gltf([POSITION], one({}))));
      change(json);
      return codeOf(() => read(JSON.stringify(json), 'a.gltf'));
    };
    expect(
      with_((j) => {
        j.asset.version = '1.0';
      }),
    ).toBe('format-unsupported');
    expect(
      with_((j) => {
        j.buffers[0].uri = 'a.bin';
      }),
    ).toBe('file-incomplete');
    expect(
      with_((j) => {
        delete j.nodes;
      }),
    ).toBe('file-not-a-mesh');
    expect(
      with_((j) => {
        j.nodes[0].mesh = 3;
      }),
    ).toBe('file-damaged');
    expect(
      with_((j) => {
        j.accessors[0].bufferView = 9;
      }),
    ).toBe('file-damaged');
    expect(
      with_((j) => {
        j.accessors[0].type = 'VEC9';
      }),
    ).toBe('file-damaged');
    expect(
      with_((j) => {
        j.accessors[0].count = 5;
      }),
    ).toBe('file-truncated');
    expect(
      with_((j) => {
        j.accessors[0].count = 1e9;
      }),
    ).toBe('count-too-large');
    expect(
      with_((j) => {
        j.scenes = [{ nodes: [0] }];
        j.nodes[0].children = [0];
      }),
    ).toBe('no error');
    expect(codeOf(() => read('{"asset":{', 'a.gltf'))).toBe('file-damaged');
  });
});

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
