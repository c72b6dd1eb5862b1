/** An affine map: 16 numbers, column-major, last row 0 0 0 1, as recipes, the kernel, glTF and three.js write it. */
export type Affine = readonly number[];

export const IDENTITY: Affine = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
