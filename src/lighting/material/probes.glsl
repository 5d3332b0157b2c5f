// SPDX-License-Identifier: Apache-2.0
// Samples along the longer side of a pixel's footprint, each as wide as the shorter one: GL_EXT_texture_filter_anisotropic, its
// section 3.8.8, with the footprint's axes as they are.
struct Probes {
    mask is_stretched;  // else one sample as of square footprints
    real count;
    real inverse;       // 1 / count
    real lod;
    vec2 axis;
};

// dx, dy: change of texture coordinates from pixel to pixel; size [texels]; at most `most` probes.
RL_FN Probes probes_of(vec2 dx, vec2 dy, vec2 size, int most)
{
    vec2 x = dx * size;
    vec2 y = dy * size;
    real along_x = dot(x, x);
    real along_y = dot(y, y);
    real longer = max(along_x, along_y);
    real shorter = max(min(along_x, along_y), 1e-20f);
    real count = ceil(clamp(sqrt(longer / shorter), 1.0f, real(float(most))));
    Probes p;
    p.is_stretched = count > 1.0f && longer > 1.0f;  // what is magnified needs one sample
    p.count = select(p.is_stretched, count, 1.0f);
    p.inverse = reciprocal(p.count);
    p.lod = 0.5f * log2_coarse(longer * p.inverse * p.inverse);
    p.axis = select(along_x >= along_y, dx, dy);
    return p;
}

// Texture coordinates of probe i of a pixel whose middle is uv.
RL_FN vec2 probe_place(RL_IN(Probes) p, vec2 uv, int i)
{
    return uv + p.axis * ((real(float(i)) + 0.5f) * p.inverse - 0.5f);
}
