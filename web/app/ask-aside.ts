// One question to a worker of its own, which ends with the answer: what may take long, or comes from anyone.

/** What a Worker and a test's stand-in have in common. */
export interface AsideWorker<Question, Answer> {
  postMessage(question: Question): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<Answer>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

interface Asking<Answer, Result> {
  /** @returns the result, or `undefined` while there is more to come; what it throws is what went wrong */
  readonly hear: (answer: Answer) => Result | undefined;
  /** Begins to watch for what ends the asking early. @returns the function that watches no longer */
  readonly watch: (giveUp: (why: unknown) => void) => () => void;
}

/** @returns `null` where no worker could be started, or it failed */
export function askAside<Question, Answer, Result>(
  start: () => AsideWorker<Question, Answer>,
  question: Question,
  { hear, watch }: Asking<Answer, Result>,
): Promise<Result | null> {
  let worker: AsideWorker<Question, Answer>;
  try {
    worker = start();
  } catch {
    return Promise.resolve(null);
  }
  return new Promise<Result | null>((resolve, reject) => {
    const end = (settle: () => void) => {
      unwatch();
      worker.terminate();
      settle();
    };
    const giveUp = (why: unknown) => end(() => reject(why));
    const unwatch = watch(giveUp);
    worker.onmessage = ({ data }) => {
      try {
        const result = hear(data);
        if (result !== undefined) end(() => resolve(result));
      } catch (error) {
        giveUp(error);
      }
    };
    worker.onerror = (event) => {
      event.preventDefault();
      end(() => resolve(null));
    };
    worker.postMessage(question);
  });
}
