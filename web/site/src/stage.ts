// SPDX-License-Identifier: Apache-2.0
// The picture: a canvas that the worker draws into, the camera by mouse, touch and keys, and the line between two pictures.
import { make } from './elements.js';
import { Cancelled, type Engine } from './engine.js';
import type { Side } from './protocol.js';

const stillAfterMs = 160;   // without motion, until the whole picture is drawn
const slowAfterMs = 1500;   // when a picture takes long
const click_px = 5;         // a press that moves less is a click
const mostSide = 2560;      // [px] of the canvas
const keyStep = 0.04;
const turnsPerSecond = 0.06;  // while nobody has touched the model

interface Pointer {
    x: number;
    y: number;
}

export interface StageEvents {
    /** [px] of the picture, and in it */
    click(side: Side, width: number, height: number, x: number, y: number): void;
    fault(fault: unknown): void;
    /** What was at a place of the picture is elsewhere. */
    moved(): void;
    /** A picture takes long, or has come at last. */
    slow(isSlow: boolean): void;
}

export class Stage {
    /** Where a document scrolls by the wheel: the canvas takes it only after a click. */
    wheelNeedsFocus = false;
    /** Pictures stay coarse: whole ones take too long. */
    staysCoarse = false;
    seams = false;
    hardEdges = false;
    /** 0..1 where the right picture begins; 1: there is none */
    #split = 1;
    #canvas!: HTMLCanvasElement;
    #pictures = 0;
    #drawingSince = 0;
    #isDrawing = false;
    #isWanted = false;
    #movedAt = -Infinity;
    #pointers = new Map<number, Pointer>();
    #pressedAt: Pointer | undefined;
    #isSpinning = false;
    #spunAt = 0;
    readonly #room: HTMLElement;
    readonly #line: HTMLElement;

    /** @param room  gets the canvas, below what is in it  @param line  between the two pictures */
    constructor(private readonly engine: Engine, room: HTMLElement, line: HTMLElement, private readonly events: StageEvents) {
        this.#room = room;
        this.#line = line;
        new ResizeObserver(() => this.draw()).observe(this.#room);
        this.#listenToLine();
    }

    /** Puts a new canvas in place. @returns what the worker draws into */
    renew(): OffscreenCanvas {
        this.#canvas?.remove();
        this.#canvas = make('canvas', { tabindex: '0', role: 'img', 'aria-label': 'The model. Arrow keys turn it, plus and minus change the distance, 0 shows all of it.' });
        this.#room.prepend(this.#canvas);
        this.#isDrawing = false;
        this.#listen();
        return this.#canvas.transferControlToOffscreen();
    }

    /** [ms] for how long the picture that comes next is already drawn. */
    get drawsFor(): number { return this.#isDrawing ? performance.now() - this.#drawingSince : 0; }

    /** The picture is of something else, until the next one is there. */
    fade(): void { this.#canvas.classList.add('stale'); }

    /** Whether what was asked for is drawn. */
    get isIdle(): boolean { return !this.#isDrawing && !this.#isWanted && performance.now() - this.#movedAt > 2 * stillAfterMs; }

    describe(text: string): void { this.#canvas.setAttribute('aria-label', `${text} Arrow keys turn it, plus and minus change the distance, 0 shows all of it.`); }

    get split(): number { return this.#split; }
    set split(to: number) {
        this.#split = Math.min(1, Math.max(0, to));
        this.#line.style.setProperty('--split', String(this.#split));
        this.#line.setAttribute('aria-valuenow', String(Math.round(100 * this.#split)));
        this.draw();
    }

    #size(): { width: number; height: number } {
        const box = this.#room.getBoundingClientRect(), scale = Math.min(devicePixelRatio, mostSide / Math.max(box.width, box.height, 1));
        return { width: Math.max(1, Math.round(box.width * scale)), height: Math.max(1, Math.round(box.height * scale)) };
    }

    /** Soon; many wishes become one picture. */
    draw(isMoving = false): void {
        if (isMoving) {
            this.#movedAt = performance.now();
            this.events.moved();
        }
        if (!this.#isOpen) return;
        this.#isWanted = true;
        if (!this.#isDrawing) void this.#drawAll();
    }

    async #drawAll(): Promise<void> {
        this.#isDrawing = true;
        while (this.#isWanted && this.#isOpen) {
            this.#isWanted = false;
            const isMoving = this.staysCoarse || performance.now() - this.#movedAt < stillAfterMs;
            this.#drawingSince = performance.now();
            const slow = setTimeout(() => this.events.slow(true), slowAfterMs);
            try {
                const { took, isCoarse } = await this.engine.call('draw', { ...this.#size(), split: this.#split, seams: this.seams, hardEdges: this.hardEdges, isMoving });
                Object.assign(this.#canvas.dataset, { pictures: String(++this.#pictures), ms: took.toFixed(1) });  // tests wait for them
                if (isCoarse) this.#isWanted = true;
                this.#canvas.classList.remove('stale');
            } catch (fault) {
                if (fault instanceof Cancelled) return;
                this.events.fault(fault);
            } finally {
                clearTimeout(slow);
                this.events.slow(false);
            }
            await new Promise(requestAnimationFrame);
            if (isMoving && !this.staysCoarse && !this.#isWanted) setTimeout(() => this.draw(), stillAfterMs);
        }
        this.#isDrawing = false;
    }

    #isOpen = false;
    /** Whether there is a model to draw. */
    set isOpen(is: boolean) {
        this.#isOpen = is;
        if (!is) {
            this.stopSpinning();
            this.#isWanted = false;
        }
        if (is) this.draw();
    }

    /** Turns slowly until the model is touched. */
    spin(): void {
        if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
        this.#spunAt = performance.now();
        if (this.#isSpinning) return;
        this.#isSpinning = true;
        const step = async (): Promise<void> => {
            if (!this.#isSpinning) return;
            const now = performance.now(), by = Math.min(0.1, (now - this.#spunAt) / 1000) * turnsPerSecond;
            this.#spunAt = now;
            if (document.visibilityState === 'visible' && this.#isOpen && !this.#isDrawing) {
                await this.engine.call('turn', 2 * by, 0).catch(() => {});
                this.draw(true);
            }
            requestAnimationFrame(() => void step());
        };
        requestAnimationFrame(() => void step());
    }
    stopSpinning(): void { this.#isSpinning = false; }

    move(how: 'turn' | 'pan', dx: number, dy: number): void {
        this.stopSpinning();
        this.engine.call(how, dx, dy).catch(fault => this.events.fault(fault));
        this.draw(true);
    }

    dolly(factor: number): void {
        this.stopSpinning();
        this.engine.call('dolly', factor).catch(fault => this.events.fault(fault));
        this.draw(true);
    }

    showWhole(): void {
        this.stopSpinning();
        this.engine.call('showWhole').catch(fault => this.events.fault(fault));
        this.draw();
    }

    #listen(): void {
        const canvas = this.#canvas;
        canvas.addEventListener('pointerdown', event => {
            canvas.setPointerCapture(event.pointerId);
            this.stopSpinning();
            this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
            this.#pressedAt = this.#pointers.size === 1 ? { x: event.clientX, y: event.clientY } : undefined;
        });
        canvas.addEventListener('pointermove', event => this.#drag(event));
        for (const end of ['pointerup', 'pointercancel'] as const)
            canvas.addEventListener(end, event => {
                this.#pointers.delete(event.pointerId);
                if (end === 'pointerup' && event.button === 0 && this.#pressedAt) this.#click(event);
                this.#pressedAt = undefined;
            });
        canvas.addEventListener('wheel', event => {
            if (this.wheelNeedsFocus && document.activeElement !== canvas) return;
            event.preventDefault();
            this.dolly(Math.exp(Math.max(-1, Math.min(1, event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)))));
        }, { passive: false });
        canvas.addEventListener('contextmenu', event => event.preventDefault());
        canvas.addEventListener('keydown', event => this.#key(event));
    }

    #drag(event: PointerEvent): void {
        const from = this.#pointers.get(event.pointerId);
        if (!from) return;
        if (this.#pressedAt && Math.hypot(event.clientX - this.#pressedAt.x, event.clientY - this.#pressedAt.y) >= click_px) this.#pressedAt = undefined;
        if (this.#pressedAt) return;
        const dx = event.clientX - from.x, dy = event.clientY - from.y, { width, height } = this.#canvas.getBoundingClientRect();
        const others = [...this.#pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at), other = others[0];
        this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
        if (other) {  // two fingers: distance and place
            const before = Math.hypot(from.x - other.x, from.y - other.y), now = Math.hypot(event.clientX - other.x, event.clientY - other.y);
            if (before > 0 && now > 0) this.dolly(before / now);
            return this.move('pan', dx / 2 / height, dy / 2 / height);
        }
        if (event.buttons & 6 || event.shiftKey) return this.move('pan', dx / height, dy / height);
        const side = Math.min(width, height);
        this.move('turn', dx / side, dy / side);
    }

    #click(event: PointerEvent): void {
        const box = this.#canvas.getBoundingClientRect(), { width, height } = this.#size();
        const x = Math.floor((event.clientX - box.left) / box.width * width), y = Math.floor((event.clientY - box.top) / box.height * height);
        this.events.click(x < this.#split * width ? 'left' : 'right', width, height, x, y);
    }

    #key(event: KeyboardEvent): void {
        const steps: Record<string, [number, number]> = { ArrowLeft: [-keyStep, 0], ArrowRight: [keyStep, 0], ArrowUp: [0, -keyStep], ArrowDown: [0, keyStep] };
        const step = steps[event.key];
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        if (step) this.move(event.shiftKey ? 'pan' : 'turn', ...step);
        else if (event.key === '+' || event.key === '=') this.dolly(0.9);
        else if (event.key === '-') this.dolly(1 / 0.9);
        else if (event.key === '0' || event.key === 'Home') this.showWhole();
        else return;
        event.preventDefault();
    }

    #listenToLine(): void {
        const place = (event: PointerEvent): void => {
            const box = this.#room.getBoundingClientRect();
            this.split = (event.clientX - box.left) / box.width;
        };
        this.#line.addEventListener('pointerdown', event => {
            this.#line.setPointerCapture(event.pointerId);
            event.preventDefault();
            this.#line.focus();
        });
        this.#line.addEventListener('pointermove', event => {
            if (this.#line.hasPointerCapture(event.pointerId)) place(event);
        });
        this.#line.addEventListener('keydown', event => {
            const steps: Record<string, number> = { ArrowLeft: this.split - 0.02, ArrowRight: this.split + 0.02, Home: 0, End: 1 };
            const to = steps[event.key];
            if (to === undefined) return;
            this.split = to;
            event.preventDefault();
        });
    }
}
