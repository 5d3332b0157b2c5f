// SPDX-License-Identifier: Apache-2.0
// Makes tests/unit/geometry/data/mikktspace_*.txt: meshes and the tangents that the reference implementation of MikkTSpace gives
// them (npm package mikktspace 1.1.1: the standard's C code by way of Rust, as WebAssembly).
// Run once, in a folder where `npm install mikktspace@1.1.1` was run:
//     node mikktspace_vectors.mjs OUTPUT_FOLDER
// One line a corner, three corners a triangle: position, normal, texture coordinate (v down), tangent x y z, and w as glTF has
// it, which is minus that of the package. Numbers are floats in full.
import { createRequire } from 'node:module';
import { writeFileSync } from 'node:fs';

const { generateTangents } = createRequire(process.cwd() + '/')('mikktspace');

function random(seed) {  // mulberry32
    return () => {
        seed = (seed + 0x6d2b79f5) | 0;
        let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
        t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
        return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
}

const unit = (v) => { const l = Math.hypot(...v); return v.map((x) => x / l); };
const corner = (p, n, q) => ({ p, n, q });

function grid(columns, rows, at) {  // at(u, v) -> corner
    const list = [];
    for (let r = 0; r < rows; ++r)
        for (let c = 0; c < columns; ++c) {
            const a = at(c / columns, r / rows), b = at((c + 1) / columns, r / rows);
            const e = at((c + 1) / columns, (r + 1) / rows), d = at(c / columns, (r + 1) / rows);
            list.push(a, b, e, a, e, d);
        }
    return list;
}

function cube(smooth) {  // six charts, with flat normals or with those of the corners
    const list = [];
    for (let axis = 0; axis < 3; ++axis)
        for (const side of [-1, 1]) {
            const face = (u, v) => {
                const p = [0, 0, 0], n = [0, 0, 0];
                p[axis] = n[axis] = side;
                p[(axis + 1) % 3] = 2 * u - 1;
                p[(axis + 2) % 3] = side * (2 * v - 1);
                return corner(p, smooth ? unit(p) : n, [u, 1 - v]);
            };
            list.push(...grid(1, 1, face));
        }
    return list;
}

const around = (u) => (u >= 1 ? 0 : 2 * Math.PI * u);
function sphere() {  // a seam where u jumps from 1 to 0; poles of degenerate triangles
    return grid(16, 8, (u, v) => {
        const ring = v <= 0 || v >= 1 ? 0 : Math.sin(Math.PI * v), y = v <= 0 ? 1 : v >= 1 ? -1 : Math.cos(Math.PI * v);
        const p = [ring * Math.sin(around(u)), y, ring * Math.cos(around(u))];
        return corner(p, p, [u, v]);
    });
}

function mirrored() {  // a bent sheet whose right half repeats the left one's texture the other way
    return grid(8, 4, (u, v) => {
        const x = 2 * u - 1, p = [x, 0.3 * x * x + 0.1 * v, -v];
        return corner(p, unit([-0.6 * x, 1, 0.1]), [Math.abs(x), v]);
    });
}

function degenerate() {  // a bumpy sheet: triangles without area, in space or in the texture, among good ones
    const next = random(7), list = grid(8, 8, (u, v) => {
        const p = [u, 0.1 * Math.sin(9 * u) * Math.cos(7 * v), -v];
        return corner(p, unit([0.4 * Math.sin(5 * u), 1, 0.3 * v]), [u, v]);
    });
    for (let t = 0; t < list.length; t += 3) {
        const kind = Math.floor(next() * 8);
        if (kind === 0) list[t + 1] = { ...list[t] };
        if (kind === 1) for (let k = 0; k < 3; ++k) list[t + k] = { ...list[t + k], q: [0.5, 0.5] };
        if (kind === 2) for (let k = 0; k < 3; ++k) list[t + k] = { ...list[t + k], q: [list[t + k].q[0], 0] };
    }
    return list;
}

function soup(seed, triangles, points, charts) {  // few points, normals and coordinates, so that many corners meet
    const next = random(seed), pick = (list) => list[Math.floor(next() * list.length)];
    const p = Array.from({ length: points }, () => [next(), next(), next()]);
    const n = Array.from({ length: points }, () => unit([next() - 0.5, next() - 0.5, next() - 0.5]));
    const q = Array.from({ length: points * charts }, () => [next(), next()]);
    const list = [];
    for (let t = 0; t < triangles; ++t)
        for (let k = 0; k < 3; ++k) {
            const v = Math.floor(next() * points);
            list.push(corner(p[v], n[v], q[v * charts + Math.floor(next() * charts)]));
        }
    // The reference leaves the faces at the last edge of its list unsorted; where more than two share it, chance pairs them. A
    // triangle by itself comes last.
    for (let k = 0; k < 3; ++k) list.push(corner([9, k, k * k], [0, 0, 1], [k, 3 * k * k]));
    return list;
}

function turned() {  // a fan whose texture turns twice as fast as space, so that tangents at its middle are all ways round
    const list = [], at = (i) => {
        const a = 2 * Math.PI * i / 12;
        return corner([Math.cos(a), 0.2, -Math.sin(a)], [0, 1, 0], [0.5 + 0.5 * Math.cos(2 * a), 0.5 + 0.5 * Math.sin(2 * a)]);
    };
    for (let i = 0; i < 12; ++i) list.push(corner([0, 0, 0], [0, 1, 0], [0.5, 0.5]), at(i), at((i + 1) % 12));
    return list;
}

const meshes = {
    cube: cube(false), round_cube: cube(true), sphere: sphere(), mirrored: mirrored(), degenerate: degenerate(), turned: turned(),
    soup: soup(1, 200, 40, 1), charts: soup(2, 200, 20, 2), crowd: soup(3, 300, 8, 1),
};
for (const [name, corners] of Object.entries(meshes)) {
    const flat = (key) => new Float32Array(corners.flatMap((c) => c[key]));
    const p = flat('p'), n = flat('n'), q = flat('q'), t = generateTangents(p, n, q);
    const lines = corners.map((c, i) =>
        [...p.slice(3 * i, 3 * i + 3), ...n.slice(3 * i, 3 * i + 3), ...q.slice(2 * i, 2 * i + 2), ...t.slice(4 * i, 4 * i + 3), -t[4 * i + 3]]
            .map((x) => String(Number(x.toPrecision(9)))).join(' '));
    const head = '# npm mikktspace 1.1.1 by tests/support/mikktspace_vectors.mjs: px py pz nx ny nz u v tx ty tz w';
    writeFileSync(`${process.argv[2]}/mikktspace_${name}.txt`, [head, ...lines, ''].join('\n'));
}
