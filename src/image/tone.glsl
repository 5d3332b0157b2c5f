// SPDX-License-Identifier: Apache-2.0
// Tone curves: unbounded linear light -> displayable linear light (sources: tone_curves.h). Shared by GLSL and C++,
// like src/lighting. The includer defines agx_contrast(maps, light) and agx_power(maps, display): by tables in C++, by
// agx_curves.glsl in GLSL.
#define RL_TONE_NONE 0
#define RL_TONE_REINHARD 1
#define RL_TONE_NEUTRAL 2
#define RL_TONE_ACES 3
#define RL_TONE_AGX 4

RL_FN vec3 clamp_color(vec3 c, real high)
{
    return vec3(clamp(c.x, 0.0f, high), clamp(c.y, 0.0f, high), clamp(c.z, 0.0f, high));
}

// The luminance (Rec. 709) becomes L / (1 + L).
RL_FN vec3 tone_reinhard(vec3 c)
{
    real luminance = 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
    return c * (1.0f / (1.0f + luminance));
}

RL_FN vec3 tone_neutral(vec3 light)
{
    real f90 = 0.04f;
    real start = 0.8f - 0.04f;
    real room = 1.0f - start;
    real least = min(min(light.x, light.y), light.z);
    vec3 c = light - vec3(select(least < 2.0f * f90, least - least * least / (4.0f * f90), f90));
    real peak = max(max(c.x, c.y), c.z);
    real lowered = 1.0f - room * room / (peak + room - start);
    real kept = 1.0f / (0.15f * (peak - lowered) + 1.0f);
    vec3 high = c * (lowered / peak * kept) + vec3(lowered * (1.0f - kept));
    return select(peak < start, c, high);
}

RL_FN real aces_fit(real v)
{
    return (v * (v + 0.0245786f) - 0.000090537f) / (v * (0.983729f * v + 0.4329510f) + 0.238081f);
}

RL_FN vec3 tone_aces(vec3 c)
{
    real r = aces_fit(dot(vec3(0.59719f, 0.35458f, 0.04823f), c));
    real g = aces_fit(dot(vec3(0.07600f, 0.90834f, 0.01566f), c));
    real b = aces_fit(dot(vec3(0.02840f, 0.13383f, 0.83777f), c));
    vec3 v = vec3(r, g, b);
    return vec3(dot(vec3(1.60475f, -0.53108f, -0.07367f), v), dot(vec3(-0.10208f, 1.10813f, -0.00605f), v),
                dot(vec3(-0.00327f, -0.07276f, 1.07602f), v));
}

RL_MAP_FN vec3 tone_agx(RL_IN(Maps) maps, vec3 c)
{
    real r = agx_contrast(maps, dot(vec3(0.842479062253094f, 0.0784335999999992f, 0.0792237451477643f), c));
    real g = agx_contrast(maps, dot(vec3(0.0423282422610123f, 0.878468636469772f, 0.0791661274605434f), c));
    real b = agx_contrast(maps, dot(vec3(0.0423756549057051f, 0.0784336f, 0.879142973793104f), c));
    vec3 v = vec3(r, g, b);
    return vec3(agx_power(maps, dot(vec3(1.19687900512017f, -0.0980208811401368f, -0.0990297440797205f), v)),
                agx_power(maps, dot(vec3(-0.0528968517574562f, 1.15190312990417f, -0.0989611768448433f), v)),
                agx_power(maps, dot(vec3(-0.0529716355144438f, -0.0980434501171241f, 1.15107367264116f), v)));
}

// Light times `gain` under a curve, RL_TONE_...; curves take negative light and NaN as 0, more than a million as a million.
RL_MAP_FN vec3 tone_curve(RL_IN(Maps) maps, int mapping, vec3 light, real gain)
{
    vec3 c = light * gain;
    if (mapping == RL_TONE_REINHARD) {
        return tone_reinhard(clamp_color(c, 1e6f));
    }
    if (mapping == RL_TONE_NEUTRAL) {
        return tone_neutral(clamp_color(c, 1e6f));
    }
    if (mapping == RL_TONE_ACES) {
        return clamp_color(tone_aces(clamp_color(c, 1e6f)), 1.0f);
    }
    if (mapping == RL_TONE_AGX) {
        return tone_agx(maps, clamp_color(c, 1e6f));
    }
    return c;
}
