// SPDX-License-Identifier: Apache-2.0
// The panel of settings, and the link that holds them. A setting is a key of [render] in world files with its value.
import type { RenderOptions } from '../../npm/program_options.js';
import { get, make } from './elements.js';
import type { Settings } from './protocol.js';

type Words<Key extends keyof RenderOptions> = Array<readonly [Extract<RenderOptions[Key], string>, string]>;

type Group = 'Light' | 'Surface' | 'Normals' | 'Channels' | 'Compare';

interface Choice {
    key: string;
    title: string;
    hint: string;
    words: ReadonlyArray<readonly [string, string]>;
    /** The panel's group. */
    group: Group;
}

const choice = <Key extends keyof RenderOptions>(group: Choice['group'], name: Key & string, title: string, hint: string, words: Words<Key>): Choice =>
    ({ group, key: name, title, hint, words });

const choices: Choice[] = [
    choice('Surface', 'lighting', 'Lighting model', 'How a surface reflects light.', [
        ['auto', 'As the material'], ['lambert', 'Lambert'], ['phong', 'Phong'], ['blinn-phong', 'Blinn-Phong'],
        ['oren-nayar', 'Oren-Nayar'], ['oren-nayar-full', 'Oren-Nayar, full'], ['ward', 'Ward'], ['pbr', 'Metallic-roughness (GGX)'],
    ]),
    choice('Surface', 'bump', 'Bumps', 'What the normal map or height map of a material is used for.', [
        ['auto', 'As the material'], ['none', 'None'], ['height', 'Bump mapping'], ['normal', 'Normal mapping'], ['parallax', 'Parallax mapping'],
        ['parallax-limited', 'Parallax, offset limiting'], ['steep', 'Steep parallax'], ['occlusion', 'Parallax occlusion'],
    ]),
    choice('Surface', 'shading', 'Shading', 'How often the lighting is evaluated.', [
        ['phong', 'Phong: per pixel'], ['gouraud', 'Gouraud: per vertex'], ['flat', 'Flat: per face'], ['unlit', 'Unlit'],
    ]),
    choice('Normals', 'weight', 'Weight of faces', 'How much each face counts in a normal.', [
        ['auto', 'Auto'], ['angle', 'Angle'], ['area', 'Area'], ['angle-area', 'Angle and area'], ['uniform', 'Uniform'], ['max', 'Max 1999'], ['fit', 'Fitted surface'],
    ]),
    choice('Normals', 'crease', 'Creases', 'Which edges stay hard where normals are made.', [['auto', 'By the rule'], ['angle', 'By an angle']]),
];

/** Settings that are not a choice of words. */
const numbers = [{ key: 'crease-angle', title: 'Crease angle', hint: 'Edges that bend more are hard.', unit: '°', from: 0, to: 180, step: 1, usual: 60, group: 'Normals' }] as const;

/** [key, words] of lights that can be chosen; the first: as the model has it. */
const lights: ReadonlyArray<readonly [string, string, Settings]> = [
    ['model', 'As the model', {}],
    ['studio', 'Studio', { light: 'studio' }],
    ['side', 'One light from the side', { light: 'directional:-1,-0.35,-0.4:color=1.6,1.6,1.6' }],
    ['camera', 'Light at the camera', { light: 'default' }],
];

const channels: ReadonlyArray<readonly [string, string]> = [
    ['', 'Colors'], ['normal', 'Normals'], ['face-normal', 'Normals of faces'], ['tangent', 'Tangents'], ['depth', 'Depth'], ['uv', 'Texture coordinates'],
    ['object', 'Objects'], ['material', 'Materials'], ['triangle', 'Triangles'], ['base-color', 'Base color'], ['diffuse', 'Diffuse light'], ['specular', 'Specular light'],
];

export interface Panel {
    /** All settings, as keys of [render]. */
    settings(): Settings;
    /** The lighting model of the right picture; undefined: no comparison */
    second(): string | undefined;
    /** Its title; '': there is none. */
    secondTitle(): string;
    /** The channel that is shown; '': the colors */
    channel(): string;
    /** Ends the comparison. */
    clearSecond(): void;
    /** All settings as at first. */
    reset(): void;
    /** The words of the link. */
    link(): URLSearchParams;
}

const select = (id: string, title: string, hint: string, words: ReadonlyArray<readonly [string, string]>): [HTMLElement, HTMLSelectElement] => {
    const box = make('select', { id, 'aria-describedby': `${id}-hint` }, ...words.map(([value, text]) => make('option', { value }, text)));
    return [make('div', { class: 'setting' }, make('label', { for: id }, title), box, make('small', { id: `${id}-hint` }, hint)), box];
};

/** Fills the panel. @param change  called after each change, with the group that changed */
export function makePanel(change: (group: Group) => void): Panel {
    const wanted = new URLSearchParams(location.hash.slice(1)), values = new Map<string, string>();
    const groups = new Map<string, HTMLElement>();
    const groupOf = (title: string): HTMLElement => {
        const known = groups.get(title);
        if (known) return known;
        const made = make('fieldset', {}, make('legend', {}, title));
        groups.set(title, made);
        get('look').append(made);
        return made;
    };
    const add = (group: Group, key: string, title: string, hint: string, words: ReadonlyArray<readonly [string, string]>): void => {
        const [row, box] = select(`set-${key}`, title, hint, words);
        const asked = wanted.get(key);
        if (asked && words.some(([word]) => word === asked)) box.value = asked;
        values.set(key, box.value);
        box.addEventListener('change', () => {
            values.set(key, box.value);
            change(group);
        });
        groupOf(group).append(row);
    };
    add('Light', 'lights', 'Light', 'A light that grazes the surface shows every seam.', lights.map(([word, text]) => [word, text] as const));
    for (const { group, key, title, hint, words } of choices) add(group, key, title, hint, words);
    for (const { key, title, hint, unit, from, to, step, usual } of numbers) {
        const id = `set-${key}`, box = make('input', { id, type: 'range', min: String(from), max: String(to), step: String(step), 'aria-describedby': `${id}-hint` }), shown = make('output', { for: id });
        box.defaultValue = String(usual);
        box.value = wanted.get(key) ?? String(usual);
        const tell = (): void => {
            shown.textContent = `${box.value}${unit}`;
            values.set(key, box.value);
        };
        tell();
        box.addEventListener('input', tell);
        box.addEventListener('change', () => change('Normals'));
        groupOf('Normals').append(make('div', { class: 'setting' }, make('label', { for: id }, title, ' ', shown), box, make('small', { id: `${id}-hint` }, hint)));
    }
    add('Channels', 'channel', 'Show', 'What the picture is made of; drawn by the software rasterizer.', channels);
    add('Compare', 'second', 'Beside it', 'Another lighting model, on the right of a line.', [['', 'Nothing'], ...choices[0]!.words.slice(1)]);

    get('look').append(make('button', { type: 'button', id: 'reset' }, 'All as at first'));
    const isUsual = (key: string, value: string): boolean => {
        const usual = choices.find(other => other.key === key)?.words[0]?.[0] ?? numbers.find(other => other.key === key)?.usual ?? (key === 'lights' ? 'model' : '');
        return value === String(usual);
    };
    return {
        settings() {
            const found: Settings = {};
            for (const [key, value] of values) {
                if (isUsual(key, value) || key === 'second' || key === 'channel') continue;
                if (key === 'lights') Object.assign(found, lights.find(([word]) => word === value)?.[2]);
                else if (key !== 'crease-angle' || values.get('crease') === 'angle') found[key] = value;
            }
            return found;
        },
        channel: () => values.get('channel') ?? '',
        second: () => values.get('second') || undefined,
        secondTitle: () => choices[0]!.words.find(([word]) => word === values.get('second'))?.[1] ?? '',
        clearSecond() {
            values.set('second', '');
            get<HTMLSelectElement>('set-second').value = '';
        },
        reset() {
            for (const box of get('look').querySelectorAll<HTMLSelectElement | HTMLInputElement>('select, input')) {
                if (box instanceof HTMLSelectElement) box.selectedIndex = 0;
                else box.value = box.defaultValue;
                values.set(box.id.replace(/^set-/, ''), box.value);
                box.dispatchEvent(new Event('input'));
            }
        },
        link: () => new URLSearchParams([...values].filter(([key, value]) =>
            !isUsual(key, value) && (key !== 'crease-angle' || values.get('crease') === 'angle'))),
    };
}
