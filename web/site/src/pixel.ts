// SPDX-License-Identifier: Apache-2.0
// Why a pixel has its color: what the worker explains, with links to the pages of the course.
import { get, make } from './elements.js';
import type { Explanation } from './protocol.js';

/** Words of an explanation -> the page of the course about them, below docs/. */
const pages: ReadonlyArray<readonly [RegExp, string]> = [
    [/normal map|tangent|bump|parallax|height/i, 'bump.html'],
    [/gouraud|flat|shading/i, 'shading.html'],
    [/lambert|phong|ward|oren|ggx|pbr|diffuse|specular/i, 'lighting-models.html'],
    [/light|attenuation|shadow/i, 'lighting.html'],
    [/environment|studio/i, 'environment.html'],
    [/tone|exposure|srgb/i, 'tone-mapping.html'],
    [/triangle|depth|visible/i, 'visibility.html'],
];

const linked = (line: string, docs: string): HTMLElement => {
    const page = docs && /^\S/.test(line) ? pages.find(([words]) => words.test(line))?.[1] : undefined;
    const text = make('span', { class: /^\S/.test(line) ? 'head' : '' }, line);
    if (!page) return text;
    return make('span', {}, text, ' ', make('a', { href: `${docs}${page}`, target: '_blank', rel: 'noopener', title: 'The course about this', 'aria-label': `The course about: ${line.slice(0, 60)}` }, '?'));
};

export function showExplanation({ row, text }: Explanation, docs: string): void {
    const [r, g, b] = row.codes, swatch = make('span', { class: 'swatch', role: 'img', 'aria-label': `color ${r}, ${g}, ${b}` });
    swatch.style.backgroundColor = `rgb(${r}, ${g}, ${b})`;
    get('pixel-title').replaceChildren(swatch, `Pixel ${row.pixel[0]}, ${row.pixel[1]}: ${r}, ${g}, ${b}`);
    const paragraphs = text.split(/\n{2,}/), short = paragraphs.find(paragraph => paragraph.startsWith('In short')) ?? '';
    get('pixel-short').textContent = short.replace(/\s+/g, ' ');
    get('pixel-text').replaceChildren(...text.split('\n').flatMap(line => [linked(line, docs), '\n']));
}

export function forgetExplanation(): void {
    get('pixel-title').textContent = 'Click a pixel of the picture';
    for (const id of ['pixel-short', 'pixel-text']) get(id).textContent = '';
}
