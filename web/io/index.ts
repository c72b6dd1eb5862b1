export { detectFormat, type FileFormat, FORMAT_NAMES } from './detect';
export { readModel, type WriteOptions, writeModel } from './formats';
export type { ImportNote } from './notes';
export { type Project, readProject, writeProject } from './project';
export type { ReadResult } from './reading';
export { readStrands, writeStrands } from './strands/formats';
export { type ClosestGuides, chooseGuides, closestGuides, usualGuideCount } from './strands/guides';
export type { StrandFormat, StrandWriteOptions } from './strands/options';
