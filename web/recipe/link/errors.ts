import { LissomError } from '../../core/errors';

/** Greatest size of what a link unpacks to, in bytes. */
export const MAX_UNPACKED = 1_000_000;
/** Most values that a link holds once it is read, of eight bytes each: 4 MB. A list counts for six beside its items. */
export const MAX_VALUES = 500_000;
/** Greatest length of a link's payload, in characters: less than what browsers take as an address. */
export const MAX_PAYLOAD = 1_500_000;

const grouped = (n: number): string => n.toLocaleString('en-US');

export const damaged = (): LissomError =>
  new LissomError(
    'link-damaged',
    'The link is damaged: some of its characters were changed. Copy it again from where it was made.',
  );

/** @param whole  characters the complete link has, where the link still says so */
export const cut = (found: number, whole?: number): LissomError =>
  new LissomError(
    'link-cut',
    whole === undefined
      ? 'The link is cut: almost nothing of it is left. Copy the whole link from where it was made.'
      : `The link is cut at ${grouped(found)} of ${grouped(whole)} characters. Copy the whole link from where it was made.`,
  );

export const linkTooNew = (): LissomError =>
  new LissomError(
    'link-too-new',
    'The link was made by a newer Lissom. Reload the page, or update Lissom, to open it.',
  );

export const tooLarge = (what: string): LissomError =>
  new LissomError(
    'link-too-large',
    `${what}; the limit is ${grouped(MAX_UNPACKED)} bytes. Use a project file instead.`,
  );

export const tooManyValues = (): LissomError =>
  new LissomError(
    'link-too-large',
    `The link holds more than ${grouped(MAX_VALUES)} values; that many would take 4 MB. Use a project file instead.`,
  );

/** @param seconds  how long was waited */
export const linkTooSlow = (seconds: number): LissomError =>
  new LissomError(
    'link-too-slow',
    `The link was not read within ${seconds} seconds, so it was not opened. Ask for a project file instead.`,
  );

export const emptyLink = (): LissomError =>
  new LissomError('link-empty', 'This address holds no recipe: nothing follows "#r=". Copy the whole link.');

export const needsFile = (model: string, file: string): LissomError =>
  new LissomError(
    'link-needs-file',
    `A link cannot carry the mesh ${JSON.stringify(file)} (models[${JSON.stringify(model)}]); ` +
      'share a project file, which has its meshes in it, or use built-in models.',
  );
