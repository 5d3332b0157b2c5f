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

// The same from a vertex, not unit: as a vertex stage hands it on, to be interpolated.
RL_FN vec3 vertex_to_viewer(vec3 position, vec3 view_direction, int is_parallel)
{
    if (is_parallel != 0) {
        return view_direction;
    }
    return -position;
}

// Likewise to a light: a directional one shines along its direction.
RL_FN vec3 vertex_to_light(vec3 position, vec3 light_position, vec3 light_direction, int is_directional)
{
    if (is_directional != 0) {
        return -light_direction;
    }
    return light_position - position;
}
