// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: runs the lighting text over arrays, as an engine's kernel would.
#include "lighting_kernel.h"
#include "lighting/lighting.h"

namespace rakelight::lighting_test::RL_ISA {

RL_USE_WIDE;
using namespace rakelight::lighting::RL_ISA;
using rakelight::lighting::LightParameters;

static vec3 load3(const Inputs& in, int column, int at) {
    return vec3(load(in.column[column] + at), load(in.column[column + 1] + at), load(in.column[column + 2] + at));
}
static void store3(float* const* out, int at, vec3 x) {
    store(out[0] + at, x.x);
    store(out[1] + at, x.y);
    store(out[2] + at, x.z);
}

// Loads one step's items; not every function uses all of them.
#define RL_LOOP(step)                                                                                \
    for (int at = 0; at < in.count; at += lanes) {                                                   \
        [[maybe_unused]] vec3 n = load3(in, 0, at), l = load3(in, 3, at), v = load3(in, 6, at);      \
        [[maybe_unused]] vec3 ka = load3(in, 9, at), kd = load3(in, 12, at), ks = load3(in, 15, at); \
        [[maybe_unused]] vec3 p = load3(in, 18, at);                                                 \
        [[maybe_unused]] real e = load(in.column[21] + at), s = load(in.column[22] + at),            \
                              t = load(in.column[23] + at);                                          \
        step;                                                                                        \
    }

#define RL_REAL(name, result) \
    static void run_##name(const Inputs& in, float* const* out) { RL_LOOP(store(out[0] + at, result)) }
#define RL_VEC3(name, result) \
    static void run_##name(const Inputs& in, float* const* out) { RL_LOOP(store3(out, at, result)) }
#include "lighting_operations.inc"
#undef RL_REAL
#undef RL_VEC3

#define RL_REAL(name, result) {#name, 1, run_##name},
#define RL_VEC3(name, result) {#name, 3, run_##name},
static const Operation operations[] = {
#include "lighting_operations.inc"
};

static Reflection reflection_of(Choice choice) {
    Reflection reflection;
    reflection.model = choice.model;
    reflection.form = choice.form;
    reflection.horizon = choice.horizon;
    reflection.whole_exponent = choice.whole_exponent;
    return reflection;
}

static Surface surface_of(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, real e, Choice choice) {
    Surface surface;
    surface.n = n;
    surface.v = v;
    surface.ambient = ka;
    surface.diffuse = kd;
    surface.specular = ks;
    surface.exponent = e;
    surface.lobe_scale = lobe_scale(e, reflection_of(choice));
    return surface;
}

static void terms_of_step(const Surface& surface, vec3 l, vec3 p, const LightParameters* light, Choice choice,
                          float* const* out, int at) {
    LightSample met;
    met.l = l;
    met.attenuation = 1.0f;
    met.ambient = met.diffuse = met.specular = vec3(1.0f);
    if (light != nullptr) met = sample_light(*light, p);
    const LightTerms terms = light_terms(surface, met, reflection_of(choice));
    store3(out, at, terms.ambient);
    store3(out + 3, at, terms.diffuse);
    store3(out + 6, at, terms.specular);
}

static void terms(const Inputs& in, const LightParameters* light, Choice choice, float* const* out) {
    RL_LOOP(terms_of_step(surface_of(n, v, ka, kd, ks, e, choice), l, p, light, choice, out, at))
}

static void sum(const Inputs& in, const LightParameters* lights, int light_count, Choice choice, float* const* out) {
    RL_LOOP(vec3 total = vec3(0.0f);
            for (int i = 0; i < light_count; ++i) total =
                add_light(total, surface_of(n, v, ka, kd, ks, e, choice), sample_light(lights[i], p), reflection_of(choice));
            store3(out, at, total))
}

const Kernel kernel = {lanes, operations, int(sizeof operations / sizeof operations[0]), terms, sum};

}  // namespace rakelight::lighting_test::RL_ISA
