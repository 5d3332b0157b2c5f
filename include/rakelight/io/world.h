// SPDX-License-Identifier: Apache-2.0
// World files (*.scene.toml): scenes composed of models, primitives, lights and cameras. The types of this header hold
// the parsed and checked content of a file, before its models are loaded. Format: docs/world-files.md.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/base/report.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// A place in a file. Lines and columns count from 1; 0: unknown.
struct WorldPlace {
    int line = 0, column = 0;  ///< of the first character
    bool operator==(const WorldPlace&) const = default;
};
/// "line 3, column 7"
RL_API std::string to_text(WorldPlace place);

/// A key with its value. The value is stored as words ("1.5", "on", "red"), and also as numbers if all words are
/// numeric.
struct WorldValue {
    std::string key{};                 ///< as written
    std::vector<std::string> words{};  ///< one word, or the elements of an array
    std::vector<double> numbers{};     ///< [words], or empty if a word is not numeric
    bool is_array = false;             ///< true: the value is written in brackets
    WorldPlace place{};                ///< place of the value; in [render]: place of the key
    bool operator==(const WorldValue&) const = default;
};

/// A placement: scale along the axes, then rotation about x, then about y, then about z, then translation.
struct WorldPlacement {
    dvec3 position{0, 0, 0}, rotation_deg{0, 0, 0}, scale{1, 1, 1};  ///< position in [m], rotation in [degrees]
};

/// A model file in the world.
struct WorldModel {
    std::string name{};  ///< name of the model's node; default: the name of the file without its ending
    std::string file{};  ///< as written: relative to the folder of the world file, or "builtin:teapot"
    WorldPlacement placement{};
    std::string material{};  ///< name of a material of the world for the whole model; empty: the model's own materials
    std::string normals{};   ///< "auto", "file", "flat", "object", "model"; empty: PrepareOptions::normals
    std::optional<double> crease_angle_rad{};  ///< 0..pi; absent: PrepareOptions::crease_angle_rad
    std::optional<Subdivision> subdivision{};  ///< absent: PrepareOptions::subdivision
    bool lights = false, cameras = false;      ///< whether the world includes the lights and cameras of the model
    std::optional<Shading> shading{};
    WorldPlace place{}, material_place{};  ///< `place`: of the key "file". `material_place`: of the key "material"
};

/// A built-in shape.
struct WorldPrimitive {
    std::string name{}, type{};  ///< `type`: "teapot", "sphere", "cylinder", "cone", "torus" or "plane"
    WorldPlacement placement{};
    double radius = 1, tube_radius = 0.35, height = 2;  ///< [m] tube_radius: of the torus
    double width = 2, depth = 2;                        ///< [m] of the plane
    int divisions = 1;                                  ///< quads per side of the plane or of the teapot's patches
    int objects = 1;                                    ///< number of objects into which the shape is cut
    /// [m] largest distance between facets and the exact surface. 0: 1/1000 of the largest radius; for the teapot
    /// `divisions` applies instead.
    double tolerance = 0;
    std::string material{};                    ///< name of a material of the world; empty: the default material
    std::string normals{};                     ///< as WorldModel::normals
    std::optional<double> crease_angle_rad{};  ///< 0..pi; absent: PrepareOptions::crease_angle_rad
    std::optional<Subdivision> subdivision{};  ///< absent: PrepareOptions::subdivision
    std::optional<Shading> shading{};
    WorldPlace place{}, material_place{}, objects_place{};
};

/// Changes to materials, or a new material of the world.
struct WorldMaterial {
    std::string name{};   ///< name of the material; "*": all materials of `model`
    std::string model{};  ///< only materials of this model are changed; empty: of all models
    /// Name or node index of an object of the model. Only the materials of this object are changed. Such changes are
    /// made after changes for all objects. Empty: all objects.
    std::string object{};
    std::vector<WorldValue> values{};
    WorldPlace place{};
};

/// The environment of a world file.
struct WorldEnvironment {
    std::string file{};         ///< as written; empty: the built-in studio
    Environment environment{};  ///< without its picture
    WorldPlace place{};
};

/// Keyframes of a property of a camera or light of the world.
struct WorldTrack {
    /// Interpolation between keys.
    enum class Between : std::uint8_t { linear, step, smooth };  ///< smooth: a cubic spline through the keys
    AnimationPath path = AnimationPath::camera;                  ///< AnimationPath::camera or AnimationPath::light
    std::uint32_t element = 0;  ///< into WorldFile::cameras or WorldFile::lights; if out of range, the track is ignored
    std::string property{};     ///< a name of animated_properties() (motion.h); `values` have the units of the property
    Between between = Between::linear;
    std::vector<float> times{};   ///< [K] [s] strictly increasing
    std::vector<float> values{};  ///< [K * width]
    bool operator==(const WorldTrack&) const = default;
};

/// A remark on an accepted world file.
struct WorldRemark {
    Remark kind = Remark::note;
    WorldPlace place{};
    std::string message{};  ///< for people
};

/// The content of a world file, in the order of the file. Numbers are finite and in range. Referenced files are not
/// checked.
struct WorldFile {
    std::vector<WorldModel> models{};
    std::vector<WorldPrimitive> primitives{};
    std::vector<Light> lights{};
    std::vector<Camera> cameras{};
    std::vector<WorldTrack>
        tracks{};  ///< keyframes of lights and cameras: the clip `world_clip_name` (motion.h) of the scene
    std::vector<WorldMaterial> materials{};
    std::optional<Fog> fog{};
    std::optional<WorldEnvironment> environment{};
    std::vector<WorldValue> render{};    ///< settings of the picture, see render_keys()
    std::vector<WorldRemark> remarks{};  ///< load() adds them to the report
};

/// Whether a file name is that of a world file: "*.scene.toml", ignoring case.
RL_API bool is_world_file(std::string_view path);

/// Parses and checks the text of a world file.
/// @param text the whole file in UTF-8, at most 4 MiB and 10 000 entries of a kind
/// @throws Error bad_file, with line and column; for unknown keys with the nearest known key. Keys of [render] are
///         checked by read_world_request()
RL_API WorldFile parse_world(std::string_view text);

/// Reads a world file and parses it.
/// @throws Error not_found; and as parse_world(), with the file's name
RL_API WorldFile read_world(const std::string& path, Context& context);

/// The text of a world file, without comments. parse_world() reads it as the same world; cameras may differ by the
/// rounding of one look_at(). File names are written unchanged, so they are relative to the folder of the new file.
/// @throws Error usage: not representable in a world file, such as lights on a node, an environment picture without a
///         file, unknown or invalid settings; bad_file: what parse_world() refuses
RL_API std::string to_toml(const WorldFile& world);
/// Writes a world file. The file appears complete or not at all.
/// @throws Error as to_toml(); usage: another ending; failed: cannot be written
RL_API void save_world(const WorldFile& world, const std::string& path);

/// The path of a file that a world file names.
/// @param path  of the world file
/// @param name  of the other file, as written in the world file
/// @throws Error bad_file: the other file is outside of the folder of the world file, and `allow_outside` is false
RL_API std::string resolve_in_world(const std::string& path, const std::string& name, bool allow_outside);

/// The JSON schema of world files (draft 2020-12), for editors that check TOML: data/world.schema.json.
RL_API std::string world_schema();

}  // namespace rakelight
