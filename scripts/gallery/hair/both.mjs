/** Each line with its mirror image, those along the middle once. */
export const both = (primitives) =>
  primitives.flatMap((primitive) => {
    const points = primitive.points ?? primitive.spine;
    if (points.every(([x]) => Math.abs(x) < 0.004)) return [primitive];
    const flip = (line) => line.map(([x, y, z]) => [-x + 0, y, z]);
    const image = { ...primitive };
    for (const field of ['points', 'spine', 'section']) if (image[field]) image[field] = flip(image[field]);
    if (image.profiles) image.profiles = image.profiles.map(flip);
    if (image.tilt) image.tilt = image.tilt.map((x) => -x + 0);
    return [primitive, image];
  });
