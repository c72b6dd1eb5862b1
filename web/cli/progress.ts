import { inBytes } from '../core/sizes';
import type { Step } from '../recipe/recipe';
import type { StepResult } from '../run/results';
import type { Preparation } from '../run/steps/step-runner';
import type { Stream } from './streams';

/** One line per step, on a terminal only: how far it is while it runs, then what it took. */
export class Progress {
  #shown = '';
  #preparing: { readonly step: string; readonly what: string } | undefined;

  constructor(private readonly stream: Stream) {}

  /** @param fraction  of all steps, in [0, 1] */
  update(fraction: number, step: Step): void {
    const what = this.#preparing?.step === step.id ? `  ${this.#preparing.what}` : '';
    const text = `${step.id}  ${step.type}  ${Math.floor(100 * fraction)} %${what}`;
    if (!this.stream.isTTY || text === this.#shown) return;
    this.stream.write(`\r\u001b[K${text}`);
    this.#shown = text;
  }

  /** What a step is about to set up; said with its progress. */
  preparing({ vertices, bytes }: Preparation, step: Step): void {
    this.#preparing = { step: step.id, what: `(${vertices} vertices, about ${inBytes(bytes)} of memory)` };
  }

  done(results: ReadonlyMap<string, StepResult>): void {
    if (!this.stream.isTTY) return;
    this.clear();
    for (const { report } of results.values()) {
      const seconds = Object.values(report.seconds).reduce((sum, each) => sum + each, 0);
      const warnings = report.warnings.map(({ code }) => code).join(', ');
      const line = `${report.id}  ${report.type}  ${report.vertices} vertices  ${seconds.toFixed(2)} s`;
      this.stream.write(`${line}${warnings ? `  (${warnings})` : ''}\n`);
    }
  }

  /** Leaves the line empty for what is said next. */
  clear(): void {
    if (this.#shown) this.stream.write('\r\u001b[K');
    this.#shown = '';
  }
}
