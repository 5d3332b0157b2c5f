// SPDX-License-Identifier: Apache-2.0
// The page: a model comes in, its seams are shown, fixed and taken home.
import { zipSync } from 'fflate';

import type { InspectRow } from '../../npm/reports.js';
import { angleText, drawLegend, headline, legendAngles, listBorders } from './borders.js';
import { get, make } from './elements.js';
import { Cancelled, Engine, EngineError } from './engine.js';
import { examples, filesOfExample } from './examples.js';
import { accepted, dropped, modelOf, modelsIn, ofList } from './files.js';
import { forgetExplanation, showExplanation } from './pixel.js';
import type { ContextState, Model, ModelFile, Settings, Side } from './protocol.js';
import { makePanel } from './settings.js';
import { Stage } from './stage.js';
import { changeTheme, themeColor } from './theme.js';

const docs = document.getElementById('docs') ? 'docs/' : '';  // '': the page was built without its documentation
const slowAfterMs = 400;  // when a cancel button appears
const flightMs = 450;
const patienceMs = 1000;  // with work on a model that another one replaces
const messageMs = 8000;   // how long a remark is shown; faults stay

/** What is on the page. */
interface Shown {
    model: Model;
    report: InspectRow;
    /** The name of the example, for the link. */
    example?: string;
    /** [m] Parts without shared vertices lie this near each other; 0: none do. */
    gap: number;
}

let shown: Shown | undefined;
let isFixed = false;
let opening = 0;   // models that were asked for so far: only the last one is shown
let flights = 0;   // likewise
let acting = 0;  // how much work runs that a visitor began
let calls = 0;   // that are told of
let busySince = 0;
let hiding: ReturnType<typeof setTimeout> | undefined;

const engine = new Engine({ progress: tellProgress, context: state => act(takeContext(state)) });
const stage = new Stage(engine, get('stage'), get('line'), { click: (...place) => act(explain(...place)), fault: tellFault, slow: tellSlow, moved: () => (get('cross').hidden = true) });
const panel = makePanel(group => act(apply(group)));

/** Work that a visitor began. */
function act(work: Promise<unknown>): void {
    acting += 1;
    void work.finally(() => (acting -= 1));
}

// ---- messages

function tell(text: string, isFault = false): void {
    const box = get('message');
    box.hidden = text === '';  // before its text: what is hidden is not read out
    box.setAttribute('role', isFault ? 'alert' : 'status');
    box.classList.toggle('fault', isFault);
    get('message-text').textContent = text;
    clearTimeout(hiding);
    if (!isFault) hiding = setTimeout(() => (box.hidden = true), messageMs);
}

function tellFault(fault: unknown): void {
    if (fault instanceof Cancelled || (fault instanceof DOMException && fault.name === 'AbortError')) return;
    const message = fault instanceof Error ? fault.message : String(fault);
    if (fault instanceof EngineError && fault.fault.code === 'crashed') return act(cancel().then(() => tell(message, true)));
    tell(message, true);
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
    if (calls === 0) busySince = performance.now();
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

// ---- the library

let started: Promise<void>;

async function start(): Promise<void> {
    const renderer = await engine.call('start', stage.renew());
    tellRenderer(renderer);
    drawLegend(await engine.call('heatColors', legendAngles));
    await applyAll();
}

function tellRenderer(renderer: string): void {
    document.body.dataset.renderer = renderer || 'soft';
    get('renderer').textContent = renderer ? `drawn by ${renderer}` : 'drawn without WebGL, by the software rasterizer';
}

async function takeContext(state: ContextState): Promise<void> {
    if (state === 'gone') {
        await engine.call('useSoft', stage.renew());
        tellRenderer('');
    }
    if (state !== 'lost') stage.draw();
}

/** What the page always sets: its own background. */
const allSettings = (): Settings => ({
    background: themeColor(),
    ...panel.settings(),
    'border-distance': shown && get<HTMLInputElement>('join-gaps').checked ? String(shown.gap) : undefined,
});

async function applyAll(): Promise<void> {
    const settings = allSettings(), second = panel.second(), line = get('line'), wasHidden = line.hidden;
    await engine.call('set', 'left', 'original', panel.channel(), settings);
    await engine.call('set', 'right', isFixed && !second ? 'fixed' : 'original', second ? '' : panel.channel(), second ? { ...settings, lighting: second } : settings);
    get('left-name').textContent = second ? 'as set' : 'before';
    get('right-name').textContent = second ? panel.secondTitle() : 'after';
    line.hidden = !shown || !(isFixed || second);
    if (line.hidden) stage.split = 1;
    else if (wasHidden) stage.split = 0.5;
    stage.draw();
    const link = panel.link();
    if (shown?.example) link.set('model', shown.example);
    history.replaceState(null, '', link.size > 0 ? `#${link}` : location.pathname + location.search);
}

async function apply(group: string): Promise<void> {
    const of = shown, wasFixed = isFixed;
    try {
        await applyAll();
        if (group !== 'Normals' || !of) return;
        const report = await busy('Looking for seams', () => engine.call('examine'));
        if (of !== shown) return;
        of.report = report;
        isFixed = false;
        if (wasFixed) return await fix();
        await applyAll();
        showReport(report);
    } catch (fault) {
        tellFault(fault);
    }
}

// ---- the model

/** @param number  of `opening`: a model that was asked for later wins */
async function open(model: Model, number: number, example?: string): Promise<boolean> {
    const report = await busy('Starting', async () => {
        await started;
        return engine.call('open', model);
    });
    if (number !== opening) return false;
    const gap = report.border_proposal?.distance ?? 0;
    shown = example === undefined ? { model, report, gap } : { model, report, gap, example };
    showGap(report);
    isFixed = false;
    flights += 1;
    get('end-raking').hidden = true;
    forgetPixel();
    if (!get('pixel').hidden) choose('seams');
    stage.fade();
    await applyAll();
    showReport(report);
    document.body.classList.add('open');
    stage.isOpen = true;
    const remarks = report.remarks.filter(({ remark }) => remark === 'warning' || remark === 'dropped');
    if (remarks.length > 0) tell(remarks.slice(0, 3).map(({ message }) => message).join('; ') + (remarks.length > 3 ? `; and ${remarks.length - 3} more` : ''));
    return true;
}

/** Offers to join parts across gaps, where that would close seams. */
function showGap({ border_proposal: proposal, unit }: InspectRow): void {
    get<HTMLInputElement>('join-gaps').checked = false;
    get('gaps').hidden = !proposal;
    if (proposal) get('gaps-text').textContent = `Join parts across gaps up to ${Number(proposal.distance.toPrecision(2))} ${unit}: seams there have ${angleText(proposal.seam_deg)}`;
}

/** The first screen again. */
function close(): void {
    shown = undefined;
    isFixed = false;
    stage.isOpen = false;
    stage.staysCoarse = false;
    forgetPixel();
    tell('');
    document.body.classList.remove('open');
}

function showReport(row: InspectRow): void {
    const { text, detail, canBeFixed } = headline(row), name = shown?.model.name.replace(/^.*\//, '').replace(/^builtin:/, '') ?? '';
    get('headline').textContent = text;
    get('detail').textContent = isFixed ? name : `${name}: ${detail}`;
    get<HTMLButtonElement>('fix').hidden = isFixed;
    get<HTMLButtonElement>('fix').disabled = !canBeFixed;
    get('fix').textContent = canBeFixed ? 'Fix' : 'Nothing to fix';
    get('borders-caption').textContent = isFixed && row.borders.length > 0 ? 'Before the fix:' : '';
    get('download').hidden = !isFixed;
    stage.describe(`${name}: ${detail}. ${text}.`);
    listBorders(row, border => act(fly(border)));
}

async function fix(): Promise<void> {
    const of = shown, hasFocus = document.activeElement === get('fix');
    if (!of) return;
    try {
        const { smoothed, inspected } = await busy('Smoothing', () => engine.call('fix'));
        if (of !== shown) return;
        isFixed = true;
        panel.clearSecond();
        forgetPixel();
        stage.fade();
        await applyAll();
        showReport(of.report);
        const after = headline(inspected), { seams, meshes } = smoothed, made = meshes.filter(({ normals }) => normals === 'made').length;
        const change = `${angleText(of.report.seams.seam_deg)} → ${angleText(inspected.seams.seam_deg)}`;
        get('headline').textContent = after.hasSeams ? after.text : headline(of.report).hasSeams ? `Seams fixed: ${change}` : 'Normals made';
        if (hasFocus) get('download').focus();
        const kept = seams?.crease_pairs ? `, ${seams.crease_pairs.toLocaleString('en')} pairs of faces keep a hard edge` : '';
        tell(seams ? `${seams.turned.toLocaleString('en')} of ${seams.normals.toLocaleString('en')} normals turned${kept}` : `normals made for ${made} ${made === 1 ? 'part' : 'parts'}`);
    } catch (fault) {
        tellFault(fault);
    }
}

/** Moves the camera to a border, at once where motion is not wanted. */
async function fly(border: number): Promise<void> {
    stage.stopSpinning();
    flights += 1;
    const number = flights, begin = performance.now(), isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
    try {
        await engine.call('flyToBorder', border);
        get('end-raking').hidden = false;
        for (let share = 0; share < 1 && number === flights;) {
            share = isStill ? 1 : Math.min(1, (performance.now() - begin) / flightMs);
            await engine.call('fly', share * share * (3 - 2 * share));
            stage.draw(share < 1);
            await new Promise(requestAnimationFrame);
        }
    } catch (fault) {
        tellFault(fault);
    }
}

async function download(): Promise<void> {
    try {
        const files = await engine.call('fixedFiles'), first = files[0];
        if (!first) throw new Error('there is nothing to download');
        if (files.length === 1) return save(first.path.replace(/(\.[^.]*)$/, '-smooth$1'), new Blob([first.bytes]));
        const packed = zipSync(Object.fromEntries(files.map(({ path, bytes }) => [path, bytes])), { level: 0 });
        save(`${(shown?.model.name ?? 'model').replace(/^.*\//, '').replace(/\.[^.]*$/, '')}-smooth.zip`, new Blob([packed], { type: 'application/zip' }));
    } catch (fault) {
        tellFault(fault);
    }
}

function save(name: string, content: Blob): void {
    const link = make('a', { href: URL.createObjectURL(content), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

async function explain(...place: [Side, number, number, number, number]): Promise<void> {
    if (!shown) return;
    try {
        const explanation = await busy('Explaining', () => engine.call('explain', ...place));
        showExplanation(explanation, docs);
        mark(place[3] / place[1], place[4] / place[2]);
        choose('pixel');
        get('pixel-short').scrollIntoView({ block: 'nearest' });
    } catch (fault) {
        tellFault(fault);
    }
}

/** A cross at the pixel. @param x,y  0..1 of the picture */
function mark(x: number, y: number): void {
    Object.assign(get('cross').style, { left: `${100 * x}%`, top: `${100 * y}%` });
    get('cross').hidden = false;
}

function forgetPixel(): void {
    get('cross').hidden = true;
    forgetExplanation();
}

let fetching = new AbortController();

/** Ends what runs, by ending the worker; nothing is open then. */
function breakOff(): void {
    fetching.abort();
    fetching = new AbortController();
    opening += 1;
    close();
    get('progress').hidden = true;
    engine.restart();
    started = start();
    started.catch(tellFault);
}

/** Ends what runs. The model that was open is opened again; if its picture took too long, its pictures are coarse. */
async function cancel(): Promise<void> {
    const before = shown, wasDrawing = calls === 0;
    breakOff();
    if (!before) return;
    try {
        stage.staysCoarse = wasDrawing;
        await open(before.model, opening, before.example);
        if (wasDrawing) tell('pictures of this model stay coarse, since whole ones take long');
    } catch (fault) {
        tellFault(fault);
    }
}

/** A new model does not wait for the work on the one before. */
function makeRoom(): void {
    if (stage.drawsFor > patienceMs || (calls > 0 && performance.now() - busySince > patienceMs)) breakOff();
    stage.staysCoarse = false;
}

// ---- what comes in

/** @param name  of one of several models */
async function take(files: Promise<ModelFile[]> | ModelFile[], name?: string): Promise<void> {
    makeRoom();
    opening += 1;
    const number = opening;
    try {
        const all = await files;
        if (number !== opening || !await open(modelOf(all, name), number)) return;
        showModels(all, name);
        stage.spin();
    } catch (fault) {
        if (number === opening) tellFault(fault);
    }
}

/** A choice of the models in a folder. */
function showModels(files: ModelFile[], name?: string): void {
    const models = modelsIn(files), box = get<HTMLSelectElement>('models');
    box.replaceChildren(...models.map(path => make('option', { value: path }, path)));
    box.hidden = models.length < 2;
    box.onchange = () => act(take(files, box.value));
    if (name) box.value = name;
}

async function takeExample(name: string): Promise<void> {
    makeRoom();
    opening += 1;
    const number = opening;
    try {
        const model = await busy('Fetching', () => filesOfExample(name, fetching.signal));
        if (number !== opening || !await open(model, number, name)) return;
        showModels([]);
        stage.spin();
    } catch (fault) {
        if (number === opening) tellFault(fault);
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
    get('join-gaps').addEventListener('change', () => act(apply('Normals')));
    get('home').addEventListener('click', close);
    get('reset').addEventListener('click', () => {
        panel.reset();
        act(apply('Normals'));
    });
    document.addEventListener('pointerdown', () => stage.stopSpinning());
    get('close-message').addEventListener('click', () => tell(''));
    get<HTMLInputElement>('file').accept = accepted;
    get('fix').addEventListener('click', () => act(fix()));
    get('download').addEventListener('click', () => act(download()));
    get('cancel').addEventListener('click', () => act(cancel()));
    get('end-raking').addEventListener('click', () => {
        get('end-raking').hidden = true;
        act(engine.call('endRakingLight').then(() => stage.draw(), tellFault));
    });
    get('whole').addEventListener('click', () => {
        flights += 1;
        get('end-raking').hidden = true;
        stage.showWhole();
    });
    for (const [id, mark] of [['heat', 'seams'], ['hard', 'hardEdges']] as const)
        get<HTMLInputElement>(id).addEventListener('change', event => {
            stage[mark] = (event.target as HTMLInputElement).checked;
            get('legend').hidden = !stage.seams;
            get('edge-legend').hidden = !stage.hardEdges;
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
    changeTheme(get('theme'), () => act(applyAll().catch(tellFault)));
    listenToDrops();
}

listen();
stage.seams = true;
started = start();
started.catch(tellFault);
// For tests, and for who looks into the page.
Object.assign(globalThis, { rakelight: { engine, stage, isIdle: () => acting === 0 && stage.isIdle } });
const wanted = new URLSearchParams(location.hash.slice(1)).get('model');
if (wanted && examples.some(({ name }) => name === wanted)) act(takeExample(wanted));
addEventListener('hashchange', () => location.reload());  // of a link that is followed; the page's own changes tell nobody
if ('serviceWorker' in navigator && location.protocol !== 'file:') void navigator.serviceWorker.register('sw.js').catch(() => {});
