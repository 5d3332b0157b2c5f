// SPDX-License-Identifier: Apache-2.0
// The page: a model comes in, its seams are shown, fixed and taken home.
import { zipSync } from 'fflate';

import type { InspectRow } from '../../npm/reports.js';
import { drawLegend, headline, legendAngles, listBorders } from './borders.js';
import { get, make } from './elements.js';
import { Cancelled, Engine } from './engine.js';
import { examples, filesOfExample } from './examples.js';
import { dropped, modelOf, modelsIn, ofList } from './files.js';
import { showExplanation } from './pixel.js';
import type { Model, Settings, Side } from './protocol.js';
import { makePanel } from './settings.js';
import { Stage } from './stage.js';
import { rememberTheme, themeColor } from './theme.js';

const docs = document.getElementById('docs') ? 'docs/' : '';  // '': the page was built without its documentation
const slowAfterMs = 400;  // when a cancel button appears
const messageMs = 8000;   // how long a remark is shown; faults stay

let shown: Model | undefined;
let example: string | undefined;  // its name, for the link
let report: InspectRow | undefined;
let isFixed = false;
let acting = 0;  // how much work runs that a visitor began
let calls = 0;   // that are told of
let hiding: ReturnType<typeof setTimeout> | undefined;

const engine = new Engine({ progress: tellProgress, context: isThere => (isThere ? stage.draw() : undefined) });
const stage = new Stage(engine, get('stage'), get('line'), { click: (side, x, y) => act(explain(side, x, y)), fault: tellFault, slow: tellSlow });
const panel = makePanel(group => act(apply(group)));

/** Work that a visitor began. */
function act(work: Promise<unknown>): void {
    acting += 1;
    void work.finally(() => (acting -= 1));
}

// ---- messages

function tell(text: string, isFault = false): void {
    const box = get('message');
    box.textContent = text;
    box.classList.toggle('fault', isFault);
    box.hidden = text === '';
    clearTimeout(hiding);
    if (!isFault) hiding = setTimeout(() => (box.hidden = true), messageMs);
}

function tellFault(fault: unknown): void {
    if (fault instanceof Cancelled) return;
    tell(fault instanceof Error ? fault.message : String(fault), true);
}

const stages: Record<string, string> = { read: 'Reading', load: 'Loading', inspect: 'Looking for seams', smooth: 'Smoothing', prepare: 'Preparing', render: 'Drawing', upload: 'Uploading', write: 'Writing' };

function tellProgress(stage: string, share: number): void {
    get('progress-text').textContent = stages[stage] ?? `${stage[0]?.toUpperCase() ?? ''}${stage.slice(1)}`;
    get<HTMLProgressElement>('progress-bar').value = share;
}

function tellSlow(isSlow: boolean): void {
    if (calls === 0) get('progress').hidden = !isSlow;
}

/** Shows progress while something runs that may take long. */
async function busy<T>(text: string, work: () => Promise<T>): Promise<T> {
    tell('');
    get('progress-text').textContent = text;
    get<HTMLProgressElement>('progress-bar').removeAttribute('value');
    calls += 1;
    document.body.classList.add('busy');
    const slow = setTimeout(() => (get('progress').hidden = false), slowAfterMs);
    try {
        return await work();
    } finally {
        clearTimeout(slow);
        calls -= 1;
        if (calls === 0) {
            get('progress').hidden = true;
            document.body.classList.remove('busy');
        }
    }
}

// ---- the model

async function start(): Promise<void> {
    const renderer = await engine.call('start', stage.renew());
    document.body.dataset.renderer = renderer || 'soft';
    get('renderer').textContent = renderer ? `drawn by ${renderer}` : 'drawn without WebGL, by the software rasterizer';
    drawLegend(await engine.call('heatColors', legendAngles));
    await applyAll();
}

const started = start();
started.catch(tellFault);

/** What the page always sets: its own background. */
const allSettings = (): Settings => ({ background: themeColor(), ...panel.settings() });

async function applyAll(): Promise<void> {
    const settings = allSettings(), second = panel.second();
    await engine.call('set', 'left', 'original', panel.channel(), settings);
    await engine.call('set', 'right', isFixed && !second ? 'fixed' : 'original', second ? '' : panel.channel(), second ? { ...settings, lighting: second } : settings);
    get('left-name').textContent = second ? 'as set' : 'before';
    get('right-name').textContent = second ?? 'after';
    get('line').hidden = !report || !(isFixed || second);
    if (get('line').hidden) stage.split = 1;
    else if (stage.split === 1) stage.split = 0.5;
    stage.draw();
    const link = panel.link();
    if (example) link.set('model', example);
    history.replaceState(null, '', link.size > 0 ? `#${link}` : location.pathname + location.search);
}

async function apply(group: string): Promise<void> {
    try {
        await applyAll();
        if (group !== 'Normals' || !shown || !report) return;
        const wasFixed = isFixed;
        await open(shown, false);
        if (wasFixed) await fix();
    } catch (fault) {
        tellFault(fault);
    }
}

async function open(model: Model, isNew = true): Promise<void> {
    await started;
    const found = await busy('Reading', () => engine.call('open', model));
    shown = model;
    report = found;
    isFixed = false;
    stage.split = 1;
    await applyAll();
    showReport(found);
    document.body.classList.add('open');
    stage.isOpen = true;
    if (isNew) stage.spin();
    const remarks = found.remarks.filter(({ remark }) => remark === 'warning' || remark === 'dropped');
    if (remarks.length > 0) tell(remarks.slice(0, 3).map(({ message }) => message).join('; '));
}

function showReport(row: InspectRow): void {
    const { text, detail, hasSeams } = headline(row), name = shown?.name.replace(/^.*\//, '').replace(/^builtin:/, '') ?? '';
    get('headline').textContent = text;
    get('detail').textContent = `${name}: ${detail}`;
    get<HTMLButtonElement>('fix').hidden = isFixed;
    get<HTMLButtonElement>('fix').disabled = !hasSeams && row.objects.every(({ normals }) => normals === 'yes');
    get('download').hidden = !isFixed;
    stage.describe(`${name}: ${detail}. ${text}.`);
    listBorders(row, border => act(fly(border)));
}

async function fix(): Promise<void> {
    try {
        const { smoothed, inspected } = await busy('Smoothing', () => engine.call('fix'));
        isFixed = true;
        await applyAll();
        const turned = smoothed.seams?.turned ?? 0, made = smoothed.meshes.filter(({ normals }) => normals === 'made').length;
        showReport(report!);
        const after = headline(inspected);
        get('headline').textContent = after.hasSeams ? after.text : 'Seams fixed';
        tell(smoothed.seams ? `${turned.toLocaleString('en')} of ${smoothed.seams.normals.toLocaleString('en')} normals turned` : `normals made for ${made} ${made === 1 ? 'part' : 'parts'}`);
    } catch (fault) {
        tellFault(fault);
    }
}

async function fly(border: number): Promise<void> {
    stage.stopSpinning();
    try {
        await engine.call('flyToBorder', border);
        get('end-raking').hidden = false;
        stage.draw();
    } catch (fault) {
        tellFault(fault);
    }
}

async function download(): Promise<void> {
    try {
        const files = await engine.call('fixedFiles'), first = files[0];
        if (!first) throw new Error('there is nothing to download');
        if (files.length === 1) return save(first.path, new Blob([first.bytes]));
        const packed = zipSync(Object.fromEntries(files.map(({ path, bytes }) => [path, bytes])), { level: 0 });
        save(`${(shown?.name ?? 'model').replace(/^.*\//, '').replace(/\.[^.]*$/, '')}.zip`, new Blob([packed], { type: 'application/zip' }));
    } catch (fault) {
        tellFault(fault);
    }
}

function save(name: string, content: Blob): void {
    const link = make('a', { href: URL.createObjectURL(content), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

async function explain(side: Side, x: number, y: number): Promise<void> {
    if (!report) return;
    try {
        const explanation = await busy('Explaining', () => engine.call('explain', side, x, y));
        showExplanation(explanation, docs);
        choose('pixel');
    } catch (fault) {
        tellFault(fault);
    }
}

/** Ends what runs. The model that was open is opened again. */
async function cancel(): Promise<void> {
    engine.restart();
    try {
        await start();
        if (shown) await open(shown, false);
    } catch (fault) {
        tellFault(fault);
    }
}

// ---- what comes in

async function take(files: Promise<Parameters<typeof modelsIn>[0]> | Parameters<typeof modelsIn>[0], name?: string): Promise<void> {
    try {
        const all = await files, models = modelsIn(all);
        const box = get<HTMLSelectElement>('models');
        example = undefined;
        box.replaceChildren(...models.map(path => make('option', { value: path }, path)));
        box.hidden = models.length < 2;
        box.onchange = () => act(take(all, box.value));
        if (name) box.value = name;
        await open(modelOf(all, name));
    } catch (fault) {
        tellFault(fault);
    }
}

async function takeExample(name: string): Promise<void> {
    try {
        const files = await busy('Fetching', () => filesOfExample(name));
        get('models').hidden = true;
        example = name;
        await open(files);
    } catch (fault) {
        tellFault(fault);
    }
}

function listenToDrops(): void {
    let depth = 0;  // of elements that a drag is over
    document.addEventListener('dragenter', event => {
        event.preventDefault();
        depth += 1;
        document.body.classList.add('dragging');
    });
    document.addEventListener('dragover', event => event.preventDefault());
    document.addEventListener('dragleave', () => {
        depth -= 1;
        if (depth <= 0) document.body.classList.remove('dragging');
    });
    document.addEventListener('drop', event => {
        event.preventDefault();
        depth = 0;
        document.body.classList.remove('dragging');
        if (event.dataTransfer) act(take(dropped(event.dataTransfer)));
    });
}

// ---- the panel

const tabs = ['seams', 'look', 'pixel'] as const;

function choose(tab: (typeof tabs)[number]): void {
    for (const other of tabs) {
        get(`tab-${other}`).setAttribute('aria-selected', String(other === tab));
        get(`tab-${other}`).tabIndex = other === tab ? 0 : -1;
        get(other).hidden = other !== tab;
    }
}

function listen(): void {
    tabs.forEach((tab, i) => {
        get(`tab-${tab}`).addEventListener('click', () => choose(tab));
        get(`tab-${tab}`).addEventListener('keydown', event => {
            const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? tabs.length - 1 : 0, next = tabs[(i + step) % tabs.length]!;
            if (step === 0) return;
            choose(next);
            get(`tab-${next}`).focus();
        });
    });
    get('fix').addEventListener('click', () => act(fix()));
    get('download').addEventListener('click', () => act(download()));
    get('cancel').addEventListener('click', () => act(cancel()));
    get('end-raking').addEventListener('click', () => {
        get('end-raking').hidden = true;
        act(engine.call('endRakingLight').then(() => stage.draw(), tellFault));
    });
    get('whole').addEventListener('click', () => {
        get('end-raking').hidden = true;
        stage.showWhole();
    });
    for (const [id, mark] of [['heat', 'seams'], ['hard', 'hardEdges']] as const)
        get<HTMLInputElement>(id).addEventListener('change', event => {
            stage[mark] = (event.target as HTMLInputElement).checked;
            get('legend').hidden = !stage.seams;
            stage.draw();
        });
    for (const id of ['file', 'folder']) {
        const input = get<HTMLInputElement>(id);
        for (const button of document.querySelectorAll(`[data-for="${id}"]`)) button.addEventListener('click', () => input.click());
        input.addEventListener('change', () => {
            if (input.files?.length) act(take(ofList(input.files)));
            input.value = '';
        });
    }
    for (const { name, title, about } of examples) {
        const button = make('button', { type: 'button', class: 'example', 'data-example': name }, make('strong', {}, title), make('span', {}, about));
        button.addEventListener('click', () => act(takeExample(name)));
        get('examples').append(make('li', {}, button));
    }
    rememberTheme(get('theme'), () => act(applyAll().catch(tellFault)));
    listenToDrops();
}

listen();
stage.seams = true;
// For tests, and for who looks into the page.
Object.assign(globalThis, { rakelight: { engine, stage, isIdle: () => acting === 0 && stage.isIdle } });
const wanted = new URLSearchParams(location.hash.slice(1)).get('model');
if (wanted && examples.some(({ name }) => name === wanted)) act(takeExample(wanted));
addEventListener('hashchange', () => location.reload());  // of a link that is followed; the page's own changes tell nobody
if ('serviceWorker' in navigator && location.protocol !== 'file:') void navigator.serviceWorker.register('sw.js').catch(() => {});
