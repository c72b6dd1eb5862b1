import { formatNumber } from '../../app/i18n';

/** As a number for people: short times to a tenth. */
export const milliseconds = (ms: number): string =>
  ms < 10 ? formatNumber(Number(ms.toFixed(1))) : `${Math.round(ms)}`;

/** Figures of the status bar, one after the other; what is false is left out. */
export function FigureList({ parts }: { parts: readonly (string | false)[] }) {
  return <>{parts.map((part) => part && <span key={part}>{part}</span>)}</>;
}
