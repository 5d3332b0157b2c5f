// SPDX-License-Identifier: Apache-2.0
// The description of a picture: model, view, materials, lights, environment, settings, files. A plain value, read and
// written by the keys of [render] in world files (world.h).
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/engines/engine.h>
#include <rakelight/image/colormap.h>
#include <rakelight/image/image.h>
#include <rakelight/io/world.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/motion.h>
#include <rakelight/world/load.h>
#include <rakelight/world/material_changes.h>

namespace rakelight {

/// The camera of a picture; all members are optional. By default the first camera of the file is used, or a camera
/// fitted to the model's bounding box if the file has none.
struct ViewRequest {
    /// "front", "back", "left", "right", "top", "bottom", "isometric", "default", or empty. "file" is the first camera
    /// of the file.
    std::string side{};
    std::string camera{};                ///< index (from 0) or name of a camera of the file, or empty
    std::optional<dvec3> position{};     ///< [m] world
    std::optional<dvec3> focal_point{};  ///< [m] world; what the camera looks at
    std::optional<dvec3> up{};           ///< up vector of the picture, any length; default: `world_up`
    /// The world's up direction, any length, default +Y. Sides, the environment and the picture's default up vector
    /// rotate with it. If only `up` is given, fitted views rotate with `up`.
    std::optional<dvec3> world_up{};
    /// View direction of a fitted view in world space, any length; replaces the side.
    std::optional<dvec3> direction{};
    /// The camera orbits its focal point by these angles, after all other members are applied. It first moves to the
    /// right about the world's up direction by `azimuth_rad`, then upward by `elevation_rad`.
    std::optional<double> azimuth_rad{}, elevation_rad{};
    /// > 0; default 0.9: the share of the picture's smaller side that the model fills.
    std::optional<double> zoom_factor{};
    std::optional<double> vertical_fov_rad{};  ///< 0..pi, both exclusive
    /// 0..pi, both exclusive. If only the horizontal angle is given, pixels are square, and the vertical angle follows
    /// from it. If both angles are given, pixels may be non-square.
    std::optional<double> horizontal_fov_rad{};
    /// [m] > 0, z_near < z_far: the clip planes. If absent, cameras of the file keep their own clip planes. Fitted and
    /// placed cameras get clip planes around the model.
    std::optional<double> z_near{}, z_far{};
    /// Orthographic projection. Its extent is that of the perspective projection at the focal point.
    bool orthographic = false;

    /// Whether a member defines the camera's placement or field of view.
    bool is_placed() const {
        return position || focal_point || up || vertical_fov_rad || horizontal_fov_rad || orthographic || direction ||
               zoom_factor;
    }
    /// Whether the camera orbits its focal point.
    bool is_orbited() const { return azimuth_rad || elevation_rad; }
    bool operator==(const ViewRequest&) const = default;
};

/// Unlit coloring by a custom vertex attribute (Mesh::arrays).
struct Coloring {
    bool is_on = false;              ///< false: material colors
    std::string array{};             ///< name of the attribute; empty: the first attribute
    std::optional<int> component{};  ///< from 0; absent: the magnitude over all components
    std::optional<dvec2> range{};    ///< values at the ends of the color map, x <= y; absent: minimum and maximum
    ColorMap map = ColorMap::viridis;
    bool has_bar = false;  ///< draw a color bar with numbers at the right side
    bool operator==(const Coloring&) const = default;
};

/// The scene colored by a vertex attribute. The colors replace materials and vertex colors. Vertices without the
/// attribute are gray.
/// @throws Error usage: no such attribute or component; the message lists the available ones
RL_API Scene color_by_array(Scene scene, const Coloring& coloring, Context& context);

/// Which clips of a scene are shown, and their time. By default nodes have the transforms of the file.
struct MotionRequest {
    std::optional<int> index{};      ///< into Scene::animations; -1: all clips; absent: the clip `name`, or the first
    std::string name{};              ///< of a clip; empty: the clip `index`
    std::optional<double> time_s{};  ///< [s] absent: the start of the clip
    bool autoplay = false;           ///< the viewer plays the clip at once; a picture shows the clip
    /// Whether any member is set.
    bool is_set() const { return index || !name.empty() || time_s || autoplay; }
    bool operator==(const MotionRequest&) const = default;
};

/// The requested clips of a scene with their times. Clips with Animation::plays_always are added at the same time. The
/// result is empty if no clip is requested.
/// @throws Error usage: no such clip; the message lists the clips of the scene
RL_API std::vector<ClipTime> clips_of(const Scene& scene, const MotionRequest& motion);

/// How data channels are written, as bits.
/// - `exr`: one EXR file of 32-bit floats per data channel: NAME.depth.exr. One component is stored as the EXR channel
///   Y, two as R and G, three as R, G and B, four as R, G, B and A. Indices are converted to floats, exact up to 2^24;
///   no_index is -1.
/// - `layers`: all data channels as layers of one EXR file, with EXR channels such as depth.Z and normal.X. The file is
///   the output itself if its name ends with .exr; else it is NAME.channels.exr. Indices have the EXR type UINT.
/// - `png`: one picture for viewing per data channel: NAME.depth.png.
enum ChannelFiles : std::uint32_t {
    channel_files_exr = 1u << 0,
    channel_files_layers = 1u << 1,
    channel_files_png = 1u << 2,
};

/// The Channel bits of "depth", "face-normal", ..., "lighting", "all" or "none".
/// @throws Error usage
RL_API std::uint32_t channels_by_name(std::string_view name);

/// Defaults of settings that are not given: docs/default-look.md.
enum class Look : std::uint8_t {
    plain,    ///< settings keep the values of their members
    standard  ///< apply_look() chooses settings that neither the file nor PictureRequest::given_keys gives
};

/// Predefined combinations of settings: docs/shading.md.
enum class Preset : std::uint8_t {
    none,
    fixed_function  ///< the fixed-function pipeline of OpenGL 1.x
};
/// Whether a preset sets this key of [render]. Explicitly given keys override the preset.
RL_API bool is_preset_key(std::string_view key);

/// Overlays drawn over the finished picture: docs/overlays.md.
struct Overlays {
    bool grid = false;      ///< a grid on the ground below the model
    bool axis = false;      ///< the world axes in a corner
    bool filename = false;  ///< the model's name
    bool metadata = false;  ///< the size of the model
    /// Whether any overlay is on.
    bool any() const { return grid || axis || filename || metadata; }
    bool operator==(const Overlays&) const = default;
};

/// The description of one picture.
struct PictureRequest {
    std::string input{};          ///< model file, world file or built-in shape, as for load()
    std::string output{};         ///< ending .png, .jpg, .webp, .ppm (sRGB, 8 bit), .exr or .hdr (linear)
    std::string engine = "soft";  ///< name for make_engine()
    LoadOptions load{};
    MaterialOverrides materials{};
    Coloring coloring{};
    MotionRequest motion{};
    /// As by default, but that hard edges are found by the rule of creases: who sets an angle here sets `creases` too.
    PrepareOptions prepare{.creases = Creasing::automatic};
    ViewRequest view{};
    /// If present, these lights replace all others. If absent, the picture has the lights of the file. If the file has
    /// neither lights nor an environment that lights the scene, the picture has the default light rig.
    std::optional<std::vector<Light>> lights{};
    bool default_lights = false;  ///< use the default rig even if the file has lights; `lights` overrides this
    bool studio_lights = false;   ///< the built-in studio and a key light replace all lights; `lights` overrides this
    Look look = Look::plain;
    /// A preset restricts materials and lights (docs/shading.md). It also sets the members of the keys for which
    /// is_preset_key() is true, but only when the key "preset" is read by read_render_keys().
    Preset preset = Preset::none;
    std::vector<std::string> given_keys{};  ///< keys of [render] whose settings `look` and `preset` must not change
    double light_intensity = 1;             ///< >= 0; multiplies every light
    /// 0..1; 0: off. Limits the range of point and spot lights that have no range. The limit is the distance at which
    /// the radiance of a white Lambert surface that faces the light falls below this value. So a surface loses at most
    /// this radiance per light.
    double light_cutoff = 0;
    std::optional<Fog> fog{};  ///< replaces Scene::fog
    Overlays overlays{};
    ToneSettings tone{};  ///< for 8-bit pictures; EXR and HDR stay linear
    /// Equirectangular picture that replaces the picture of the scene's environment. Empty: the scene's environment, or
    /// the built-in studio if the scene has none.
    std::string hdri_file{};
    /// `hdri_ambient`: whether the environment lights the scene. `hdri_skybox`: whether it is the background. Absent: as
    /// in the scene. If the scene has no environment: off, but `hdri_file` alone lights the scene.
    std::optional<bool> hdri_ambient{}, hdri_skybox{};
    std::optional<double> hdri_intensity{};     ///< >= 0; replaces Environment::intensity of the scene
    std::optional<double> hdri_rotation_rad{};  ///< about +Y; replaces Environment::rotation_rad of the scene
    /// Data channels are written as `channel_files` says. With a window, the picture has the size of the window. Alpha
    /// is written if background.w < 1.
    RenderSettings settings{};
    std::uint32_t channel_files = channel_files_exr;  ///< ChannelFiles bits
    /// true: a cancelled picture is written; its unfinished pixels have the background's color. false: it is not
    /// written.
    bool keep_partial = false;
    /// EXR files store colors, including the color channels, as 16-bit halves. All other data stays at 32 bits.
    bool half_colors = false;
    /// Whether anything is drawn over the finished picture.
    bool has_overlays() const { return overlays.any() || (coloring.is_on && coloring.has_bar); }
    bool operator==(const PictureRequest&) const = default;
};

}  // namespace rakelight
