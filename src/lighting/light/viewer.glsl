// SPDX-License-Identifier: Apache-2.0
// The way from a point to the viewer: unit. Positions are about the eye; in parallel views, and for a viewer infinitely far
// away, all points have the same `view_direction`.
RL_FN vec3 to_viewer(vec3 position, vec3 view_direction, int is_parallel)
{
    if (is_parallel != 0) {
        return view_direction;
    }
    return -safe_normalize(position);
}
