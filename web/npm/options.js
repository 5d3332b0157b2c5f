// SPDX-License-Identifier: Apache-2.0
// Options by their words, as the modules take them by number.

/** An error of the input; its message has the part and the place. */
export class AttributesError extends Error {
    name = 'AttributesError';
}

export const scopes = ['face', 'object', 'model'];
export const weights = ['uniform', 'area', 'angle', 'angle-area', 'max', 'fit', 'auto'];
export const tangentModes = ['averaged', 'published', 'mikktspace', 'published-no-handedness'];
export const tangentChoices = ['auto', 'always', 'never'];

export function numberOf(words, word, what) {
    const number = words.indexOf(word);
    if (number < 0) throw new AttributesError(`${what} must be ${words.join(', ')}, not ${JSON.stringify(word)}`);
    return number;
}

export function radians(degrees, what) {
    if (!(degrees >= 0 && degrees <= 180)) throw new AttributesError(`${what} must be 0 to 180 degrees, not ${degrees}`);
    return degrees * Math.PI / 180;
}

/** @returns how creases are found: [by the rule?, angle in radians], which for the rule limits only borders that match */
export function creasesOf(crease) {
    return crease === 'auto' ? [1, radians(60)] : [0, radians(crease, 'crease')];
}

/** A misspelled option would be without effect. */
export function checkNames(options, names) {
    for (const name of Object.keys(options))
        if (!names.includes(name)) throw new AttributesError(`there is no option ${JSON.stringify(name)}: ${names.join(', ')}`);
}
