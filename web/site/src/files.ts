// SPDX-License-Identifier: Apache-2.0
// Files that are dropped or chosen: which of them is the model, and what lies beside it.
import type { Model, ModelFile } from './protocol.js';

/** The formats that the page reads, the most likely model first. */
const endings = ['gltf', 'glb', 'obj', 'ply', 'stl', 'off'];

/** What may lie beside it. Other files of a folder are left out. */
const others = ['mtl', 'bin', 'png', 'jpg', 'jpeg', 'tga', 'bmp', 'hdr', 'webp', 'ktx2'];
const mostBytes = 2e9;

/** Of the dialog that chooses files. */
export const accepted = [...endings, ...others].map(ending => `.${ending}`).join();

const endingOf = (path: string): string => path.slice(path.lastIndexOf('.') + 1).toLowerCase();
const depthOf = (path: string): number => path.split('/').length;

/** @returns the paths of all models, the most likely first */
export function modelsIn(files: readonly ModelFile[]): string[] {
    const models = files.map(({ path }) => path).filter(path => endings.includes(endingOf(path)));
    return models.sort((a, b) => depthOf(a) - depthOf(b) || endings.indexOf(endingOf(a)) - endings.indexOf(endingOf(b)) || a.localeCompare(b));
}

/** @throws Error that says what is wrong */
export function modelOf(files: readonly ModelFile[], name?: string): Model {
    const first = name ?? modelsIn(files)[0], kept = files.filter(({ path }) => [...endings, ...others].includes(endingOf(path)));
    const bytes = kept.reduce((sum, file) => sum + (file.bytes instanceof Blob ? file.bytes.size : file.bytes.byteLength), 0);
    if (bytes > mostBytes) throw new Error(`the files have ${(bytes / 1e9).toFixed(1)} GB; the page takes at most ${mostBytes / 1e9}`);
    if (first) return { name: first, files: kept };
    const names = files.map(({ path }) => path).slice(0, 3).join(', ');
    throw new Error(files.length === 0 ? 'there are no files' : `${names}: not a model that the page reads (GLB, glTF, OBJ, PLY, STL, OFF); convert it with the program rakelight`);
}

export const ofList = (list: Iterable<File>): ModelFile[] => [...list].map(file => ({ path: cleaned(file.webkitRelativePath || file.name), bytes: file }));

/** Paths below the model's folder: no step leads out of it. */
const cleaned = (path: string): string => path.split(/[\\/]/).filter(part => part && part !== '.' && part !== '..').join('/');

const readAll = (reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> => new Promise((resolve, reject) => {
    const all: FileSystemEntry[] = [];
    const next = (): void => reader.readEntries(found => {
        if (found.length === 0) return resolve(all);
        all.push(...found);
        next();  // browsers give a hundred at a time
    }, reject);
    next();
});

async function filesOf(entry: FileSystemEntry): Promise<ModelFile[]> {
    if (entry.isFile) {
        const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
        return [{ path: cleaned(entry.fullPath), bytes: file }];
    }
    const found = await readAll((entry as FileSystemDirectoryEntry).createReader());
    return (await Promise.all(found.map(filesOf))).flat();
}

/** All files of a drop, those in folders too. */
export async function dropped(transfer: DataTransfer): Promise<ModelFile[]> {
    const entries = [...transfer.items].map(item => item.webkitGetAsEntry?.()).filter(entry => entry !== null && entry !== undefined);
    if (entries.length === 0) return ofList(transfer.files);
    return (await Promise.all(entries.map(filesOf))).flat();
}
