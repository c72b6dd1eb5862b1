// The gallery's models bent by curves: control points stand where a stroke along the limb would have put them.

import { balancing, cheering, walking } from './curves/bodies.mjs';
import { cactus, horse, octopus } from './curves/creatures.mjs';
import { brow, ears } from './curves/heads.mjs';
import { bar, moebius, sheets, snake } from './curves/shapes.mjs';

/** @returns name, title, model and recipe of each example */
export async function curveExamples() {
  return [
    ['curves-octopus', 'Octopus, arms rolled up', 'octopus', octopus()],
    ['curves-cactus', 'Cactus, waving', 'cactus', cactus()],
    ['curves-horse', 'Horse, pawing', 'horse', horse()],
    ['curves-body-cheering', 'Body, arms up', 'body-female', cheering()],
    ['curves-body-balancing', 'Body, on one leg', 'body-female', balancing()],
    ['curves-body-walking', 'Body, walking', 'body-male', walking()],
    ['curves-ears', 'Elf, ears drawn out', 'head-elf', ears()],
    ['curves-brow', 'Face, a brow raised', 'head-female', await brow()],
    ['curves-bar', 'Bar, bent and twisted', 'bar', bar()],
    ['curves-moebius', 'M\u00f6bius strip, pulled', 'moebius', moebius()],
    ['curves-sheets', 'Three sheets at one edge', 'sheets', sheets()],
    ['curves-snake', 'Snake in two, rearing', 'snake', snake()],
  ];
}
