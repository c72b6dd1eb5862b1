// Binary PLY as the gallery's models are kept: float positions, triangles or none.

import { readFileSync } from 'node:fs';

/** @returns the file's bytes */
export function plyOf({ points, triangles }) {
  const header = [
    'ply',
    'format binary_little_endian 1.0',
    `element vertex ${points.length}`,
    'property float x',
    'property float y',
    'property float z',
    ...(triangles.length > 0
      ? [`element face ${triangles.length}`, 'property list uchar int vertex_indices']
      : []),
    'end_header\n',
  ].join('\n');
  const body = Buffer.alloc(12 * points.length + 13 * triangles.length);
  for (const [v, point] of points.entries())
    for (let k = 0; k < 3; k++) body.writeFloatLE(point[k], 12 * v + 4 * k);
  const start = 12 * points.length;
  for (const [t, triangle] of triangles.entries()) {
    body.writeUInt8(3, start + 13 * t);
    for (let k = 0; k < 3; k++) body.writeInt32LE(triangle[k], start + 13 * t + 1 + 4 * k);
  }
  return Buffer.concat([Buffer.from(header, 'latin1'), body]);
}

/**
 * @param file  a binary little-endian PLY: per vertex x, y, z first, faces lists of uchar and int, in this order; or no faces
 * @returns points, faces, and `scalp`: the vertices whose last property, a uchar, is not 0
 */
export function readPly(file) {
  const bytes = readFileSync(file);
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const header = bytes.subarray(0, end).toString('latin1');
  const count = (element) => Number(new RegExp(`element ${element} (\\d+)`).exec(header)?.[1] ?? 0);
  const sizes = { float: 4, double: 8, uchar: 1, char: 1, short: 2, ushort: 2, int: 4, uint: 4 };
  const properties = [...header.split('element face')[0].matchAll(/property (\w+) \w+/g)];
  const stride = properties.reduce((sum, [, type]) => sum + sizes[type], 0);
  const double = properties[0][1] === 'double';
  const points = Array.from({ length: count('vertex') }, (_, v) =>
    [0, 1, 2].map((k) =>
      double ? bytes.readDoubleLE(end + v * stride + 8 * k) : bytes.readFloatLE(end + v * stride + 4 * k),
    ),
  );
  const flag = (v) => properties.at(-1)[1] === 'uchar' && bytes[end + (v + 1) * stride - 1] !== 0;
  const scalp = [...points.keys()].filter(flag);
  let at = end + points.length * stride;
  const faces = Array.from({ length: count('face') }, () => {
    const corners = bytes[at++];
    return Array.from({ length: corners }, () => {
      at += 4;
      return bytes.readInt32LE(at - 4);
    });
  });
  return { points, faces, scalp };
}
