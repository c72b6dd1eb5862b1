import { describe, expect, test } from 'vitest';
import { gltf, one, type Piece, POSITION, UVS } from './gltf-support';
import { codeOf, codes, facesOf, read, text } from './support';

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
