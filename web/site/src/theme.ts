// SPDX-License-Identifier: Apache-2.0
// Dark or light: as the system is, until somebody chooses.

const dark = matchMedia('(prefers-color-scheme: dark)');
const isDark = (): boolean => (document.documentElement.dataset.theme ?? (dark.matches ? 'dark' : 'light')) === 'dark';

/** The background of the picture, as a display color. */
export const themeColor = (): string => (isDark() ? '#15171c' : '#e9ecf1');

/** @param button  changes the theme  @param change  called when it is another one */
export function changeTheme(button: HTMLElement, change: () => void): void {
    button.addEventListener('click', () => {
        document.documentElement.dataset.theme = isDark() ? 'light' : 'dark';
        change();
    });
    dark.addEventListener('change', change);
}
