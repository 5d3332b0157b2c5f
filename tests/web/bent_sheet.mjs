// SPDX-License-Identifier: Apache-2.0
// Parts of a bent sheet (half a cylinder around y) whose normals lean away at the border between them, and what meets in the world.
export const rows = 6, columns = 4;
export const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Rotates around y by 0, 1, 2, or 3 right angles, scales, then moves; by columns. */
export function placed(quarters, scale, [x, y, z]) {
    const [c, s] = [[1, 0], [0, 1], [-1, 0], [0, -1]][quarters].map(value => value * scale);
    return [c, 0, -s, 0, 0, scale, 0, 0, s, 0, c, 0, x, y, z, 1];
}

/** The place in the world of a part whose own coordinates are to be found. */
const local = (m, [x, y, z]) => {
    const d = [x - m[12], y - m[13], z - m[14]], squared = m[0] ** 2 + m[1] ** 2 + m[2] ** 2;
    return [0, 4, 8].map(k => (m[k] * d[0] + m[k + 1] * d[1] + m[k + 2] * d[2]) / squared);
};

/**
 * Part 0 ends where part 1 begins, in the plane x = at[0].
 * @param lean  of the normals at the border [rad]
 * @param matrix  from the part's own coordinates into the world
 */
export function sheet(part, { lean = 0.15, matrix = identity, radius = 1, at = [0, 0, 0] } = {}) {
    const positions = [], normals = [], tangents = [], texcoords = [], indices = [], border = [];
    const turned = matrix.map((value, k) => (k < 12 ? value : 0));
    for (let i = 0; i <= columns; ++i)
        for (let j = 0; j <= rows; ++j) {
            const isBorder = i === (part === 0 ? columns : 0), a = (part * columns + i) / columns * Math.PI / 2;
            const b = a + (isBorder ? (part === 0 ? -lean : lean) : 0), size = Math.hypot(...matrix.slice(0, 3));
            if (isBorder) border.push(positions.length / 3);
            positions.push(...local(matrix, [at[0] + radius * Math.cos(a), at[1] + j / rows, at[2] + radius * Math.sin(a)]));
            normals.push(...local(turned, [Math.cos(b), 0, Math.sin(b)]).map(value => value * size));
            tangents.push(...local(turned, [-Math.sin(b), 0, Math.cos(b)]).map(value => value * size), 1);
            texcoords.push((part * columns + i) / columns, j / rows);
        }
    const v = (i, j) => i * (rows + 1) + j;
    for (let i = 0; i < columns; ++i)
        for (let j = 0; j < rows; ++j) indices.push(v(i, j), v(i, j + 1), v(i + 1, j + 1), v(i, j), v(i + 1, j + 1), v(i + 1, j));
    const floats = { positions, normals, tangents, texcoords };
    for (const name of Object.keys(floats)) floats[name] = Float32Array.from(floats[name]);
    return { ...floats, indices: Uint16Array.from(indices), border };
}

export const sheets = (first, second = first) => [sheet(0, first), sheet(1, second)];

/** A cube of 8 vertices. */
export function cube() {
    const positions = [];
    for (const z of [-1, 1]) for (const y of [-1, 1]) for (const x of [-1, 1]) positions.push(x, y, z);
    const quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    return { positions: Float32Array.from(positions), indices: Uint16Array.from(quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d])) };
}

export const vector = (array, i, size = 3) => Array.from(array.slice(size * i, size * (i + 1)));
export const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));
const unit = a => a.map(x => x / Math.hypot(...a));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const combined = ([a, b, c], [x, y, z]) => [0, 1, 2].map(k => a[k] * x + b[k] * y + c[k] * z);

function inWorld({ positions, normals, matrix }, v) {
    const axes = [0, 4, 8].map(k => matrix.slice(k, k + 3)), [a, b, c] = axes, normal = vector(normals, v);
    const cofactors = [cross(b, c), cross(c, a), cross(a, b)];
    return { position: combined(axes, vector(positions, v)).map((x, k) => x + matrix[12 + k]), normal: unit(combined(cofactors, normal)) };
}

/**
 * @param parts  { positions, normals, matrix }[]; the matrices mirror nothing
 * @param step  coordinates are the same if they are this near
 * @returns how many places are shared by several parts, and the least and the largest distance of unit normals there
 */
export function meetings(parts, step = 1e-4) {
    const places = new Map();
    parts.forEach((part, number) => {
        for (let v = 0; v < part.positions.length / 3; ++v) {
            const { position, normal } = inWorld(part, v), key = position.map(x => Math.round(x / step)).join();
            places.set(key, [...places.get(key) ?? [], { number, normal }]);
        }
    });
    const gaps = [...places.values()].map(all => {
        const others = all.filter(({ number }) => number !== all[0].number);
        return others.length === 0 ? undefined : Math.max(...others.flatMap(p => all.map(q => distance(p.normal, q.normal))));
    }).filter(gap => gap !== undefined);
    return { places: gaps.length, least: Math.min(...gaps), most: Math.max(...gaps) };
}
