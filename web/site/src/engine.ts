// SPDX-License-Identifier: Apache-2.0
// The worker as the page calls it. A call that takes too long is broken off by ending the worker; a new one takes its place.
import type { CallName, Calls, ContextState, Fault, Message, Request } from './protocol.js';

/** An error of a call, as the program reports it. */
export class EngineError extends Error {
    override name = 'EngineError';
    constructor(readonly fault: Fault) {
        const where = [fault.file.replace(/^\/(model|fixed)\/\d+\//, ''), fault.place].filter(Boolean).join(': ');
        super([where ? `${where}: ${fault.message}` : fault.message, fault.advice].filter(Boolean).join('; '));
    }
}

export class Cancelled extends Error {
    override name = 'Cancelled';
}

interface Waiting {
    resolve(result: unknown): void;
    reject(fault: Error): void;
}

export interface EngineEvents {
    progress(stage: string, share: number): void;
    context(state: ContextState): void;
}

export class Engine {
    #worker!: Worker;
    #waiting = new Map<number, Waiting>();
    #next = 1;

    constructor(private readonly events: EngineEvents) {
        this.restart();
    }

    end(): void { this.#worker.terminate(); }

    /** Ends all calls, and begins anew. The canvas must be a new one then. */
    restart(): void {
        this.#worker?.terminate();
        for (const { reject } of this.#waiting.values()) reject(new Cancelled('cancelled'));
        this.#waiting.clear();
        this.#worker = new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
        this.#worker.addEventListener('message', ({ data }: MessageEvent<Message>) => this.#take(data));
        this.#worker.addEventListener('error', event => this.#fail(event.message || 'the worker cannot be loaded'));
    }

    call<Name extends CallName>(call: Name, ...given: Parameters<Calls[Name]>): Promise<ReturnType<Calls[Name]>> {
        const id = this.#next++, transfer = given.filter((value): value is Transferable & (typeof given)[number] => typeof OffscreenCanvas !== 'undefined' && (value as unknown) instanceof OffscreenCanvas);
        const request: Request = { id, call, arguments: given };
        return new Promise((resolve, reject) => {
            this.#waiting.set(id, { resolve: resolve as Waiting['resolve'], reject });
            this.#worker.postMessage(request, transfer as Transferable[]);
        });
    }

    #take(message: Message): void {
        if (message.kind === 'progress') return this.events.progress(message.stage, message.share);
        if (message.kind === 'context') return this.events.context(message.state);
        const waiting = this.#waiting.get(message.id);
        this.#waiting.delete(message.id);
        if (message.kind === 'result') waiting?.resolve(message.result);
        else waiting?.reject(new EngineError(message.fault));
    }

    #fail(message: string): void {
        for (const { reject } of this.#waiting.values()) reject(new EngineError({ message, file: '', place: '', advice: '', code: 'failed' }));
        this.#waiting.clear();
    }
}
