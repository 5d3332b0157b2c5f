// SPDX-License-Identifier: Apache-2.0
// Keys of preparation: normals, tangents, texture coordinates, subdivision, displacement.
#include "world/keys/key_fields.h"

namespace rakelight::keys {
namespace {

constexpr Word<NormalSource> normal_words[] = {{"auto", NormalSource::automatic}, {"file", NormalSource::file},
                                               {"flat", NormalSource::flat},      {"object", NormalSource::object},
                                               {"model", NormalSource::model},    {"seams", NormalSource::seams}};
constexpr Word<UvProjection> uv_words[] = {{"none", UvProjection::none},
                                           {"box", UvProjection::box},
                                           {"sphere", UvProjection::sphere},
                                           {"cylinder", UvProjection::cylinder}};
constexpr Word<std::optional<TangentMode>> tangent_words[] = {
    {"auto", std::nullopt},
    {"averaged", TangentMode::averaged},
    {"published", TangentMode::published},
    {"published-no-handedness", TangentMode::published_no_handedness},
    {"mikktspace", TangentMode::mikktspace}};

constexpr Word<bool> bitangent_words[] = {{"cross", false}, {"attribute", true}};

/// Where tangents are orthogonalized: per attribute, per pixel, nowhere.
struct Orthogonal {
    Orthogonalize once;
    bool at_pixels;
    bool operator==(const Orthogonal&) const = default;
};
constexpr Word<Orthogonal> orthogonalize_words[] = {{"attribute", {Orthogonalize::attribute, true}},
                                                    {"shader", {Orthogonalize::off, true}},
                                                    {"off", {Orthogonalize::off, false}}};

void read_orthogonalize(PictureRequest& r, Words w) {
    const Orthogonal how = values::word("orthogonalize", w[0], orthogonalize_words);
    r.prepare.orthogonalize = how.once;
    r.settings.orthogonalize = how.at_pixels;
    r.prepare.measure_orthogonality = true;  // a chosen mode is reported with its error
}

Written write_orthogonalize(const PictureRequest& r) {
    if (!r.prepare.measure_orthogonality) return {};
    return name_in(orthogonalize_words, {r.prepare.orthogonalize, r.settings.orthogonalize});
}

void read_crease(PictureRequest& r, Words w) {
    const double angle = values::number("crease-angle", w[0]);
    if (!(angle >= 0 && angle <= 180)) throw values::wrong("crease-angle", "must be 0 to 180 degrees");
    r.prepare.crease_angle_rad = angle == 180 ? pi : radians(angle);
    r.prepare.creases = Creasing::angle;  // `crease`, which is read later, may override it
}

/// Not what `crease-angle` says already, by being written or left out.
Written write_creases(const PictureRequest& r) {
    const bool has_angle = r.prepare.crease_angle_rad != PictureRequest{}.prepare.crease_angle_rad;
    if (r.prepare.creases == (has_angle ? Creasing::angle : Creasing::automatic)) return {};
    return name_in(creasing_words, r.prepare.creases);
}

double distance(const char* name, const std::string& text) {
    const double meters = values::number(name, text);
    if (!(meters >= 0)) throw values::wrong(name, "must be 0 or more");
    return meters;
}

void read_subdivide_edge(PictureRequest& r, Words w) {
    r.prepare.subdivision.edge = values::number("subdivide-edge", w[0], 1e-6, 1e6);
    r.prepare.subdivision.level = 8;  // `subdivide`, which is read later, may override it
}

void read_subdivide_crease(PictureRequest& r, Words w) {
    Subdivision& s = r.prepare.subdivision;
    s.finds_creases = w[0] == "auto", s.crease_angle_rad = {};
    if (!s.finds_creases) s.crease_angle_rad = radians(values::number("subdivide-crease", w[0], 0, 180));
}

Written write_subdivide_crease(const PictureRequest& r) {
    const Subdivision& s = r.prepare.subdivision;
    if (s.finds_creases) return {"auto"};
    if (s.crease_angle_rad) return {degrees_of(*s.crease_angle_rad)};
    return {};
}

Written write_subdivide(const PictureRequest& r) {
    const Subdivision& s = r.prepare.subdivision;
    if (s.level == (s.edge > 0 ? 8 : 0)) return {};
    return {std::to_string(s.level)};
}

constexpr RenderKey table_of_normal[] = {
    RL_WORD_KEY("normals", r.prepare.normals, normal_words),
    {"crease-angle", Kind::value, read_crease,
     RL_WRITE(r.prepare.crease_angle_rad, {degrees_of(r.prepare.crease_angle_rad)})},
    {"crease", Kind::value,
     [](PictureRequest& r, Words w) { r.prepare.creases = values::word("crease", w[0], creasing_words); },
     write_creases},
    RL_WORD_KEY("weight", r.prepare.weight, corner_weight_words),
    RL_KEY("weld-distance", value, r.prepare.weld_distance, distance("weld-distance", w[0]),
           {text_of(r.prepare.weld_distance)}),
    RL_KEY("border-distance", value, r.prepare.border_distance, distance("border-distance", w[0]),
           {text_of(r.prepare.border_distance)}),
    RL_WORD_KEY("tangents", r.prepare.tangents, tangent_words),
    RL_WORD_KEY("bitangents", r.prepare.bitangents, bitangent_words),
    {"orthogonalize", Kind::value, read_orthogonalize, write_orthogonalize},
    RL_KEY("tessellate", flag, r.prepare.tessellate, w[0] == "on", {"on"}),
    RL_KEY("keep-instances", flag, r.prepare.keep_instances, w[0] == "on", {"on"}),
    RL_WORD_KEY("uv", r.prepare.uv, uv_words),
    RL_NUMBER_KEY("displacement-edge", r.prepare.displacement.edge, 1e-6, 1e6),
    RL_KEY("displacement-triangles", value, r.prepare.displacement.max_triangles,
           std::uint64_t(values::integer("displacement-triangles", w[0], 1, 100'000'000)),
           {std::to_string(r.prepare.displacement.max_triangles)}),
    {"subdivide-edge", Kind::value, read_subdivide_edge,
     RL_WRITE(r.prepare.subdivision.edge, {text_of(r.prepare.subdivision.edge)})},
    {"subdivide", Kind::value,
     [](PictureRequest& r, Words w) { r.prepare.subdivision.level = values::integer("subdivide", w[0], 0, 8); },
     write_subdivide},
    RL_WORD_KEY("subdivide-scheme", r.prepare.subdivision.scheme, subdivision_scheme_words),
    {"subdivide-crease", Kind::value, read_subdivide_crease, write_subdivide_crease},
    RL_NUMBER_KEY("subdivide-sharpness", r.prepare.subdivision.sharpness, 0, 10),
    RL_WORD_KEY("subdivide-boundary", r.prepare.subdivision.round_corners, subdivision_boundary_words),
    RL_WORD_KEY("subdivide-uv", r.prepare.subdivision.uv, subdivision_uv_words),
};

}  // namespace

constinit const KeyTable normal_keys = table_of_normal;

}  // namespace rakelight::keys
