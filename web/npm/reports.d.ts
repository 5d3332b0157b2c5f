// SPDX-License-Identifier: Apache-2.0
// What --json writes, as far as its members are typed here. Later versions add members and rename none.

/** Something that was noticed and is no error. */
export interface Remark {
    remark: 'note' | 'changed' | 'guessed' | 'dropped' | 'warning';
    file: string;
    /** Where in the file; empty: no one place. */
    place: string;
    message: string;
    /** How often. */
    count: number;
    /** The options that the message names, as keys of the program's settings. */
    settings?: string[];
}

/** Rows of files that failed do not come back: the function throws their error. */
export interface Row {
    remarks: Remark[];
    remarks_left_out: number;
    [member: string]: unknown;
}

export interface Report<R extends Row = Row> {
    /** "rakelight.inspect/1" and so on. */
    schema: string;
    /** One: of the one input. */
    rows: [R, ...R[]];
    [member: string]: unknown;
}

/** What the limits say. */
export interface Check {
    passed: boolean;
    failures: Array<{ limit: string; message: string }>;
}

/** Angles between normals [degrees]. */
export interface Angles {
    max_deg: number;
    mean_deg: number;
    p95_deg: number;
}

/** At the positions that parts share; at each, the pair of the largest angle counts. */
export interface Seams {
    positions: number;
    /** Positions whose normals agree, within `continuous_within_deg`. */
    continuous: number;
    continuous_within_deg: number;
    /** Positions whose normals agree after smoothing. */
    joined: number;
    /** The largest angle that smoothing would remove: what `maxSeam` limits. */
    seam_deg: number;
    before: Angles;
    after: Angles;
    /** How many `borders` there are. */
    pairs: number;
    /** Normals of the file that are zero or not finite. */
    missing_normals: number;
    inconsistent_edges: number;
    [member: string]: unknown;
}

/** Where two objects meet, or two meshes of one. */
export interface Border {
    /** Index into `objects`. */
    object_a: number;
    object_b: number;
    /** Index into `materials`; null: none. */
    material_a: number | null;
    material_b: number | null;
    positions: number;
    continuous: number;
    joined: number;
    seam_deg: number;
    /** Where in the world the seam is largest. */
    seam_position: [number, number, number];
    before: Angles;
    after: Angles;
    [member: string]: unknown;
}

export interface InspectedObject {
    name: string;
    /** Index of the node. */
    node: number;
    meshes: number;
    triangles: number;
    vertices: number;
    lines: number;
    points: number;
    /** 'some': only a part of its meshes has them. */
    normals: 'yes' | 'some' | 'no';
    tangents: 'yes' | 'some' | 'no';
    texcoords: 'yes' | 'some' | 'no';
    materials: string[];
    [member: string]: unknown;
}

export interface InspectRow extends Row {
    file: string;
    triangles: number;
    /** 'units': the format has none. */
    unit: string;
    objects: InspectedObject[];
    seams: Seams;
    /** The largest seam first. */
    borders: Border[];
    borders_left_out: number;
    /** Where open borders of different parts run along each other: the option `borderDistance` that joins them. [m] and degrees. */
    border_proposal?: { distance: number; open_length: number; matched_length: number; gap_max: number; seam_deg: number };
    /** Of the option `check`. */
    check?: Check;
}

export interface SmoothedMesh {
    name: string;
    /** Index in the file; null: the format has none. */
    mesh: number | null;
    primitive: number | null;
    vertices: number;
    vertices_split: number;
    normals: 'none' | 'kept' | 'turned' | 'made' | 'replaced' | 'removed';
    tangents: 'none' | 'kept' | 'turned' | 'made' | 'replaced' | 'removed';
}

export interface SmoothRow extends Row {
    file: string;
    output: string;
    changed: boolean;
    vertices_split: number;
    meshes_added: number;
    /** Vertices without a usable normal that got one. */
    missing_made: number;
    meshes: SmoothedMesh[];
    /** Where normals of the file were kept. Angles in degrees. */
    seams?: {
        normals: number;
        turned: number;
        max_deg: number;
        mean_deg: number;
        flat_pairs: number;
        crease_pairs: number;
        unusable: number;
    };
    /** Of the option `borderDistance`. Angles in degrees. */
    borders?: { leading: number; following: number; turned: number; max_deg: number; mean_deg: number; vertices_not_searched: number };
}

export interface RenderRow extends Row {
    file: string;
    width: number;
    height: number;
    triangles: number;
    objects: number;
    engine: string;
}

export interface CompareRow extends Row {
    a: string;
    b: string;
    width: number;
    height: number;
    equal: boolean;
    /** Null: not finite. */
    max_error: number | null;
    rmse: number | null;
    /** Null: without end, as for equal pictures. */
    psnr_db: number | null;
    /** Null: a side has fewer than 11 pixels. */
    ssim: number | null;
    flip: number;
    differing_pixels: number;
    /** 0 to 1. */
    differing_share: number;
    check: Check;
}

export interface ExplainRow extends Row {
    file: string;
    pixel: [number, number];
    width: number;
    height: number;
    is_background: boolean;
    /** Linear, with alpha. */
    color: [number, number, number, number];
    /** Of the picture file, 0 to 255. */
    codes: [number, number, number];
    triangles: Array<Record<string, unknown>>;
    layers: Array<Record<string, unknown>>;
}
