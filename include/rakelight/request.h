// SPDX-License-Identifier: Apache-2.0
// What is asked of a picture: model, view, materials, lights, surroundings, settings, files. A plain value; the keys of [render] in
// world files read and write it (world.h).
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/colormap.h>
#include <rakelight/engine.h>
#include <rakelight/image.h>
#include <rakelight/load.h>
#include <rakelight/motion.h>
#include <rakelight/prepare.h>
#include <rakelight/world.h>

namespace rakelight {

/// Where the camera stands, as far as the caller wants to say. With nothing said the first camera of the file is used,
/// and where the file has none a camera fitted to the model's bounding box.
struct ViewRequest {
    std::string
        side{};  ///< "front", "back", "left", "right", "top", "bottom", "isometric", "default"; "file": its first camera; or empty
    std::string camera{};                ///< number (from 0) or name of a camera of the file, or empty
    std::optional<dvec3> position{};     ///< [m] world
    std::optional<dvec3> focal_point{};  ///< [m] world; what the camera looks at
    std::optional<dvec3> up{};           ///< any length; of the picture; default: the world's
    /// Any length; which way is up in the world, default +Y: sides, the environment and the picture's own up turn along. Where
    /// only `up` is given, fitted views turn along with that.
    std::optional<dvec3> world_up{};
    /// World, any length; along which a fitted view looks, in place of a side.
    std::optional<dvec3> direction{};
    /// Turns the eye about what it looks at after all else: to the right about the world's up, then upward.
    std::optional<double> azimuth_rad{}, elevation_rad{};
    std::optional<double>
        zoom_factor{};  ///< > 0; share of the picture's tighter side that the model takes; default 0.9
    std::optional<double> vertical_fov_rad{};  ///< 0..pi, both exclusive
    /// 0..pi, both exclusive. Alone: pixels stay square, the vertical one follows. With the vertical one: pixels are as wide as both say.
    std::optional<double> horizontal_fov_rad{};
    /// [m] more than 0, z_near < z_far: nothing nearer, nothing farther is drawn. Absent: the camera's own, or about the
    /// model where the camera is fitted or placed.
    std::optional<double> z_near{}, z_far{};
    bool orthographic = false;  ///< parallel projection that shows what the perspective one shows at the focal point

    bool is_placed() const {
        return position || focal_point || up || vertical_fov_rad || horizontal_fov_rad || orthographic || direction ||
               zoom_factor;
    }
    bool is_orbited() const { return azimuth_rad || elevation_rad; }
    bool operator==(const ViewRequest&) const = default;
};

/// Overrides applied to every material; texture pictures lie on the first texture coordinate set.
struct MaterialOverrides {
    std::string base_color{}, normal{}, height{};  ///< picture files, as the caller names them; empty: the model's own
    std::optional<double> normal_scale{};          ///< of all normal maps
    std::optional<bool> green_down{};              ///< Material::green_down
    std::optional<bool> centered_normals{};        ///< Material::centered_normals
    std::optional<vec3> color{};                   ///< linear; the factor that base color textures are multiplied by
    std::optional<double> opacity{};               ///< 0..1, the factor of alpha; below 1 surfaces are blended
    /// 0..1, factors of metallic-roughness materials; classical ones are converted to such first.
    std::optional<double> roughness{}, metallic{};
    /// Keys of [[material]] in world files, of material_values(); pictures as the caller names them. They act before
    /// all above but the pictures.
    std::vector<WorldValue> values{};

    bool operator==(const MaterialOverrides&) const = default;
};

/// The scene with its materials so changed; meshes without a material get one.
/// @throws Error not_found: a picture file that is not there, or a folder; bad_file: one that cannot be decoded
Scene override_materials(const Scene& scene, const MaterialOverrides& overrides, Context& context);

/// Colors by the numbers of one array of the vertices (Mesh::arrays), not lit.
struct Coloring {
    bool is_on = false;
    std::string array{};             ///< its name; empty: the first that there is
    std::optional<int> component{};  ///< from 0; absent: the length of all components
    std::optional<dvec2> range{};    ///< values at the ends of the colormap, x <= y; absent: the least and the greatest
    ColorMap map = ColorMap::viridis;
    bool has_bar = false;  ///< the colormap with numbers stands at the picture's right side
    bool operator==(const Coloring&) const = default;
};

/// The scene in these colors, which take the place of materials and vertex colors; what has no such numbers is gray.
/// @throws Error usage: no vertices have such numbers, or such a component; the message lists what there is
Scene color_by_array(Scene scene, const Coloring& coloring, Context& context);

/// Which clips of a scene are shown, and when. With nothing said nodes stand as the file has them.
struct MotionRequest {
    std::optional<int> index{};      ///< into Scene::animations; -1: all of them; absent: by `name`, else the first
    std::string name{};              ///< of a clip; empty: by `index`
    std::optional<double> time_s{};  ///< [s] absent: where the clip begins
    bool autoplay = false;           ///< the viewer plays from the start; a picture shows the clip
    bool asks() const { return index || !name.empty() || time_s || autoplay; }
    bool operator==(const MotionRequest&) const = default;
};

/// The clips of a scene that a request names, at their moments; and those that go with all
/// (Animation::goes_with_all), at the moment of the others. Empty: it asks for none.
/// @throws Error usage: the scene has no clips, or no such one; the message lists them
std::vector<ClipTime> clips_of(const Scene& scene, const MotionRequest& motion);

/// How data channels are written, as bits.
enum ChannelFiles : std::uint32_t {
    channel_files_exr = 1u << 0,  ///< a file each, NAME.depth.exr: 32-bit floats in Y, R G, R G B or R G B A; numbers
                                  ///< as floats (exact up to 2^24), -1 where nothing is
    channel_files_layers = 1u << 1,  ///< all in one: layers depth.Z, normal.X ... beside R, G, B of the .exr output,
                                     ///< else of NAME.channels.exr; numbers as UINT
    channel_files_png = 1u << 2,     ///< a picture for the eye each, NAME.depth.png
};

/// The Channel bits of "depth", "face-normal", ..., of "lighting", of "all" or of "none". @throws Error usage
std::uint32_t channels_by_name(std::string_view name);

/// What a picture is like in what nobody names: docs/default-look.md.
enum class Look : std::uint8_t {
    plain,    ///< what the members below say
    standard  ///< take_look() fills in what neither the file nor PictureRequest::named has a say in
};

/// Settings that go together: docs/shading.md.
enum class Preset : std::uint8_t {
    none,
    fixed_function  ///< what OpenGL 1.x could do without a program
};
/// Keys of [render] that a preset decides where nobody gives them; given beside it they go before it.
bool is_of_preset(std::string_view key);
/// Whether settings ask for a preset. Given from outside it takes the place of what a world says of its keys.
bool asks_for_preset(std::span<const WorldValue> settings);

/// What is drawn over the finished picture, beside the model: docs/overlays.md.
struct Overlays {
    bool grid = false;      ///< on the ground below the model
    bool axis = false;      ///< which way the world's axes point, in a corner
    bool filename = false;  ///< the model's name
    bool metadata = false;  ///< how much there is of the model
    bool any() const { return grid || axis || filename || metadata; }
    bool operator==(const Overlays&) const = default;
};

/// One picture to be made.
struct PictureRequest {
    std::string input{};   ///< model file, or builtin:teapot, sphere, cylinder, cone, torus, plane
    std::string output{};  ///< ending .png, .jpg, .webp, .ppm (sRGB, 8 bit), .exr or .hdr (linear)
    std::string engine = "soft";
    LoadOptions load{};
    MaterialOverrides materials{};
    Coloring coloring{};
    MotionRequest motion{};
    PrepareOptions prepare{};
    ViewRequest view{};
    std::optional<std::vector<Light>>
        lights{};  ///< replace all lights; else the file's, else, where no environment lights the scene, the default rig
    bool default_lights = false;  ///< the default rig although the file has lights; `lights` goes first
    bool studio_lights = false;   ///< the built-in studio and a key light in place of all lights; `lights` goes first
    Look look = Look::plain;
    /// Read as a key it sets what is_of_preset() lists; here it says which materials and lights there can be.
    Preset preset = Preset::none;
    std::vector<std::string>
        named{};                 ///< keys of [render] that somebody has given: look and preset leave their topics alone
    double light_intensity = 1;  ///< >= 0; multiplies every light
    /// [radiance of a white Lambert surface that faces the light] 0..1: point and spot lights without a range get one
    /// where less than this is left of them; no surface loses more of a light than this. 0: none does.
    double light_cutoff = 0;
    std::optional<Fog> fog{};  ///< in place of the scene's
    Overlays overlays{};
    ToneSettings tone{};      ///< of 8-bit pictures; EXR and HDR stay linear
    std::string hdri_file{};  ///< equirectangular picture, takes the place of the scene's environment; empty: none
    /// Whether the environment (without a file: the scene's, else the built-in studio) gives light, and whether it is
    /// the background; absent: as the scene says, else not.
    std::optional<bool> hdri_ambient{}, hdri_skybox{};
    std::optional<double> hdri_intensity{};     ///< >= 0; of the environment, in place of the scene's
    std::optional<double> hdri_rotation_rad{};  ///< about +Y, likewise
    RenderSettings
        settings{};  ///< channels go into files by `channel_files`; a window makes the picture as large as the
                     ///< window; alpha is written when background.w < 1
    std::uint32_t channel_files = channel_files_exr;  ///< ChannelFiles bits
    /// A picture that is cancelled is written with what is there, the rest in the background's color; false: nothing is.
    bool keep_partial = false;
    bool half_colors = false;  ///< colors in EXR files, those of channels too, as 16-bit halves; data stays at 32 bits
    /// Something is drawn over the finished picture.
    bool has_overlays() const { return overlays.any() || (coloring.is_on && coloring.has_bar); }
    bool operator==(const PictureRequest&) const = default;
};

/// Whether settings say how all of a picture is shaded. Given from outside they take the shading of materials and parts of a world away
/// (RenderSettings::own_shading).
bool shades_the_whole(std::span<const WorldValue> settings);

/// Settings that go before those of a world file.
struct RenderOverrides {
    /// Each takes the place of the file's of the same key; one that says where the camera stands that of all such.
    std::vector<WorldValue> values{};
    /// Whether a setting of the file is wanted; empty: all are. What it throws gets the place in the file.
    std::function<bool(std::string_view key)> takes{};
};

/// The picture that a world file asks for, and how it says so.
struct WorldRequest {
    PictureRequest picture{};         ///< LoadOptions::overridden names what others took the place of
    std::vector<WorldValue> taken{};  ///< of the file's [render], names of files resolved
};

/// What [render] of a world file says, files from the world's folder, behind `overrides`. Where to write the picture is the caller's.
/// @throws Error not_found, bad_file: with the file, line and column of what is wrong; usage: an override is wrong, or excludes
///         a setting of the file
WorldRequest read_world_request(const std::string& path, const LoadOptions& options, const RenderOverrides& overrides,
                                Context& context);
/// The same without overrides.
PictureRequest request_of_world(const std::string& path, const LoadOptions& options, Context& context);

/// An error about a setting that the file gave, with its place there; another as it is.
Error at_world_value(const Error& error, const WorldRequest& world);

}  // namespace rakelight
