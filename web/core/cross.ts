type Triple = readonly [number, number, number];

export const cross = (a: Triple, b: Triple): [number, number, number] => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
