// SPDX-License-Identifier: Apache-2.0
// What is looked at, and how. A save keeps it, except for what not_saved() says. No window: commands change it (commands.h),
// pictures are made of it.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rakelight/io/world.h>
#include <rakelight/world/material_changes.h>
#include <rakelight/world/request.h>

#include "../view/view_box.h"
#include "eye.h"

namespace rakelight::viewer {

/// A file that was loaded. Immutable.
struct Model {
    std::string file;
    Scene scene;
    WorldFile world;  ///< what the file says, if it is a world
    ViewBox box;
    PictureRequest request;          ///< by the command line, and of a world by its [render]
    std::vector<std::string> files;  ///< that it is made of, textures too
    std::vector<ReportEntry> remarks;
    std::uint64_t triangles = 0, vertices = 0, objects = 0;
    bool has_meshes_without_material = false;
    double load_ms = 0;
};

/// The place of a light at a moment.
struct LightKey {
    double time_s = 0;
    dvec3 position, direction;
    bool operator==(const LightKey&) const = default;
};

/// A light of the list.
struct LightItem {
    Light light;  ///< at its place in the world: on no node
    bool is_on = true;
    bool follows_camera = false;
    std::vector<LightKey> keys{};  ///< in the order of their times
    bool operator==(const LightItem&) const = default;
};

/// Changed keys of [[material]].
struct MaterialEdit {
    MaterialTarget target;
    std::vector<WorldValue> values;
    bool operator==(const MaterialEdit&) const = default;
};

/// The place of the eye at a moment.
struct EyeKey {
    double time_s = 0;
    Eye eye;
    bool operator==(const EyeKey&) const = default;
};

/// All that determines how a model is drawn.
struct Look {
    PictureRequest request;  ///< its size, view and lights are those of the members below where they say so
    dvec3 world_up{0, 1, 0};
    std::optional<Eye> eye;                        ///< absent: as `request.view` says
    std::optional<std::vector<LightItem>> lights;  ///< absent: as `request` says
    std::vector<MaterialEdit> materials;
    std::optional<double> time_s;  ///< [s] the moment; absent: as `request.motion` says
    std::vector<EyeKey> keys;      ///< of the camera, in the order of their times
    std::uint32_t channel = 0;     ///< shown instead of the colors; 0: colors

    // Properties that every picture of an engine has are in `request` while that engine is chosen. The settings that
    // they replace are kept here, and come back with the next engine.
    std::optional<int> other_samples;  ///< of paths while none are followed, else of the rest; absent: the usual number
    bool shadows_by_nature = false;    ///< rays have them, the document has none
    std::optional<RayMethod> ray_method;  ///< of rays, while another engine draws or paths are followed
    bool operator==(const Look&) const = default;
};

/// The request for a picture of that size: the same as render_picture() draws, except for edited materials.
PictureRequest request_of(const Look& look, int width, int height);
/// The clips that it shows, at their moments.
std::vector<ClipTime> clips_of(const Look& look, const Model& model);
/// The camera of a look. @throws Error usage, as choose_camera()
Camera camera_of(const Look& look, const Model& model, int width, int height);
/// The same for the window's thread: at once while clips play, but then with the depths of the scene at rest.
Camera quick_camera_of(const Look& look, const Model& model, int width, int height);

/// The eye of the camera that is seen now. @throws Error usage, as choose_camera()
Eye seen_eye(const Look& look, const Model& model, int width, int height);
/// The same eye, to be moved: from now on the look has an eye of its own.
Eye& moving_eye(Look& look, const Model& model, int width, int height);
/// Moves the eye there, if a camera can stand there. @return false: it cannot, and nothing is changed
bool set_eye(Look& look, const Eye& eye, const Model& model, int width, int height);
/// The number of the file's camera that is seen; none: another view.
std::optional<std::size_t> current_camera(const Look& look, const Model& model);
/// The list of lights, made from those that are seen now where nobody has changed them.
std::vector<LightItem>& changing_lights(Look& look, const Model& model, int width, int height);
/// Lights that follow the camera go as it went.
void carry_lights(Look& look, const Camera& from, const Camera& to);

/// Pictures that it names.
std::vector<std::string> files_of(const Look& look);

/// The initial look of a model, from its request.
Look first_look(const Model& model);

/// By paths, pass after pass.
inline bool comes_in_passes(const PictureRequest& r) {
    return r.engine == "trace" && r.settings.method == RayMethod::path;
}

}  // namespace rakelight::viewer
