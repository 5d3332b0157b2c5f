// SPDX-License-Identifier: Apache-2.0
// What was found at the borders of a model: a line that says it, the list of borders, the legend of the heat map.
import type { InspectRow } from '../../npm/reports.js';
import { get, make } from './elements.js';

const mostListed = 200;
const legendDegrees = [0.01, 1, 5, 20, 60];  // as in the heat maps of the program

export const angleText = (degrees: number): string => (degrees >= 0.095 ? degrees.toFixed(1) : degrees.toFixed(2)) + '°';

const plural = (count: number, one: string, many: string): string => `${count.toLocaleString('en')} ${count === 1 ? one : many}`;

/** "12 borders with a seam, largest 32.7°", and what is known besides. */
export function headline(row: InspectRow): { text: string; detail: string; hasSeams: boolean; canBeFixed: boolean } {
    const { seams, objects, triangles } = row, detail = `${plural(objects.length, 'object', 'objects')}, ${plural(triangles, 'triangle', 'triangles')}`;
    const isOpen = (border: InspectRow['borders'][number] | undefined): boolean => border !== undefined && border.seam_deg > seams.continuous_within_deg;
    const open = row.borders.filter(isOpen).length + (isOpen(row.borders.at(-1)) ? row.borders_left_out : 0);  // the worst are listed
    const lacksNormals = objects.some(({ normals }) => normals !== 'yes'), broken = seams.missing_normals;
    const seamsText = open > 0 ? `${plural(open, 'border', 'borders')} with a seam, largest ${angleText(seams.seam_deg)}` : seams.pairs > 0 ? `${plural(seams.pairs, 'border', 'borders')}, no seam` : 'No borders between parts';
    const text = broken > 0 ? `${plural(broken, 'broken normal', 'broken normals')}; ${seamsText.toLowerCase()}` : seamsText;
    const hasSeams = open > 0 || broken > 0;
    return { text, detail: lacksNormals ? `${detail}, without normals` : detail, hasSeams, canBeFixed: hasSeams || lacksNormals };
}

const nameOf = (row: InspectRow, object: number): string => row.objects[object]?.name || `object ${object + 1}`;

/** Lists borders, the worst first, each a button. */
export function listBorders(row: InspectRow, fly: (border: number) => void): void {
    const list = get('borders');
    const items = row.borders.slice(0, mostListed).map((border, number) => {
        const a = nameOf(row, border.object_a), b = nameOf(row, border.object_b), isSeam = border.seam_deg > row.seams.continuous_within_deg;
        const angle = isSeam ? angleText(border.seam_deg) : 'no seam';
        const button = make('button', { type: 'button', class: isSeam ? 'border seam' : 'border', title: `Show the border of ${a} and ${b}` },
            make('span', { class: 'names' }, border.object_a === border.object_b ? `${a}: its parts` : `${a} – ${b}`),
            make('span', { class: 'angle' }, angle));
        button.addEventListener('click', () => {
            for (const other of list.querySelectorAll('[aria-current]')) other.removeAttribute('aria-current');
            button.setAttribute('aria-current', 'true');
            fly(number);
        });
        return make('li', {}, button);
    });
    list.replaceChildren(...items);
    const left = row.borders.length - items.length + row.borders_left_out;
    get('more-borders').textContent = left > 0 ? `and ${plural(left, 'border', 'borders')} more` : '';
}

/** The colors of the heat map, in even steps from one angle of the list to the next. */
export function drawLegend(colors: string[]): void {
    const stops = colors.map((color, i) => `${color} ${(100 * i / (colors.length - 1)).toFixed(1)}%`).join(', ');
    get('legend-colors').style.backgroundImage = `linear-gradient(to right, ${stops})`;
    get('legend-words').replaceChildren(...legendDegrees.map(degrees => make('span', {}, `${degrees}°${degrees === legendDegrees.at(-1) ? '+' : ''}`)));
}

export const legendAngles = legendDegrees;
