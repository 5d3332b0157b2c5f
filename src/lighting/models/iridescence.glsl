// SPDX-License-Identifier: Apache-2.0
// What a thin film over a surface reflects. Source: Belcour & Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling
// of Varying Iridescence", in the approximated form of KHR_materials_iridescence: two orders of Airy's sum, sensitivities of the eye as
// Gaussians over the optical path difference. In air; Schlick's formula at both borders of the film.

// cos(2 pi turns); error under 1e-6 for some tens of turns.
RL_FN real cosine_of_turns(real turns)
{
    real t = turns - floor(turns + 0.5f);
    real s = t * t;
    real sum = 6.52770596f;
    sum = sum * s - 25.9668846f;
    sum = sum * s + 60.1674298f;
    sum = sum * s - 85.4501134f;
    sum = sum * s + 64.9391159f;
    sum = sum * s - 19.7392045f;
    return sum * s + 0.999999989f;
}

// Fourier transforms of the color matching functions: path [um] of difference, turns: what each component's phase is shifted by.
// Linear RGB (Rec. 709), 1 where there is no difference.
RL_FN vec3 film_sensitivity(real path, vec3 turns)
{
    real squared = path * path;
    real x = 0.84659f * cosine_of_turns(1.6810f * path + turns.x) * exp(-0.170854696f * squared);
    x = x + 0.153868307f * cosine_of_turns(2.2399f * path + turns.x) * exp(-0.178766171f * squared);
    real y = 1.00022189f * cosine_of_turns(1.7953f * path + turns.y) * exp(-0.367330884f * squared);
    real z = 1.00112249f * cosine_of_turns(2.2084f * path + turns.z) * exp(-0.261035242f * squared);
    return vec3(3.2404542f * x - 1.5371385f * y - 0.4985314f * z, 1.8760108f * y - 0.9692660f * x + 0.0415560f * z, 0.0556434f * x - 0.2040259f * y + 1.0572252f * z);
}

// The border between film and base, of one color.
struct FilmBase {
    real reflected;
    real turns;  // of phase on the way: 1/2 where the film is the denser one
};

// f0: of the base in air, 0..1; index: of the film; weight: Schlick's, in the film.
RL_FN FilmBase film_base(real f0, real index, real weight)
{
    FilmBase base;
    real root = sqrt(clamp(f0, 0.0f, 0.9999f));
    real below = (1.0f + root) / (1.0f - root);
    real amplitude = (below - index) / (below + index);
    real r = amplitude * amplitude;
    base.reflected = r + (1.0f - r) * weight;
    base.turns = select(below < index, 0.5f, 0.0f);
    return base;
}

// 0..1: of a base with this f0 under a film. index >= 1; thickness [um]; cosine: n.v.
RL_FN vec3 film_reflectance(vec3 f0, real index, real thickness, real cosine)
{
    real c = clamp(cosine, 0.0f, 1.0f);
    real inside = safe_sqrt(refracted_cosine_squared(c, reciprocal(index)));
    real amplitude = (index - 1.0f) / (index + 1.0f);
    real first = amplitude * amplitude;
    first = first + (1.0f - first) * schlick_weight(c);
    real through = 1.0f - first;
    real weight = schlick_weight(inside);
    FilmBase red = film_base(f0.x, index, weight);
    FilmBase green = film_base(f0.y, index, weight);
    FilmBase blue = film_base(f0.z, index, weight);
    vec3 second = vec3(red.reflected, green.reflected, blue.reflected);
    vec3 turns = vec3(red.turns + 0.5f, green.turns + 0.5f, blue.turns + 0.5f);  // the border to the air turns by 1/2 from below
    vec3 trip = min(max(second * first, vec3(1e-5f)), vec3(0.9999f));            // once to and fro in the film
    vec3 mean = second * (through * through) / (vec3(1.0f) - trip);
    vec3 part = mean - vec3(through);
    vec3 factor = vec3(sqrt(trip.x), sqrt(trip.y), sqrt(trip.z));
    real path = 2.0f * index * thickness * inside;
    vec3 sum = vec3(first) + mean + part * factor * film_sensitivity(path, turns) * 2.0f;
    sum = sum + part * factor * factor * film_sensitivity(2.0f * path, turns * 2.0f) * 2.0f;
    return min(max(sum, vec3(0.0f)), vec3(1.0f));
}
