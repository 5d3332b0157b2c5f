// SPDX-License-Identifier: Apache-2.0
// Figures of the documentation that become live: a page, a picture of it, and what is drawn in its place.
import type { Settings } from './protocol.js';

export interface Figure {
    /** The page's file without its ending. */
    page: string;
    /** The picture's file in images/. */
    image: string;
    /** The model: a file, or a built-in shape. */
    model: string;
    /** All files, by their paths below examples/. */
    files: string[];
    /** Settings of all variants. */
    common: Settings;
    variants: Array<readonly [string, Settings]>;
}

const light = 'directional:-1,-0.8,-0.9:color=1.2,1.2,1.2';
const bricks = ['wall/brick_normal.png', 'wall/brick_height.png'], leather = ['figures/leather_normal.png', 'figures/leather_height.png'];
const bricksOn = { 'texture-normal': 'brick_normal.png', 'height-map': 'brick_height.png' };
const words = (key: string, all: ReadonlyArray<readonly [string, string]>): Array<readonly [string, Settings]> => all.map(([title, word]) => [title, { [key]: word }] as const);

export const figures: readonly Figure[] = [
    {
        page: 'shading', image: 'shading.png', model: 'builtin:teapot', files: [], common: { lighting: 'blinn-phong', light },
        variants: words('shading', [['Phong', 'phong'], ['Gouraud', 'gouraud'], ['Flat', 'flat'], ['Unlit', 'unlit']]),
    },
    {
        page: 'bump', image: 'bump-techniques.png', model: 'wall.obj', files: ['wall/wall.obj', 'wall/wall.mtl', ...bricks],
        common: { ...bricksOn, light: 'directional:1,-0.6,-0.9', 'bump-depth': '0.06' },
        variants: words('bump', [['None', 'none'], ['Bump mapping', 'height'], ['Normal mapping', 'normal'], ['Parallax', 'parallax'], ['Steep parallax', 'steep'], ['Occlusion', 'occlusion']]),
    },
    {
        page: 'bump', image: 'bump-teapots.png', model: 'builtin:teapot', files: [...bricks, ...leather],
        common: { lighting: 'blinn-phong', light: 'directional:0.7,-0.9,-0.8', color: '#a4653a', roughness: '0.32', metallic: '0' },
        variants: [['Smooth', {}], ['Brick', { 'texture-normal': 'brick_normal.png' }], ['Leather', { 'texture-normal': 'leather_normal.png' }],
            ['Leather, occlusion', { 'texture-normal': 'leather_normal.png', 'height-map': 'leather_height.png', bump: 'occlusion', 'bump-self-shadow': 'on', 'bump-depth': '0.03' }]],
    },
    {
        page: 'smooth', image: 'spot-head.png', model: 'spot_slab5.glb', files: ['spot/spot_slab5.glb'], common: { light },
        variants: words('normals', [['By object', 'object'], ['By model', 'model'], ['By face', 'face']]),
    },
    {
        page: 'visibility', image: 'visibility.png', model: 'cyclic.obj', files: ['figures/cyclic.obj', 'figures/colors.mtl'], common: { samples: '1' },
        variants: words('visibility', [['z-buffer', 'z-reversed'], ['Painter', 'painter'], ['Back faces culled', 'back-face'], ['None', 'none']]),
    },
    {
        page: 'lighting-models', image: 'lighting-models.png', model: 'builtin:teapot', files: [], common: { light, roughness: '0.35' },
        variants: words('lighting', [['Lambert', 'lambert'], ['Phong', 'phong'], ['Blinn-Phong', 'blinn-phong'], ['Oren-Nayar', 'oren-nayar'], ['Ward', 'ward'], ['GGX', 'pbr']]),
    },
    {
        page: 'interpolation', image: 'interpolation.png', model: 'floor.obj', files: ['figures/floor.obj', 'figures/checker.png'],
        common: { 'texture-base-color': 'checker.png', shading: 'unlit', 'camera-position': '0,1.6,5.5', 'camera-focal-point': '0,0,0', 'camera-view-angle': '45' },
        variants: words('interpolation', [['Perspective-correct', 'perspective'], ['On the screen', 'screen']]),
    },
    {
        page: 'tone-mapping', image: 'tone-mapping.png', model: 'builtin:teapot', files: [], common: { light: 'directional:-1,-0.8,-0.9:color=6,6,5', lighting: 'pbr', color: '#d07050' },
        variants: words('tone-mapping', [['None', 'none'], ['Reinhard', 'reinhard'], ['ACES', 'aces'], ['AgX', 'agx']]),
    },
];
