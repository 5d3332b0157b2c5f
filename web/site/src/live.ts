// SPDX-License-Identifier: Apache-2.0
// Live figures in the documentation: below a picture stands a button that puts the model itself in its place.
import { make } from './elements.js';
import { Cancelled, Engine } from './engine.js';
import { type Figure, figures } from './figures.js';
import { Stage } from './stage.js';
import { themeColor } from './theme.js';

const here = new URL('.', import.meta.url);

async function filesOf({ files }: Figure): Promise<Array<{ path: string; bytes: Blob }>> {
    return Promise.all(files.map(async path => {
        const response = await fetch(new URL(`examples/${path}`, here));
        if (!response.ok) throw new Error(`${path}: ${response.status}`);
        return { path: path.replace(/^.*\//, ''), bytes: await response.blob() };
    }));
}

/** Puts a stage in the place of a picture, which comes back where that fails. */
async function enliven(image: HTMLImageElement, figure: Figure, button: HTMLButtonElement): Promise<void> {
    const room = make('div', { class: 'rl-stage', style: `height: ${Math.max(260, Math.round(Math.min(image.clientWidth * 0.6, 460)))}px` });
    const choices = make('div', { class: 'rl-choices', role: 'group', 'aria-label': 'What is drawn' }), message = make('p', { class: 'rl-message', role: 'status' }, 'Loading the library, once for all figures');
    const live = make('div', { class: 'rl-live' }, choices, room, message);
    const tell = (fault: unknown): void => {
        if (!(fault instanceof Cancelled)) message.textContent = fault instanceof Error ? fault.message : String(fault);
    };
    image.hidden = true;
    image.after(live);
    button.hidden = true;
    const engine = new Engine({ progress: () => {}, context: state => { if (state === 'gone') void engine.call('useSoft', stage.renew()).then(() => stage.draw(), tell); else if (state === 'there') stage.draw(); } });
    const stage = new Stage(engine, room, make('div'), { click: () => {}, fault: tell, slow: () => {}, moved: () => {} });
    stage.wheelNeedsFocus = true;
    const show = async (number: number): Promise<void> => {
        const settings = { background: themeColor(), ...figure.common, ...figure.variants[number]![1] };
        [...choices.children].forEach((child, i) => child.setAttribute('aria-pressed', String(i === number)));
        await engine.call('set', 'left', 'original', '', settings);
        stage.draw();
    };
    figure.variants.forEach(([title], i) => {
        const choice = make('button', { type: 'button', 'aria-pressed': 'false' }, title);
        choice.addEventListener('click', () => void show(i).catch(tell));
        choices.append(choice);
    });
    try {
        await engine.call('start', stage.renew());
        await engine.call('open', { name: figure.model, files: await filesOf(figure) });
        message.textContent = 'Drag to turn; after a click the wheel, or two fingers, come closer';
        stage.describe(image.alt);
        stage.isOpen = true;
        await show(0);
        room.dataset.live = figure.image;
    } catch (fault) {
        engine.end();
        live.remove();
        image.hidden = button.hidden = false;
        button.textContent = fault instanceof Error ? fault.message : String(fault);
    }
}

const page = location.pathname.replace(/^.*\//, '').replace(/\.html$/, '');
for (const figure of figures.filter(other => other.page === page)) {
    const image = [...document.images].find(other => other.src.endsWith(`/images/${figure.image}`));
    if (!image) continue;
    const button = make('button', { type: 'button', class: 'rl-button' }, 'Try it here');
    button.addEventListener('click', () => void enliven(image, figure, button));
    image.after(button);
}
