// SPDX-License-Identifier: Apache-2.0
// The AgX curves in GLSL, equal to AgxCurves of tone_kernel.h: Sobotka's sigmoid over the logarithm of light from 10
// EV below to 6.5 EV above 0.18, with slope 2 at the pivot; and the display's power.

float agx_contrast(Maps maps, float light)
{
    const float pivot = 10.0f / 16.5f;
    float x = clamp((log2(clamp(light, exp2(-13.0f), 32.0f) / 0.18f) + 10.0f) / 16.5f, 0.0f, 1.0f);
    bool is_above = x > pivot;
    float power = is_above ? 3.25f : 3.0f;
    float span = is_above ? 1.0f - pivot : pivot;
    float a = (pow(4.0f * span, power) - 1.0f) / pow(span, power);  // so that the curve ends at 0 or 1
    float from = abs(x - pivot);
    float rise = 2.0f * from / pow(1.0f + a * pow_positive(from, power), 1.0f / power);
    return clamp(is_above ? 0.5f + rise : 0.5f - rise, 0.0f, 1.0f);
}

float agx_power(Maps maps, float display) { return pow_positive(clamp(display, 0.0f, 1.0f), 2.2f); }
