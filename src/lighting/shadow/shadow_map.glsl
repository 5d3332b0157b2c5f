// SPDX-License-Identifier: Apache-2.0
// Shadow maps: how much of a light reaches a point. Percentage-closer filtering: Reeves, Salesin & Cook 1987,
// "Rendering Antialiased Shadows with Depth Maps". Each texel is compared with the plane of the point's triangle
// there (receiver plane depth bias: Isidoro 2006, "Shadow Mapping: GPU-based Tips and Techniques"). The plane is
// pushed out along its normal by a part of a texel; towards a light at a grazing angle this grows with the plane's
// slope. How far planes are extended is bounded by what the texels around the point show: a rule of our own.
//
// A map holds how near to the light the nearest surface is. For parallel light this is minus the distance along the way
// it shines; else it is 1 / the distance along the axis of the map, 0: nothing. Over the map it is linear for a plane.
// It is read by fetch_nearness(maps, column, row): row 0 is on top, the faces of a cube are below each other. The
// change of depth along x and down y per width of a texel, at most RL_STEEPEST_SLOPE, is read by fetch_slopes(maps,
// column, row).
#define RL_STEEPEST_SLOPE 8.0f

// Where slopes are kept as whole numbers of 16 bits: (slope + RL_STEEPEST_SLOPE) RL_SLOPE_CODES.
#define RL_SLOPE_CODES 4095.0f

RL_FN vec2 decode_slopes(vec2 codes)
{
    return codes * (1.0f / RL_SLOPE_CODES) - vec2(RL_STEEPEST_SLOPE);
}

// Normal of a triangle's plane, unit, on the side that is seen. It follows from the plane of 1 / w (parallel views: of
// the distance) over the screen: dx, dy per pixel, `at` at the first pixel. In the same way ray_x, ray_y and ray_first
// are the pixels' rays. The result is `otherwise` where the plane is seen from its edge.
RL_FN vec3 plane_normal(vec3 ray_x, vec3 ray_y, vec3 ray_first, real dx, real dy, real at, vec3 otherwise)
{
    vec3 across = cross(ray_y, ray_first);
    real per_volume = reciprocal(dot(ray_x, across));
    // n . ray = 1 / w at all pixels, so n . position = 1: n points away from the eye.
    vec3 n = (across * dx + cross(ray_first, ray_x) * dy + cross(ray_x, ray_y) * at) * per_volume;
    return -safe_normalize_or(n, -otherwise);
}

// back: to the viewer.
RL_FN vec3 parallel_plane_normal(vec3 ray_x, vec3 ray_y, vec3 back, real dx, real dy, vec3 otherwise)
{
    vec3 n = safe_normalize_or(cross(ray_y - back * dy, ray_x - back * dx), otherwise);
    return n * select(dot(n, back) < 0.0f, real(-1.0f), real(1.0f));
}

// One light's map; the same for all lanes.
struct ShadowMap {
    int size;         // [texels] of a side
    int is_cube;      // six faces about +x, -x, +y, -y, +z, -z of the world
    int is_parallel;
    int radius;       // [texels] of the filter
    vec3 right;       // position about the eye -> x to the right, y up, z ahead of the map, about the light: rows
    vec3 up;
    vec3 ahead;
    vec3 origin;      // added to that
    real texels;      // a meter (perspective: a meter at a distance of one) has
    real texel;       // 1 / texels
    real push;        // [m] that surfaces are pushed out (perspective: at a distance of one)
    real reach;       // difference of nearness within which surfaces may meet: 2 RL_STEEPEST_SLOPE (radius + 1) texel
};

// `bias`: of the half texel that surfaces are pushed out by. What follows from texels and radius.
RL_FN void set_reach(RL_INOUT(ShadowMap) s, real bias)
{
    s.texel = 1.0f / s.texels;
    s.push = 0.5f * bias / s.texels;
    s.reach = (2.0f * RL_STEEPEST_SLOPE) * real(float(s.radius + 1)) / s.texels;
}

// About a point light, the face that a vector from it points at.
struct CubeFace {
    mask along_x;
    mask along_y;     // where not along x
    mask is_negative;
    real number;      // 0..5
};

RL_FN CubeFace cube_face(vec3 from_light)
{
    CubeFace face;
    real x = abs(from_light.x);
    real y = abs(from_light.y);
    real z = abs(from_light.z);
    face.along_x = x >= y && x >= z;
    face.along_y = y >= z;
    real largest = select(face.along_x, from_light.x, select(face.along_y, from_light.y, from_light.z));
    face.is_negative = largest < 0.0f;
    face.number = select(face.along_x, 0.0f, select(face.along_y, real(2.0f), real(4.0f))) + select(face.is_negative, real(1.0f), real(0.0f));
    return face;
}

// A vector in the axes of a face: x to the right, y up, z the way it looks.
RL_FN vec3 to_face(RL_IN(CubeFace) face, vec3 v)
{
    real sign_of_face = select(face.is_negative, real(-1.0f), real(1.0f));
    real right = select(face.along_x, v.z, select(face.along_y, v.x, -v.x)) * sign_of_face;
    real up = select(face.along_x, v.y, select(face.along_y, v.z, v.y));
    real ahead = select(face.along_x, v.x, select(face.along_y, v.y, v.z)) * sign_of_face;
    return vec3(right, up, ahead);
}

RL_FN vec3 in_map_axes(RL_IN(ShadowMap) s, vec3 v)
{
    return vec3(dot(s.right, v), dot(s.up, v), dot(s.ahead, v));
}

// Where a point lies on the map, and the plane of its triangle there.
struct OnMap {
    real x;          // [texels] 0.5: the middle of the first one
    real y;
    real nearness;   // at x, y, and its change per texel
    real per_x;
    real per_y;
    real first_row;  // of the face
    real cosine;     // between the plane's normal and the way to the light
};

// at, n: position about the light and normal of the plane, in the axes of the map or of its face.
RL_FN OnMap place_on_map(RL_IN(ShadowMap) s, vec3 at, vec3 n, real first_row)
{
    OnMap m;
    m.first_row = first_row;
    real half_size = 0.5f * float(s.size);
    if (s.is_parallel != 0) {
        vec3 p = at + n * s.push;
        m.cosine = -n.z;
        real steep = select(m.cosine < 0.0f, max(abs(m.cosine), 1e-3f), -max(abs(m.cosine), 1e-3f));
        real per_texel = reciprocal(steep * s.texels);
        m.x = half_size + p.x * s.texels;
        m.y = half_size - p.y * s.texels;
        m.nearness = -p.z;
        m.per_x = n.x * per_texel;
        m.per_y = -(n.y * per_texel);
        return m;
    }
    vec3 p = at + n * (s.push * max(at.z, 1e-18f));
    real per_w = reciprocal(max(p.z, 1e-18f));
    real away = max(length(p), 1e-18f);
    m.cosine = -dot(n, p) / away;
    real least = max(abs(m.cosine), 1e-3f);
    real steep = select(m.cosine < 0.0f, least, -least) * away;
    real per_texel = reciprocal(steep * s.texels);
    m.x = half_size + p.x * per_w * s.texels;
    m.y = half_size - p.y * per_w * s.texels;
    m.nearness = per_w;
    m.per_x = n.x * per_texel;
    m.per_y = -(n.y * per_texel);
    return m;
}

RL_FN OnMap find_on_map(RL_IN(ShadowMap) s, vec3 position, vec3 normal)
{
    vec3 at = in_map_axes(s, position) + s.origin;
    vec3 n = in_map_axes(s, normal);
    if (s.is_cube != 0) {
        CubeFace face = cube_face(at);
        return place_on_map(s, to_face(face, at), to_face(face, n), face.number * float(s.size));
    }
    return place_on_map(s, at, n, 0.0f);
}

// The width of a texel, as a step in nearness, at a surface of this nearness.
RL_FN real texel_width(RL_IN(ShadowMap) s, real nearness)
{
    if (s.is_parallel != 0) {
        return s.texel;
    }
    return s.texel * nearness;
}

// What one texel says of a point.
struct ShadowTap {
    mask is_free;  // nothing covers the point, whatever planes do between the two
    real carried;  // 0..1: the same if both surfaces continue until their planes meet
    mask shows;    // it shows the point's own surface, or one that meets it
};

// Nearness of nothing: it is farther than nothing.
RL_FN real nothing_there(RL_IN(ShadowMap) s)
{
    if (s.is_parallel != 0) {
        return -3.4e38f;
    }
    return 0.0f;
}

// A plane that is steeper than RL_STEEPEST_SLOPE is carried on no steeper than that. x, y: [texels] from the point to the texel.
RL_MAP_FN ShadowTap compare_steep(RL_IN(Maps) maps, RL_IN(ShadowMap) s, RL_IN(OnMap) m, RL_IN(ShadowTap) tap, mask is_steep, real there, real column, real row, real x, real y)
{
    real rise = m.per_x * x + m.per_y * y;
    real width = texel_width(s, m.nearness);
    real per_width = -reciprocal(width);
    real bounded = min(rise, RL_STEEPEST_SLOPE * (abs(x) + abs(y)) * width);
    ShadowTap result = tap;
    result.is_free = there <= max(m.nearness + select(is_steep, bounded, rise), nothing_there(s));
    vec2 slopes = fetch_slopes(maps, column, row);
    mask is_parallel = abs(slopes.x - clamp(m.per_x * per_width, -RL_STEEPEST_SLOPE, RL_STEEPEST_SLOPE)) < 0.25f &&
                       abs(slopes.y - clamp(m.per_y * per_width, -RL_STEEPEST_SLOPE, RL_STEEPEST_SLOPE)) < 0.25f;
    result.shows = result.is_free || (tap.shows && is_parallel);
    return result;
}

// A texel's surface before the point's plane, and near: its plane is carried on to the point.
RL_MAP_FN ShadowTap compare_near(RL_IN(Maps) maps, RL_IN(ShadowMap) s, RL_IN(OnMap) m, RL_IN(ShadowTap) tap, mask is_near, real there, real column, real row, real x, real y)
{
    vec2 slopes = fetch_slopes(maps, column, row);
    real width = texel_width(s, there);
    real behind = m.nearness - there - (slopes.x * x + slopes.y * y) * width;
    real texels_behind = behind * reciprocal(width * (abs(slopes.x) + abs(slopes.y) + 1.0f));
    ShadowTap result = tap;
    result.carried = select(is_near, clamp(1.0f + texels_behind, 0.0f, 1.0f), tap.carried);
    result.shows = tap.shows || (is_near && behind >= 0.0f);
    return result;
}

// The point's plane is carried on to the texel; where the texel's surface is before it, and near, that one's plane to the point:
// behind it, the surfaces meet between the two. The line along which they would is a texel wide.
RL_MAP_FN ShadowTap compare_with(RL_IN(Maps) maps, RL_IN(ShadowMap) s, RL_IN(OnMap) m, mask is_steep, real column, real row, real x, real y)
{
    real there = fetch_nearness(maps, column, row);
    mask before = there > max(m.nearness + (m.per_x * x + m.per_y * y), nothing_there(s));
    ShadowTap tap;
    tap.is_free = !before;
    tap.carried = select(before, real(0.0f), real(1.0f));
    tap.shows = !before;
    if (any_lane(is_steep)) {
        tap = compare_steep(maps, s, m, tap, is_steep, there, column, row, x, y);
    }
    real reach = s.reach;
    if (s.is_parallel == 0) {
        reach = there * s.reach;
    }
    mask is_near = before && there - m.nearness < reach;
    if (any_lane(is_near)) {
        return compare_near(maps, s, m, tap, is_near, there, column, row, x, y);
    }
    return tap;
}

// Weight of tap i of 0..last of a box that begins and ends within texels.
RL_FN real tap_weight(int i, int last, real share)
{
    if (i == 0) {
        return 1.0f - share;
    }
    if (i == last) {
        return share;
    }
    return 1.0f;
}

// Fraction of a square of 2 radius + 1 texels around the point that nothing covers. A texel's surface covers the point
// if it is in front of the point's plane there and, extended to the point, in front of the point itself. So floors and
// walls that meet do not darken each other along the edge. Both may end before they meet, so the planes count as far
// as the four texels around the point show it. Where none does, deep in a shadow, the point's plane rises by at most
// RL_STEEPEST_SLOPE (the facets of rough ground are steep and small), and no texel's plane is extended.
RL_MAP_FN real uncovered(RL_IN(Maps) maps, RL_IN(ShadowMap) s, RL_IN(OnMap) m)
{
    real last = real(float(s.size - 1));
    real x = clamp(m.x - 0.5f, 0.0f, last);
    real y = clamp(m.y - 0.5f, 0.0f, last);
    real left = floor(x);
    real top = floor(y);
    real fx = x - left;
    real fy = y - top;
    real steepest = texel_width(s, m.nearness) * RL_STEEPEST_SLOPE;
    mask is_steep = abs(m.per_x) > steepest || abs(m.per_y) > steepest;
    int end = 2 * s.radius + 1;
    real carried = 0.0f;
    real free = 0.0f;
    real shown = 0.0f;
    for (int j = 0; j <= end; ++j) {
        real down = real(float(j - s.radius));
        real row = m.first_row + clamp(top + down, 0.0f, last);
        real weight_y = tap_weight(j, end, fy);
        for (int i = 0; i <= end; ++i) {
            real aside = real(float(i - s.radius));
            ShadowTap tap = compare_with(maps, s, m, is_steep, clamp(left + aside, 0.0f, last), row, aside - fx, down - fy);
            real weight = tap_weight(i, end, fx) * weight_y;
            carried = carried + tap.carried * weight;
            free = free + select(tap.is_free, weight, real(0.0f));
            if ((i == s.radius || i == s.radius + 1) && (j == s.radius || j == s.radius + 1)) {
                real share = tap_weight(i - s.radius, 1, fx) * tap_weight(j - s.radius, 1, fy);
                shown = shown + select(tap.shows, share, real(0.0f));
            }
        }
    }
    float side = float(end);
    return (free + (carried - free) * shown) * (1.0f / (side * side));
}

// 0..1: how much of the light arrives at a position about the eye. `normal`: of its triangle's plane, unit, on the side that is seen.
// Faces that look away from the light have none: down to where the normals of neighbors, by which curved surfaces are lit, can differ
// from theirs, it fades.
RL_MAP_FN real shadow_factor(RL_IN(Maps) maps, RL_IN(ShadowMap) s, vec3 position, vec3 normal)
{
    OnMap m = find_on_map(s, position, normal);
    real fade = clamp(1.0f + 5.0f * m.cosine, 0.0f, 1.0f);
    return uncovered(maps, s, m) * fade;
}
