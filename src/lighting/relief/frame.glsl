// SPDX-License-Identifier: Apache-2.0
// The frame of a point in which normal maps act, and lighting in tangent space: directions taken through the inverse (or the
// transposed) of the frame's matrix, at the pixel, or at the vertices with interpolation between them.
struct Frame {
    vec3 normal;       // unit, as interpolated: not on the viewer's side
    vec3 tangent;      // unit, perpendicular; bitangent = cross(normal, tangent) * w
    vec3 map_normal;   // what a normal map acts in: may be neither unit nor perpendicular
    vec3 map_tangent;
    vec3 map_bitangent;  // cross(map_normal, map_tangent) * w, or an attribute of its own
    real w;
    real side;   // +1, -1: normals are lit on this side
};

// Where no bumps act: only normal and side count. `normal` is not unit.
RL_FN Frame even_frame(vec3 normal, real side)
{
    Frame f;
    f.normal = safe_normalize(normal);
    f.map_normal = f.normal;
    f.tangent = f.normal;
    f.map_tangent = f.normal;
    f.map_bitangent = f.normal;
    f.w = side;
    f.side = side;
    return f;
}

// `normal`, `tangent` interpolated, not unit; w of the tangent. orthogonalize 0: the map's tangent is only made unit;
// normalize 0: the map acts in the vectors as they are.
RL_FN Frame bump_frame(vec3 normal, real side, vec3 tangent, real w, int orthogonalize, int normalize_both)
{
    Frame f = even_frame(normal, side);
    f.tangent = orthogonal_tangent(f.normal, tangent);
    f.map_tangent = map_tangent(f.normal, tangent, orthogonalize);
    f.w = w;
    if (normalize_both == 0) {
        f.map_normal = normal;
        f.map_tangent = tangent;
    }
    f.map_bitangent = cross(f.map_normal, f.map_tangent) * w;
    return f;
}

// `bitangent` interpolated, not unit: an attribute of its own, which a map acts along as it is. Where it vanishes the frame keeps its
// own. After bump_frame().
RL_FN void set_bitangent(RL_INOUT(Frame) f, vec3 bitangent, int normalize_both)
{
    vec3 unit = safe_normalize_or(bitangent, f.map_bitangent);
    f.map_bitangent = unit;
    if (normalize_both == 0) {
        f.map_bitangent = bitangent;
    }
}

// A direction of the world in (tangent, bitangent, normal on the seen side).
RL_FN vec3 seen_in_frame(RL_IN(Frame) f, vec3 d)
{
    return vec3(dot(d, f.tangent), dot(d, cross(f.normal, f.tangent)) * f.w, dot(d, f.normal) * f.side);
}

// (tangent, bitangent, normal) coordinates of the frame n, t, w -> a vector of the world.
RL_FN vec3 from_tangent_space(vec3 n, vec3 t, real w, vec3 d)
{
    return t * d.x + cross(n, t) * (w * d.y) + n * d.z;
}

// A vector of the world in the frame n, t, b: by the inverse of its matrix, or by the transposed one, which is the
// inverse of orthonormal frames only. The rows of the inverse are the cross products of the columns over the
// determinant.
RL_FN vec3 to_tangent_space(vec3 n, vec3 t, vec3 b, int is_transposed, vec3 d)
{
    if (is_transposed != 0) {
        return vec3(dot(t, d), dot(b, d), dot(n, d));
    }
    vec3 across = cross(b, n);
    real determinant = dot(t, across);
    real scale = 1.0f / select(abs(determinant) < 1e-12f, 1.0f, determinant);
    return vec3(dot(across, d), dot(cross(n, t), d), dot(cross(t, b), d)) * scale;
}

// A direction that tangent space knows as d, turned into the world by the orthonormal frame, which changes no angle: lighting goes
// on as ever. `world`: the direction itself, where d has none. Unit.
RL_FN vec3 tangent_space_direction(RL_IN(Frame) f, vec3 d, vec3 world)
{
    return safe_normalize_or(from_tangent_space(f.normal, f.tangent, f.w, d), world);
}

// The normal that a map's vector (not unit) makes, on the side that is lit. is_in_world: the map acts in map_normal, map_tangent.
RL_FN vec3 mapped_normal(RL_IN(Frame) f, vec3 mapped, int is_in_world)
{
    if (is_in_world != 0) {
        return perturb_normal_in_frame(f.map_normal, f.map_tangent, f.map_bitangent, mapped) * f.side;
    }
    return perturb_normal(f.normal, f.tangent, f.w, mapped) * f.side;
}

// The same of heights, whose vector is on the seen side already.
RL_FN vec3 sloped_normal(RL_IN(Frame) f, vec3 sloped)
{
    return perturb_normal(f.normal * f.side, f.tangent, f.w * f.side, sloped);
}
