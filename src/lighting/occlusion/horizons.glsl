// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion from a picture's depths: ground-truth ambient occlusion (Jimenez, Wu, Pesce & Jarabo 2016,
// "Practical Real-Time Strategies for Accurate Indirect Occlusion"). The hemisphere about the viewer's direction v is
// cut into slices, planes through v. In each, surfaces on either side rise over the tangent plane up to a horizon;
// between the two horizons light arrives, and its cosine-weighted share has a closed form. Two things differ from the
// paper. Horizons are angles over the tangent plane (as in Bavoil, Sainz & Dimitrov 2008, "Image-Space Horizon-Based
// Ambient Occlusion"), so a plane never occludes itself. The light that arrives is divided by the unoccluded light of
// the same slices, so a plane has 1 with any number of slices.
//
// Camera axes: looks along -z. fetch_key(maps, column, row): the depth key of a pixel, < 0 in the background and
// outside the picture. Perspective: near / distance; parallel: 1 at near, 0 at far. slice_turn(maps, i): cosine and
// sine of the direction of slice i.
#define RL_OCCLUSION_BIAS 0.004f      // sine of the angle over the tangent plane that is taken for rounding
#define RL_OCCLUSION_FULL 0.5f        // of the radius: what is farther hides less, by 1 - the square of its distance, and at the radius nothing
#define RL_OCCLUSION_SMOOTHING 0.05f  // of the radius: surfaces farther off a pixel's plane have no part in its mean

struct OcclusionFactors {
    int is_parallel;
    int slices;
    int steps;          // to each side of a slice
    real per_steps;
    real ray_x;         // camera x per pixel to the right, y per pixel down: at distance 1, or in parallel views anywhere
    real ray_y;
    real first_x;       // at the center of the picture's first pixel
    real first_y;
    real near;          // [m]
    real depth_range;   // [m] parallel: from near to far
    real radius;        // [m]
    real most_pixels;   // radius on the screen, at most
};

struct OcclusionPoint {
    vec3 position;      // [m]
    vec3 normal;        // unit, towards the viewer
    real radius;        // [m] how far the picture is searched
    real pixels;        // the same on the screen
    real scale;         // 1 / radius as a length where the point is: perspective: of rays at distance 1
    vec3 scaled;        // the position, times nearness and `scale`
    real per_key;       // 1 / the pixel's key; parallel: 0
};

RL_FN vec3 occlusion_position(RL_IN(OcclusionFactors) f, real column, real row, real key)
{
    real x = f.ray_x * column + f.first_x;
    real y = f.ray_y * row + f.first_y;
    if (f.is_parallel != 0) {
        return vec3(x, y, (key - 1.0f) * f.depth_range - f.near);
    }
    real distance = f.near * reciprocal(key);
    return vec3(x * distance, y * distance, -distance);
}

// Change of the key to the next pixel, and how much it bends on to the one after: planes do not.
RL_FN vec2 key_change(real key, real next, real after)
{
    real bend = abs(after - next - (next - key));
    real fault = select(next < 0.0f, real(2e30f), select(after < 0.0f, real(1e30f), bend));
    return vec2(select(next < 0.0f, real(0.0f), next - key), fault);
}

// Change per pixel on the side where the surface continues as a plane.
RL_FN real key_slope(real key, real before, real two_before, real next, real two_next)
{
    vec2 ahead = key_change(key, next, two_next);
    vec2 behind = key_change(key, before, two_before);
    return select(ahead.y <= behind.y, ahead.x, -behind.x);
}

// Keys are affine on the screen, so their slopes are the plane. slope_x, slope_y: per pixel to the right and down.
RL_FN vec3 occlusion_normal(RL_IN(OcclusionFactors) f, real column, real row, real key, real slope_x, real slope_y)
{
    real change_x = slope_x * reciprocal(f.ray_x);
    real change_y = slope_y * reciprocal(f.ray_y);
    if (f.is_parallel != 0) {
        return safe_normalize(vec3(-f.depth_range * change_x, -f.depth_range * change_y, real(1.0f)));
    }
    real per_key = reciprocal(key);
    real x = f.ray_x * column + f.first_x;
    real y = f.ray_y * row + f.first_y;
    real along = x * change_x + y * change_y;
    return safe_normalize(vec3(-change_x * per_key, -change_y * per_key, 1.0f - along * per_key));
}

// slope: change of the key per pixel to the right and down, by key_slope().
RL_FN OcclusionPoint occlusion_point(RL_IN(OcclusionFactors) f, real column, real row, real key, vec2 slope)
{
    OcclusionPoint p;
    p.position = occlusion_position(f, column, row, key);
    p.normal = occlusion_normal(f, column, row, key, slope.x, slope.y);
    real size = -p.position.z;
    if (f.is_parallel != 0) {
        size = 1.0f;
    }
    real pixels = f.radius * reciprocal(max(min(abs(f.ray_x), abs(f.ray_y)) * size, real(1e-30f)));
    p.pixels = min(pixels, f.most_pixels);
    p.radius = f.radius * p.pixels * reciprocal(max(pixels, real(1e-30f)));
    p.scale = size * reciprocal(max(p.radius, real(1e-30f)));
    p.scaled = p.position * (p.scale * reciprocal(size));
    p.per_key = 0.0f;
    if (f.is_parallel == 0) {
        p.per_key = reciprocal(key);
    }
    return p;
}

// By how much what a pixel shows rises over the tangent plane: the square of the angle's sine, as a fraction; what is farther than the
// half of the radius counts for less. All lengths are in radii and times nearness, which is 1 where the point is: no division is needed.
RL_MAP_FN vec2 occlusion_rise(RL_IN(Maps) maps, RL_IN(OcclusionFactors) f, RL_IN(OcclusionPoint) p, real column, real row)
{
    real x = floor(column + 0.5f);
    real y = floor(row + 0.5f);
    real key = fetch_key(maps, x, y);
    real nearness = key * p.per_key;
    real depth = -p.scale;
    if (f.is_parallel != 0) {
        nearness = 1.0f;
        depth = ((key - 1.0f) * f.depth_range - f.near) * p.scale;
    }
    vec3 place = vec3((f.ray_x * x + f.first_x) * p.scale, (f.ray_y * y + f.first_y) * p.scale, depth);
    vec3 way = place - p.scaled * nearness;
    real squared = dot(way, way);
    real nearness2 = nearness * nearness;
    real share = clamp((nearness2 - squared) * (1.0f / (1.0f - RL_OCCLUSION_FULL * RL_OCCLUSION_FULL)), real(0.0f), nearness2);
    real height = max(dot(way, p.normal), real(0.0f)) * share;
    height = select(key < 0.0f, real(0.0f), height);
    return vec2(height * height, nearness2 * nearness2 * squared);
}

// The sine of the highest of these along a line on the screen, ahead and behind. per_meter: [px] along the line. offset: 0..1, which part of
// each step is looked at.
RL_MAP_FN vec2 highest_rises(RL_IN(Maps) maps, RL_IN(OcclusionFactors) f, RL_IN(OcclusionPoint) p, vec2 per_meter, real column, real row, real offset)
{
    vec2 ahead = vec2(real(0.0f), real(1.0f));
    vec2 behind = vec2(real(0.0f), real(1.0f));
    real pixel = reciprocal(max(max(abs(per_meter.x), abs(per_meter.y)), real(1e-30f)));
    for (int i = 0; i < f.steps; ++i) {
        real t = (real(float(i)) + offset) * f.per_steps;
        real along = min(max(p.radius * t * t, pixel), f.most_pixels * pixel);
        real x = per_meter.x * along;
        real y = per_meter.y * along;
        vec2 next = occlusion_rise(maps, f, p, column + x, row + y);
        ahead = select(next.x * ahead.y > ahead.x * next.y, next, ahead);
        next = occlusion_rise(maps, f, p, column - x, row - y);
        behind = select(next.x * behind.y > behind.x * next.y, next, behind);
    }
    return vec2(max(sqrt(ahead.x * reciprocal(ahead.y)) - RL_OCCLUSION_BIAS, real(0.0f)),
                max(sqrt(behind.x * reciprocal(behind.y)) - RL_OCCLUSION_BIAS, real(0.0f)));
}

// acos of -1..1: Abramowitz & Stegun 1964, eq. 4.4.45; error under 7e-5.
RL_FN real occlusion_angle(real cosine)
{
    real c = min(abs(cosine), 1.0f);
    real angle = sqrt(1.0f - c) * (1.5707288f + c * (-0.2121144f + c * (0.0742610f - 0.0187293f * c)));
    return select(cosine < 0.0f, 3.14159265f - angle, angle);
}

// Light of half a slice, from v to a horizon that rises over the tangent plane by an angle of sine `rise`: equation 7
// of the paper. The arguments cos_n and sin_n are of the angle from v to the normal in the slice, towards this side.
RL_FN real occlusion_arc(real rise, real cos_n, real sin_n)
{
    real flat_part = safe_sqrt(1.0f - rise * rise);
    real cos_h = rise * cos_n - flat_part * sin_n;
    real sin_h = flat_part * cos_n + rise * sin_n;
    real cos_other = (1.0f - 2.0f * sin_h * sin_h) * cos_n + 2.0f * sin_h * cos_h * sin_n;
    return 0.25f * (cos_n + 2.0f * occlusion_angle(cos_h) * sin_n - cos_other);
}

// 0..1: the cosine-weighted share of light from the environment that surfaces within the radius let through to the pixel.
RL_MAP_FN real ambient_openness(RL_IN(Maps) maps, RL_IN(OcclusionFactors) f, RL_IN(OcclusionPoint) p, real column, real row, real offset)
{
    vec3 v = vec3(real(0.0f), real(0.0f), real(1.0f));
    real per_distance = 1.0f;
    vec2 slope = vec2(real(0.0f), real(0.0f));
    if (f.is_parallel == 0) {
        v = safe_normalize(-p.position);
        per_distance = reciprocal(-p.position.z);
        slope = vec2(p.position.x * per_distance, p.position.y * per_distance);
    }
    vec3 across = safe_normalize_or(vec3(v.z, real(0.0f), -v.x), vec3(real(1.0f), real(0.0f), real(0.0f)));
    vec3 upward = cross(v, across);
    real n_v = dot(p.normal, v);
    real open = 0.0f;
    real whole = 0.0f;
    for (int i = 0; i < f.slices; ++i) {
        vec2 turn = slice_turn(maps, i);
        vec3 d = across * turn.x + upward * turn.y;
        real n_d = dot(p.normal, d);
        real part = sqrt(max(n_v * n_v + n_d * n_d, real(1e-20f)));
        real cos_n = n_v * reciprocal(part);
        real sin_n = n_d * reciprocal(part);
        vec2 per_meter = vec2((d.x + slope.x * d.z) * per_distance * reciprocal(f.ray_x), (d.y + slope.y * d.z) * per_distance * reciprocal(f.ray_y));
        vec2 rises = highest_rises(maps, f, p, per_meter, column, row, offset);
        // No horizon rises beyond v: nothing between the pixel and the viewer hides it.
        real ahead = min(rises.x * reciprocal(part), select(sin_n < 0.0f, cos_n, real(1.0f)));
        real behind = min(rises.y * reciprocal(part), select(sin_n > 0.0f, cos_n, real(1.0f)));
        open = open + part * (occlusion_arc(ahead, cos_n, sin_n) + occlusion_arc(behind, cos_n, -sin_n));
        whole = whole + part * (occlusion_arc(real(0.0f), cos_n, sin_n) + occlusion_arc(real(0.0f), cos_n, -sin_n));
    }
    real openness = clamp(open * reciprocal(max(whole, real(1e-20f))), real(0.0f), real(1.0f));
    return select(p.pixels < 1.0f, real(1.0f), openness);
}

// What a neighbor's openness counts in a pixel's mean: nothing where it is on another surface. change: [px] to the neighbor; slope: of the pixel's key.
RL_FN real smoothing_weight(RL_IN(OcclusionFactors) f, RL_IN(OcclusionPoint) p, real key, real other, vec2 change, vec2 slope)
{
    real off = abs(other - (key + slope.x * change.x + slope.y * change.y));
    real distance = off * f.depth_range;
    if (f.is_parallel == 0) {
        distance = off * reciprocal(key) * -p.position.z;
    }
    real share = 1.0f - distance * reciprocal(max(p.radius * RL_OCCLUSION_SMOOTHING, real(1e-30f)));
    return select(other < 0.0f, real(0.0f), clamp(share, real(0.0f), real(1.0f)));
}
