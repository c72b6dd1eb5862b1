export { detectFormat, type FileFormat, FORMAT_NAMES } from './detect';
export { readModel, type WriteOptions, writeModel } from './formats';
export type { ImportNote } from './notes';
export { type Project, readProject, writeProject } from './project';
export type { ReadResult } from './reading';
