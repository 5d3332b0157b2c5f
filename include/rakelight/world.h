// SPDX-License-Identifier: Apache-2.0
// World files (*.scene.toml): a scene put together from models, primitives, lights and cameras. Here is what such a
// file says, read and checked, before any model of it is loaded. docs/world-files.md explains the format.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/report.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Where something stands in a file, from 1; 0: nowhere.
struct WorldPlace {
    int line = 0, column = 0;  ///< of its first character
    bool operator==(const WorldPlace&) const = default;
};
/// "line 3, column 7"
RL_API std::string to_text(WorldPlace place);

/// A key with its value: words as people write them ("1.5", "on", "red"), and numbers where they are such.
struct WorldValue {
    std::string key{};                 ///< as it is written
    std::vector<std::string> words{};  ///< one, or as many as the array has elements
    std::vector<double> numbers{};     ///< as many as `words`, or empty: some are no numbers
    bool is_array = false;             ///< written in brackets
    WorldPlace place{};                ///< of the value; in [render] of the key
    bool operator==(const WorldValue&) const = default;
};

/// Translation * rotation about x, then y, then z * scale.
struct WorldPlacement {
    dvec3 position{0, 0, 0}, rotation_deg{0, 0, 0}, scale{1, 1, 1};  ///< [m]; [degrees]; along the axes
};

/// A model file in the world.
struct WorldModel {
    std::string name{};  ///< of the node that carries it; the file's name without ending by default
    std::string file{};  ///< as written: from the world file's folder, or "builtin:teapot"
    WorldPlacement placement{};
    std::string material{};  ///< of the world, for all of it; empty: its own
    std::string normals{};   ///< "auto", "file", "flat", "object", "model"; empty: as the picture's options say
    std::optional<double> crease_angle_rad{};  ///< 0..pi; absent: as the picture's options say
    std::optional<Subdivision> subdivision{};  ///< absent: as the picture's options say
    bool lights = false, cameras = false;      ///< whether the model's own come along
    std::optional<Shading> shading{};
    WorldPlace place{}, material_place{};  ///< of `file`, `material`
};

/// A shape that is made by formula.
struct WorldPrimitive {
    std::string name{}, type{};  ///< "teapot", "sphere", "cylinder", "cone", "torus", "plane"
    WorldPlacement placement{};
    double radius = 1, tube_radius = 0.35, height = 2;  ///< [m] tube: of the torus
    double width = 2, depth = 2;                        ///< [m] of the plane
    int divisions = 1;                                  ///< quads along a side of the plane or of the teapot's patches
    int objects = 1;                                    ///< it is cut into so many
    double tolerance = 0;    ///< [m] farthest that a facet is from the surface; 0: a thousandth of the largest radius,
                             ///< teapot: `divisions`
    std::string material{};  ///< of the world; empty: the default material
    std::string normals{};   ///< as WorldModel::normals
    std::optional<double> crease_angle_rad{};  ///< 0..pi; absent: as the picture's options say
    std::optional<Subdivision> subdivision{};  ///< absent: as the picture's options say
    std::optional<Shading> shading{};
    WorldPlace place{}, material_place{}, objects_place{};
};

/// Changes to materials, or a material of the world's own.
struct WorldMaterial {
    std::string name{};   ///< of the material; "*": all of `model`
    std::string model{};  ///< changes this model's materials only; empty: those of all models
    /// Name of an object of the model, or the number of its node there: changes its materials alone, after those of all objects
    /// were changed. Empty: of all objects.
    std::string object{};
    std::vector<WorldValue> values{};
    WorldPlace place{};
};

/// Light from all around, as a world file has it.
struct WorldEnvironment {
    std::string file{};         ///< as written; empty: the built-in studio
    Environment environment{};  ///< without its picture
    WorldPlace place{};
};

/// A place, number or color of a camera or light of the world that `keys` move.
struct WorldTrack {
    /// Between two keys.
    enum class Between : std::uint8_t { linear, step, smooth };  ///< keys; smooth: a cubic spline through them
    AnimationPath path = AnimationPath::camera;                  ///< or light
    std::uint32_t element = 0;  ///< into WorldFile::cameras or lights; a track of one that is not there is left out
    std::string property{};     ///< of animated_properties() (motion.h), in its units
    Between between = Between::linear;
    std::vector<float> times{};   ///< [K] seconds, each later than the one before
    std::vector<float> values{};  ///< [K * width]
    bool operator==(const WorldTrack&) const = default;
};

/// What is to be told of a world file that is not refused.
struct WorldRemark {
    Remark kind = Remark::note;
    WorldPlace place{};
    std::string message{};  ///< for people
};

/// What a world file says, in its order. Numbers are finite and in range; files are not looked at.
struct WorldFile {
    std::vector<WorldModel> models{};
    std::vector<WorldPrimitive> primitives{};
    std::vector<Light> lights{};
    std::vector<Camera> cameras{};
    std::vector<WorldTrack>
        tracks{};  ///< what moves of lights and cameras: the clip `world_clip_name` (motion.h) of the scene
    std::vector<WorldMaterial> materials{};
    std::optional<Fog> fog{};
    std::optional<WorldEnvironment> environment{};
    std::vector<WorldValue> render{};    ///< settings of the picture: render_keys()
    std::vector<WorldRemark> remarks{};  ///< load() adds them to the report
};

/// Whether a file is named as a world: "*.scene.toml" in any case.
RL_API bool is_world_file(std::string_view path);

/// @param text  of the whole file, UTF-8. At most 10 000 entries of a kind, and 4 MiB.
/// @throws Error bad_file: what is wrong, with line and column; unknown keys with the nearest that there is, but for those of [render]:
///         read_world_request() looks at them
RL_API WorldFile parse_world(std::string_view text);

/// Reads and parses. @throws Error not_found; and as parse_world(), with the file's name
RL_API WorldFile read_world(const std::string& path, Context& context);

/// The text of a world file that parse_world() reads as this world (of cameras with the rounding of one look_at()), without comments.
/// Names of files are written as they are: from the folder of the world that is to be.
/// @throws Error usage: what no world file can have, such as lights on a node, an environment's picture without a file, unknown or wrong
///         settings; bad_file: what parse_world() refuses
RL_API std::string to_toml(const WorldFile& world);
/// Writes it; the file appears when it is whole. @throws Error as to_toml(); usage: another ending; failed: cannot be written
RL_API void save_world(const WorldFile& world, const std::string& path);

/// Where a file that a world names lies. @param path  of the world
/// @throws Error bad_file: it would leave the world's folder, unless `allow_outside`
RL_API std::string resolve_in_world(const std::string& path, const std::string& name, bool allow_outside);

/// What "KEY=VALUE" says of a material: keys of [[material]] with their checks, numbers of a list
/// separated by commas, flags on or off. Colors are linear or "#rrggbb".
/// @throws Error usage
RL_API std::vector<WorldValue> material_values(std::span<const std::string> words);

/// A shape as "sphere" or "sphere:tolerance=0.01:radius=2" says it: keys of [[primitive]] that make the shape, with
/// their checks.
/// @throws Error usage
RL_API WorldPrimitive shape_of_words(std::string_view words);

/// The JSON schema of world files (draft 2020-12), for editors that check TOML: data/world.schema.json.
RL_API std::string world_schema();

struct PictureRequest;

/// A key of [render] and what it sets.
struct RenderKey {
    /// How its value is written.
    enum class Kind : std::uint8_t {
        value,
        file,      ///< a file's name
        flag,      ///< true or false
        switched,  ///< a flag whose default may be on
        list,      ///< any number of values, in their order
    };
    const char* name;  ///< "crease-angle"
    Kind kind{};
    /// @param words  one, or of a list as many as there are, at least one; flags: "on", "off". @throws Error usage about the key
    void (*read)(PictureRequest& to, std::span<const std::string> words);
    /// Words that read() makes the field of again; empty: it is as by default.
    std::vector<std::string> (*write)(const PictureRequest& of);
};

/// All, in the order in which they are read.
RL_API std::span<const RenderKey> render_keys();
/// Null: there is none of that name.
RL_API const RenderKey* find_render_key(std::string_view name);
/// @throws Error usage with the nearest name: there is none
RL_API const RenderKey& require_render_key(const std::string& name);
/// Whether a key of [render] says where the camera stands, so that one takes the place of another: a side, a camera of the
/// file, a position, a direction.
RL_API bool places_camera(std::string_view key);

/// Whether the words of a value of [render] are names of files: those of a world count from its folder.
RL_API bool names_files(const WorldValue& value);

/// Sets what the values say, each key once, and checks what only several of them together can get wrong. Files are taken as
/// they are named. @throws Error usage about the key: an unknown one, a wrong value, or keys that exclude each other
RL_API void read_render_keys(std::span<const WorldValue> values, PictureRequest& to);

/// What read_render_keys() makes the same request of: the keys whose fields are not as by default. Colors come back as near as their
/// display values are (1e-6), directions of lights at length 1, their names not at all; files and LoadOptions are no keys.
/// @throws Error usage: the request asks for what no key says, such as no lights at all or one on a node
RL_API std::vector<WorldValue> written_render_keys(const PictureRequest& of);

}  // namespace rakelight
