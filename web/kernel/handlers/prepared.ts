import type { WasmObject } from '../../../wasm/bindings/model';
import type { KernelId } from '../contract';
import type { Job } from '../job';
import type { Registry } from './registry';

/** What is prepared a slice at a time, and says what came of it. */
interface Session<Figures> extends WasmObject {
  step(): boolean;
  fraction(): number;
  figures(): Figures;
}

/** Prepares a session in slices and keeps it; one that fails or is given up on the way is freed. */
export async function prepared<Figures extends object>(
  session: Session<Figures>,
  job: Job,
  registry: Registry,
  { peakBytes }: { peakBytes(): number },
): Promise<Figures & { readonly id: KernelId; readonly peakBytes: number }> {
  try {
    await job.advance(
      () => session.step(),
      () => session.fraction(),
    );
    return { ...session.figures(), id: registry.add(session), peakBytes: peakBytes() };
  } catch (error) {
    session.delete();
    throw error;
  }
}
