/** Version of package.json, set at build time. */
declare const __VERSION__: string;
