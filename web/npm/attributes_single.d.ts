// SPDX-License-Identifier: Apache-2.0
// As attributes.d.ts: the module has its WebAssembly within it.
import type { Attributes } from './attributes.js';

export { AttributesError } from './attributes.js';
export type * from './attributes.js';

export function loadAttributes(): Promise<Attributes>;
