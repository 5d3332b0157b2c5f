// SPDX-License-Identifier: Apache-2.0
// Attenuation of light by distance. Classical: OpenGL 2.1 specification, section 2.14.1. Photometric: KHR_lights_punctual.

// [1] 1 / (c + l d + q d^2); the denominator counts as at least 1e-12, so that d = 0 with c = 0 stays finite.
RL_FN real classical_attenuation(real d, real constant_term, real linear_term, real quadratic_term)
{
    return reciprocal(max(constant_term + d * (linear_term + quadratic_term * d), 1e-12f));
}

// [1] cos^exponent inside the cone, 0 outside. cos_angle between the spot's axis and the ray to the surface.
// A cut-off of 90 degrees is cos_cutoff = 0: the rear half stays dark.
RL_FN real classical_spot(real cos_angle, real cos_cutoff, real exponent)
{
    return select(cos_angle >= cos_cutoff, pow_positive(min(1.0f, cos_angle), exponent), 0.0f);
}

// [1] window of a range: max(min(1 - (d / range)^4, 1), 0). Classical lights that end have it, too.
RL_FN real range_window(real distance_squared, real inverse_range)
{
    real ratio = min(distance_squared, 1e37f) * inverse_range * inverse_range;
    return clamp(1.0f - ratio * ratio, 0.0f, 1.0f);
}

// [1/m^2] inverse square with that window; inverse_range 0: no range. Distances under 0.1 mm count as that.
RL_FN real photometric_attenuation(real distance_squared, real inverse_range)
{
    real d2 = clamp(distance_squared, 1e-8f, 1e37f);
    return range_window(d2, inverse_range) / d2;
}

// [1] cone_scale = 1 / max(0.001, cos inner - cos outer), cone_offset = -cos outer * cone_scale; squared as the extension's note.
RL_FN real photometric_spot(real cos_angle, real cone_scale, real cone_offset)
{
    real falloff = clamp(cos_angle * cone_scale + cone_offset, 0.0f, 1.0f);
    return falloff * falloff;
}
