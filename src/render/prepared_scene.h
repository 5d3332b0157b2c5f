// SPDX-License-Identifier: Apache-2.0
// The prepared scene that pictures are drawn from.
#pragma once
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <rakelight/render/session.h>

#include "prepare/prepare_scene.h"

namespace rakelight {

class PreparedScene;

/// The scene with posed vertices of all meshes, made at the first request. Copies share the vertices; they differ in
/// lights, cameras and so on.
class PosedOnce {
public:
    PosedOnce() = default;
    PosedOnce(const PosedOnce& other) : shared_(other.shared_) {}
    PosedOnce& operator=(const PosedOnce&) = delete;
    /// From any thread.
    const Scene& of(const PreparedScene& prepared, Context& context) const;
    // Only for the sole owner of the prepared scene.
    void forget() { scene_.reset(); }  ///< all but the vertices
    Scene take(PreparedScene&& prepared, Context& context);

private:
    struct Shared {
        std::mutex mutex;
        std::optional<std::vector<Mesh>> meshes;
    };
    std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
    mutable std::optional<Scene> scene_;
};

class PreparedScene {
public:
    /// Nodes, materials and all else as drawn; for meshes see posed().
    Scene scene;
    /// Of meshes that `scene` has in bind pose, for engines that pose them themselves; null: there are none.
    std::shared_ptr<const geometry::MeshPoses> poses{};
    /// The scene with all vertices: `scene` itself if nothing is left to pose.
    const Scene& posed(Context& context) const { return poses ? posed_.of(*this, context) : scene; }
    PrepareOptions options{};  ///< that it was made with
    /// What it was made of, where other poses can be made of that too: see has_bind_pose().
    std::shared_ptr<const BoundScene> bound{};
    Rare<ScenePose> pose{};  ///< that it stands in
    /// Equal for scenes that differ in lights and cameras alone; 0: unlike any other.
    std::uint64_t number = 0;
    PosedOnce posed_{};
};

/// Whether two scenes are equal in everything that prepare reads.
bool are_prepared_alike(const Scene& a, const Scene& b);

/// Whether what engines draw of both differs in lights and cameras at most.
bool are_drawn_alike(const PreparedScene& a, const PreparedScene& b);

/// Whether lights, cameras, fog and environment are equal.
bool have_same_surroundings(const Scene& a, const Scene& b);
/// Copies what prepare does not read: lights, cameras, fog, environment. Nobody else may use the scene meanwhile.
void take_surroundings(PreparedScene& prepared, const Scene& scene);

/// `options`, with what the settings of a picture of the scene require.
PrepareOptions options_for(PrepareOptions options, const RenderSettings& settings, const Scene& scene);

/// The only way from a scene to what engines draw. @param scene passed validate()
std::shared_ptr<PreparedScene> make_prepared(Scene scene, const PrepareOptions& options, const RenderSettings& settings,
                                             Context& context);

/// Another pose of the same scene. @param prepared  has `bound`
std::shared_ptr<PreparedScene> make_posed(const PreparedScene& prepared, const Rare<ScenePose>& pose, Context& context);

/// A camera of the scene, by its node or placed, as engines take it in a picture of that aspect.
Camera camera_in_world(const Scene& scene, Camera camera, double aspect);

/// The lights of the scene: its own, or the default rig, which is placed relative to the camera. For paths, emissive
/// surfaces are lights too.
std::vector<Light> lights_of(const Scene& scene, const Camera& camera, RayMethod method);
/// Those that an engine gets for a shot. @param own  the lights of the scene, whatever those are that stand in it
std::vector<Light> lights_of(const Scene& scene, const std::vector<Light>& own, const Shot& shot);
/// @param scene  as drawn
std::vector<Light> lights_of(const Scene& scene, const Shot& shot);
/// What an engine gets that does not pose vertices itself: all of them, and the lights of the shot.
Scene drawn_scene(const PreparedScene& prepared, const Shot& shot, Context& context);

/// Width to height of the whole picture.
double aspect_of(const RenderSettings& settings);

}  // namespace rakelight
