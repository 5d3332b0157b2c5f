// SPDX-License-Identifier: Apache-2.0
// Source: Blinn 1978, "Simulation of Wrinkled Surfaces" (the idea); tangent-space maps as glTF 2.0, section 3.9.3: green up.

// From a texel in 0..1: 2 rgb - 1, x and y times scale. Not unit: perturb_normal normalizes.
RL_FN vec3 decode_normal(vec3 texel, real scale)
{
    return vec3((2.0f * texel.x - 1.0f) * scale, (2.0f * texel.y - 1.0f) * scale, 2.0f * texel.z - 1.0f);
}

// The same for twice the texel and scale 1.
RL_FN vec3 decode_twice_normal(vec3 twice_texel)
{
    return twice_texel - vec3(1.0f);
}

// The other reading of a byte: 128 means exactly 0, 1 and 255 mean -1 and +1.
RL_FN vec3 decode_normal_centered(vec3 texel, real scale)
{
    vec3 m = (texel * 255.0f - vec3(128.0f)) / 127.0f;
    return vec3(m.x * scale, m.y * scale, m.z);
}

// A texel in 0..1 as the material says: which byte is 0, and whether green points down.
RL_FN vec3 decode_mapped(vec3 texel, real scale, int is_centered, int is_green_down)
{
    vec3 m = decode_normal(texel, scale);
    if (is_centered != 0) {
        m = decode_normal_centered(texel, scale);
    }
    if (is_green_down != 0) {
        return vec3(m.x, -m.y, m.z);
    }
    return m;
}

// t made perpendicular to the unit normal n (Gram-Schmidt) and unit again. If t is parallel to n, it is replaced by
// the axis x, or by y if the x of n exceeds 0.7.
RL_FN vec3 orthogonal_tangent(vec3 n, vec3 t)
{
    real along = dot(n, t);
    vec3 across = t - n * along;
    real squared = dot(across, across);  // |t|^2 is this and the square of `along`
    mask has_direction = squared > 1e-12f * along * along && squared >= 1.17549435e-38f && squared <= 3.40282347e38f;
    vec3 unit = across * reciprocal(sqrt(squared));
    if (RL_NEEDS_NO_FALLBACK(has_direction)) {
        return unit;
    }
    vec3 axis = select(abs(n.x) > 0.7f, vec3(0.0f, 1.0f, 0.0f), vec3(1.0f, 0.0f, 0.0f));
    return select(has_direction, unit, safe_normalize(axis - n * dot(n, axis)));
}

// The tangent that a normal map acts along: perpendicular to the unit normal n, or as it is interpolated, only made unit.
RL_FN vec3 map_tangent(vec3 n, vec3 t, int orthogonalize)
{
    vec3 across = orthogonal_tangent(n, t);
    if (orthogonalize != 0) {
        return across;
    }
    return safe_normalize_or(t, across);
}

// The frame's normal: m in (tangent t, bitangent, normal n), bitangent = cross(n, t) * w. Unit; n where the sum vanishes.
RL_FN vec3 perturb_normal(vec3 n, vec3 t, real w, vec3 m)
{
    vec3 b = cross(n, t);
    return safe_normalize_or(t * m.x + b * (w * m.y) + n * m.z, n);
}

// The same where the bitangent b is an attribute of its own: a frame that need not be orthogonal.
RL_FN vec3 perturb_normal_in_frame(vec3 n, vec3 t, vec3 b, vec3 m)
{
    return safe_normalize_or(t * m.x + b * m.y + n * m.z, n);
}
