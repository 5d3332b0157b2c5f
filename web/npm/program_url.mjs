// SPDX-License-Identifier: Apache-2.0
// Where the program's .wasm lies; beside this file, as the other modules find theirs, so that bundlers treat all alike.
export const programUrl = new URL('rakelight.wasm', import.meta.url);
