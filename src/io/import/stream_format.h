// SPDX-License-Identifier: Apache-2.0
// The stream that rakelight-import writes and the program reads: what a foreign model file held, before it means anything.
//
// Both sides include this one file. A record's fields are named once, in transfer(); writing and reading run the same text,
// so the two cannot drift apart. Layout: Head, then (kind scene) Document, its meshes one by one, end mark; or (kind
// refusal) one text. Numbers are little-endian, arrays a 64-bit count and their elements, texts a 32-bit count and bytes.
// The reader believes nothing: see stream_reader.h.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight::io::import_stream {

static_assert(std::endian::native == std::endian::little, "the stream is written by memcpy");

inline constexpr std::uint64_t magic = 0x31504D4954474B52;  // "RKGTIMP1"
inline constexpr std::uint32_t version = 4;                 // both programs come from one build; raise at every change
inline constexpr std::uint64_t end_mark = 0x444E45504D49474B;  // the last eight bytes: nothing was lost
inline constexpr std::uint32_t nothing = 0xFFFFFFFF;           // "no such element" of every index

enum class Kind : std::uint32_t { scene = 1, refusal = 2 };

struct Head {
    std::uint64_t stream_magic = magic;
    std::uint32_t stream_version = version;
    std::uint32_t kind = 0;
};

/// Where the file's axes and its length unit stand (FBX, Blend; Assimp's other readers turn and scale the root node
/// themselves). Axis numbers are 0 x, 1 y, 2 z; signs +1 or -1; unit in meters.
struct AxisSystem {
    std::int32_t up = 1, up_sign = 1, front = 2, front_sign = 1, side = 0, side_sign = 1;
    double unit_m = 1;
};

/// A picture inside the model: encoded bytes (width = 0), or width * height raw pixels of RGBA bytes.
struct Picture {
    std::string name, hint;
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> bytes;
};

enum class Role : std::uint32_t { diffuse, specular, normal, height, opacity, emission, occlusion, count };
enum class WrapMode : std::uint32_t { repeat, clamp, mirror, count };

/// How the five numbers of a texture placement are meant: `standard` scales, turns about (0.5, 0.5), then moves; `max`
/// (3DS, ASE) moves backwards first, then scales and turns about (0.5, 0.5).
enum class Placement : std::uint32_t { standard, max, count };

struct TextureLink {
    std::string path;                 ///< as the file has it; empty when `picture` counts
    std::uint32_t picture = nothing;  ///< into Document::pictures
    std::uint32_t role = 0, uv_set = 0, wrap_u = 0, wrap_v = 0, placement = 0;
    std::array<float, 2> offset{0, 0}, scale{1, 1};  ///< v up
    float rotation_rad = 0;
};

/// Colors are display values; `has` says which of them the file gave.
struct Surface {
    enum Has : std::uint32_t {
        has_diffuse = 1,
        has_specular = 2,
        has_ambient = 4,
        has_emission = 8,
        has_shininess = 16
    };
    std::string name;
    std::uint32_t has = 0, two_sided = 0, unlit = 0;
    vec3 diffuse{1, 1, 1}, specular{0, 0, 0}, ambient{0, 0, 0}, emission{0, 0, 0};
    float shininess = 0, opacity = 1, bump_scale = 1;
    std::vector<TextureLink> links;
};

struct Place {
    std::string name;
    std::uint32_t parent = nothing;
    std::uint32_t animated = 0;  ///< translation, rotation and scale count, not the matrix
    dmat4 matrix;
    dvec3 translation{0, 0, 0}, scale{1, 1, 1};
    dquat rotation;
    std::vector<std::uint32_t> meshes;
};

struct Lamp {
    std::string name;
    std::uint32_t node = nothing, type = 0;        ///< 0 ambient, 1 directional, 2 point, 3 spot
    dvec3 position{0, 0, 0}, direction{0, 0, -1};  ///< in the node's space
    vec3 ambient{0, 0, 0}, diffuse{0, 0, 0}, specular{0, 0, 0};
    float constant = 1, linear = 0, quadratic = 0, cone_rad = 0;  ///< full angle of the cone
};

struct View {
    std::string name;
    std::uint32_t node = nothing;
    dvec3 position{0, 0, 0}, direction{0, 0, -1}, up{0, 1, 0};
    double horizontal_fov_rad = 0, aspect = 0, z_near = 0, z_far = 0,
           half_width = 0;  ///< aspect 0: unknown; half_width > 0: parallel
};

struct Joint {
    std::uint32_t node = nothing;
    dmat4 inverse_bind;
};

/// path: 0 translation, 1 rotation (xyzw), 2 scale; interpolation is linear. Times in seconds.
struct Track {
    std::uint32_t node = nothing, path = 0;
    std::vector<float> times, values;
};

struct Motion {
    std::string name;
    std::vector<Track> tracks;
};

/// What the helper changed or left out, in words. kind: 0 changed, 1 dropped, 2 warning, 3 note.
struct Note {
    std::uint32_t kind = 2;
    std::string place, message;
};

struct Influence {
    std::array<std::uint16_t, 8> joints{};  ///< into Document::joints
    std::array<float, 8> weights{};         ///< falling
};

struct Shape {
    std::string name;
    std::vector<vec3> positions, normals;  ///< offsets [V]; normals may be empty
};

struct Part {
    std::string name;
    std::uint32_t topology = 0;  ///< 0 triangles, 1 lines, 2 points
    std::uint32_t surface = nothing;
    std::vector<vec3> positions;               ///< [V]
    std::vector<std::uint32_t> indices;        ///< [3T], [2L] or [P]
    std::vector<vec3> normals;                 ///< [V] or empty
    std::vector<vec4> tangents;                ///< [V] or empty
    std::vector<std::uint32_t> smoothing;      ///< [T] masks of groups, or empty
    std::vector<vec3> smoothing_hint;          ///< [3T] or empty
    std::vector<std::uint32_t> polygons;       ///< [T] or empty: as Mesh::polygons
    std::vector<std::vector<vec2>> texcoords;  ///< v up
    std::vector<vec4> colors;                  ///< display values
    std::vector<Influence> influences;
    std::vector<Shape> shapes;
};

struct Document {
    AxisSystem axes;
    std::vector<Picture> pictures;
    std::vector<Surface> surfaces;
    std::vector<Place> places;  ///< parents first
    std::vector<Lamp> lamps;
    std::vector<View> views;
    std::vector<Joint> joints;
    std::vector<Motion> motions;
    std::vector<Note> notes;
    std::uint32_t part_count = 0;  ///< parts follow the document one by one
};

template <class Io>
void transfer(Io& io, Picture& p) {
    io.text(p.name);
    io.text(p.hint);
    io.value(p.width);
    io.value(p.height);
    io.array(p.bytes);
}
template <class Io>
void transfer(Io& io, TextureLink& t) {
    io.text(t.path);
    io.value(t.picture);
    io.value(t.role);
    io.value(t.uv_set);
    io.value(t.wrap_u);
    io.value(t.wrap_v);
    io.value(t.placement);
    io.value(t.offset);
    io.value(t.scale);
    io.value(t.rotation_rad);
}
template <class Io>
void transfer(Io& io, Surface& s) {
    io.text(s.name);
    io.value(s.has);
    io.value(s.two_sided);
    io.value(s.unlit);
    io.value(s.diffuse);
    io.value(s.specular);
    io.value(s.ambient);
    io.value(s.emission);
    io.value(s.shininess);
    io.value(s.opacity);
    io.value(s.bump_scale);
    io.records(s.links);
}
template <class Io>
void transfer(Io& io, Place& p) {
    io.text(p.name);
    io.value(p.parent);
    io.value(p.animated);
    io.value(p.matrix);
    io.value(p.translation);
    io.value(p.scale);
    io.value(p.rotation);
    io.array(p.meshes);
}
template <class Io>
void transfer(Io& io, Lamp& l) {
    io.text(l.name);
    io.value(l.node);
    io.value(l.type);
    io.value(l.position);
    io.value(l.direction);
    io.value(l.ambient);
    io.value(l.diffuse);
    io.value(l.specular);
    io.value(l.constant);
    io.value(l.linear);
    io.value(l.quadratic);
    io.value(l.cone_rad);
}
template <class Io>
void transfer(Io& io, View& v) {
    io.text(v.name);
    io.value(v.node);
    io.value(v.position);
    io.value(v.direction);
    io.value(v.up);
    io.value(v.horizontal_fov_rad);
    io.value(v.aspect);
    io.value(v.z_near);
    io.value(v.z_far);
    io.value(v.half_width);
}
template <class Io>
void transfer(Io& io, Joint& j) {
    io.value(j.node);
    io.value(j.inverse_bind);
}
template <class Io>
void transfer(Io& io, Track& t) {
    io.value(t.node);
    io.value(t.path);
    io.array(t.times);
    io.array(t.values);
}
template <class Io>
void transfer(Io& io, Motion& m) {
    io.text(m.name);
    io.records(m.tracks);
}
template <class Io>
void transfer(Io& io, Note& n) {
    io.value(n.kind);
    io.text(n.place);
    io.text(n.message);
}
template <class Io>
void transfer(Io& io, Shape& s) {
    io.text(s.name);
    io.array(s.positions);
    io.array(s.normals);
}
template <class Io>
void transfer(Io& io, Part& p) {
    io.text(p.name);
    io.value(p.topology);
    io.value(p.surface);
    io.array(p.positions);
    io.array(p.indices);
    io.array(p.normals);
    io.array(p.tangents);
    io.array(p.smoothing);
    io.array(p.smoothing_hint);
    io.array(p.polygons);
    io.arrays(p.texcoords);
    io.array(p.colors);
    io.array(p.influences);
    io.records(p.shapes);
}
template <class Io>
void transfer(Io& io, Document& d) {
    io.value(d.axes);
    io.records(d.pictures);
    io.records(d.surfaces);
    io.records(d.places);
    io.records(d.lamps);
    io.records(d.views);
    io.records(d.joints);
    io.records(d.motions);
    io.records(d.notes);
    io.value(d.part_count);
}

}  // namespace rakelight::io::import_stream
