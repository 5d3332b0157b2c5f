// SPDX-License-Identifier: Apache-2.0
#include "io/world/world_keys.h"

#include <algorithm>

#include <rakelight/scene/light_limits.h>

#include "base/assert.h"
#include "io/world/material_keys.h"
#include "io/world/motion_keys.h"

namespace rakelight::io::world {
namespace {

constexpr Range degrees_180{0, 180, true}, cone_deg{min_cone_deg, 90};

const std::vector<const char*> normal_words = {"auto", "file", "flat", "object", "model", "seams"};

std::vector<WorldKey> placed(std::vector<WorldKey> keys) {
    keys.push_back({"position", Kind::vector, "Position of its origin [m]"});
    keys.push_back({"rotation_deg", Kind::vector, "Rotation about x, then y, then z"});
    keys.push_back({"scale", Kind::scale, "Scale: a number, or one for each of x, y, z; not 0", {-1e9, 1e9}});
    keys.push_back({"material", Kind::text, "Name of a [[material]] that applies to all of it"});
    keys.push_back({"normals", Kind::word,
                    "Which normals are used, as normals of [render]; model: smooth across all parts of the world that "
                    "have this setting",
                    any_number, normal_words});
    keys.push_back({"crease_angle_deg",
                    Kind::number,
                    "Edges with a larger angle stay sharp, as crease-angle of [render]",
                    {0, 180}});
    keys.push_back({"shading", Kind::word, "How often its lighting is evaluated; overrides shading of [render]",
                    any_number, names_of<Shading>(shading_words)});
    keys.push_back({"subdivide", Kind::integer, "Levels of subdivision, as subdivide of [render]", {0, 8}});
    keys.push_back({"subdivide_edge", Kind::number, "As subdivide-edge of [render], in m", {1e-6, 1e6}});
    keys.push_back({"subdivide_scheme", Kind::word, "As subdivide-scheme of [render]", any_number,
                    names_of<SubdivisionScheme>(subdivision_scheme_words)});
    keys.push_back({"subdivide_crease", Kind::word, "auto: creases where the rule of hard edges finds them", any_number,
                    names_of<bool>(subdivision_crease_words)});
    keys.push_back({"subdivide_crease_deg", Kind::number, "As subdivide-crease of [render]", {0, 180}});
    keys.push_back({"subdivide_sharpness", Kind::number, "As subdivide-sharpness of [render]", {0, 10}});
    keys.push_back({"subdivide_boundary", Kind::word, "As subdivide-boundary of [render]", any_number,
                    names_of<bool>(subdivision_boundary_words)});
    keys.push_back({"subdivide_uv", Kind::word, "As subdivide-uv of [render]", any_number,
                    names_of<SubdivisionUv>(subdivision_uv_words)});
    return keys;
}

std::vector<WorldKey> model_keys() {
    return placed({
        {"file",
         Kind::file,
         "Model file, from this file's folder, or builtin:teapot, builtin:sphere:tolerance=0.01, ...",
         any_number,
         {},
         true},
        {"name", Kind::text, "Its name for [[material]] and shading of [render] (default: the file's name)"},
        {"lights", Kind::flag, "Whether its own lights are used too (default: no)"},
        {"cameras", Kind::flag, "Whether its own cameras are added after those of this file (default: no)"},
    });
}

std::vector<WorldKey> primitive_keys() {
    return placed({
        {"type", Kind::word, "The shape", any_number, {"teapot", "sphere", "cylinder", "cone", "torus", "plane"}, true},
        {"name", Kind::text, "Its name for [[material]] and shading of [render] (default: the type)"},
        {"radius", Kind::number, "Radius of sphere, cylinder, cone and torus [m] (default 1)", {1e-6, 1e6}},
        {"tube_radius", Kind::number, "Tube radius of the torus [m] (default 0.35)", {1e-6, 1e6}},
        {"height", Kind::number, "Height of cylinder and cone [m] (default 2)", {1e-6, 1e6}},
        {"size", Kind::pair, "Size of the plane along x and z [m] (default 2, 2)", {1e-6, 1e6}},
        {"divisions",
         Kind::integer,
         "Quads along a side of the plane (default 1) or of a patch of the teapot (10)",
         {1, 256}},
        {"objects", Kind::integer, "Number of objects that it is divided into (default 1)", {1, 1024}},
        {"tolerance",
         Kind::number,
         "Largest distance of a facet from the true surface [m] (default: 1/1000 of the largest radius; teapot: 10 "
         "divisions)",
         {1e-9, 1e6}},
    });
}

/// What a section that moves has beside its own keys.
std::vector<WorldKey> moving(std::vector<WorldKey> keys, std::vector<WorldKey> parts) {
    parts.insert(parts.begin(), {"time", Kind::number, "When [s]", {-1e6, 1e6}, {}, true});
    keys.push_back({.name = "keys",
                    .kind = Kind::tables,
                    .help = "Keyframes, shown by animation-time and sequences",
                    .parts = std::move(parts)});
    keys.push_back({"interpolation",
                    Kind::word,
                    "Interpolation between keys; smooth: by cubic splines (default linear)",
                    any_number,
                    {"linear", "step", "smooth"}});
    return keys;
}

/// Those of the keys that may move.
std::vector<WorldKey> parts_of(const std::vector<WorldKey>& keys, std::span<const MovingKey> moving) {
    std::vector<WorldKey> parts;
    for (const WorldKey& key : keys)
        if (std::ranges::any_of(moving, [&](const MovingKey& m) { return std::string_view(m.key) == key.name; })) {
            parts.push_back(key);
            parts.back().is_required = false;
        }
    return parts;
}

std::vector<WorldKey> camera_keys() {
    return {
        {"name", Kind::text, "Its name for camera-index of [render]"},
        {"position", Kind::vector, "Its position [m]", any_number, {}, true},
        {"target", Kind::vector, "Point that it looks at [m] (default 0, 0, 0)"},
        {"up", Kind::vector, "Up direction (default 0, 1, 0)"},
        {"vertical_fov_deg", Kind::number, "Vertical field of view (default 40, or by the horizontal one)",
         degrees_180},
        {"horizontal_fov_deg", Kind::number,
         "Horizontal field of view; alone: the vertical one follows from square pixels; both: pixels need not be "
         "square",
         degrees_180},
        {"orthographic_height", Kind::number, "Parallel projection; visible height [m]", above_0},
        {"near", Kind::number,
         "Distance of the near plane [m] (default: in front of what is nearest; beside far, 0.1)"},
        {"far", Kind::number, "Distance of the far plane [m] (default: behind the scene; beside near, 1000)", above_0},
    };
}

std::vector<WorldSection> make_sections() {
    return {
        {"model", true, "A model file", model_keys()},
        {"primitive", true, "A shape made by formula, about its origin, y up", primitive_keys()},
        {"light", true, "A light; without any, the default lights are used",
         moving(light_keys(), parts_of(light_keys(), moving_light_keys()))},
        {"camera", true, "A camera; the first is the default",
         moving(camera_keys(), parts_of(camera_keys(), moving_camera_keys()))},
        {"material", true,
         "Changes the models' materials of this name, or defines a material for models and primitives",
         material_keys()},
        {"fog",
         false,
         "Fog between the camera and what it sees",
         {{"kind", Kind::word, "How it increases with distance", any_number, {"none", "linear", "exp", "exp2"}, true},
          {"color", Kind::color, "Its color (default 0.5, 0.5, 0.5)"},
          {"start", Kind::number, "linear: distance at which it starts [m] (default 0)", from_0},
          {"end", Kind::number, "linear: distance at which it hides everything [m] (default 100)", above_0},
          {"density", Kind::number, "exp, exp2: density [1/m] (default 0.05)", {0, 1e6}}}},
        {"environment",
         false,
         "The environment",
         {{"file", Kind::file, "Equirectangular picture (default: a built-in studio)"},
          {"intensity", Kind::number, "Factor on its light (default 1)", {0, 1e6}},
          {"rotation_deg", Kind::number, "Rotation about its up axis (default 0)", {-360, 360}},
          {"up", Kind::vector, "Direction of its upper edge (default [0, 1, 0])"},
          {"light", Kind::flag, "Whether it lights the scene (default: yes)"},
          {"background", Kind::flag, "Whether it is shown as background (default: yes)"}}},
    };
}

}  // namespace

std::vector<WorldKey> light_keys() {
    return {
        {"type",
         Kind::word,
         "The kind of light; photometric ones as KHR_lights_punctual",
         any_number,
         {"ambient", "directional", "point", "spot", "photometric-directional", "photometric-point",
          "photometric-spot"},
         true},
        {"name", Kind::text, "For people"},
        {"position", Kind::vector, "point, spot: its position [m]"},
        {"direction", Kind::vector, "directional, spot: direction in which the light travels"},
        {"ambient", Kind::color, "classical: its ambient color (default 0)"},
        {"diffuse", Kind::color, "classical: its diffuse color (default 1)"},
        {"specular", Kind::color, "classical: its specular color (default: as diffuse)"},
        {"attenuation", Kind::vector, "classical point, spot: 1 / (c + l d + q d^2) (default 1, 0, 0)", from_0},
        {"cutoff_deg", Kind::number, "classical spot: half angle of its cone (default 90)", cone_deg},
        {"exponent", Kind::number, "classical spot: falloff cos^exponent from its axis (default 0)", {0, 1e9}},
        {"color", Kind::color, "photometric: its color (default 1)"},
        {"intensity_cd", Kind::number, "photometric point, spot: intensity in candela (default 1)", from_0},
        {"intensity_lux", Kind::number, "photometric directional: illuminance in lux (default 1)", from_0},
        {"inner_cone_deg", Kind::number, "photometric spot: half angle of full light (default 0)", {0, 90}},
        {"outer_cone_deg", Kind::number, "photometric spot: half angle of its cone (default 45)", cone_deg},
        {"range", Kind::number, "point, spot: where the light ends [m] (default: nowhere)", {min_light_range, 1e30}},
        {"casts_shadow", Kind::flag, "Whether it casts shadows if [render] has shadows (default: yes)"},
    };
}

const std::vector<WorldSection>& sections() {
    static const std::vector<WorldSection> all = make_sections();
    return all;
}

const WorldSection& section(std::string_view name) {
    const auto found =
        std::find_if(sections().begin(), sections().end(), [&](const WorldSection& s) { return s.name == name; });
    RL_ASSERT(found != sections().end(), "there is no such section");
    return *found;
}

}  // namespace rakelight::io::world
