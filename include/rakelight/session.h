// SPDX-License-Identifier: Apache-2.0
// Many pictures of one scene, or of a changing scene: intermediate results are reused.
#pragma once
#include <memory>
#include <string>

#include <rakelight/engine.h>
#include <rakelight/export.h>
#include <rakelight/prepare.h>

namespace rakelight {

/// A scene prepared for drawing: repaired, with normals, tangents, height maps and displaced meshes. Immutable; any
/// number of sessions may share it, in any threads.
class PreparedScene;

/// An engine with a scene. A session draws the same pictures as render() of render.h. Between two pictures it keeps
/// decoded textures, mip chains, shadow maps, computed normals and the engine's memory. Use a session from one thread
/// at a time; different sessions are independent. A moved-from session can only be assigned to or destroyed.
///
///     Session session;
///     session.set(load("helmet.glb", {}, context));
///     for (const Camera& camera : cameras) session.render(camera, settings, frame, context);
class RL_API Session {
public:
    /// @throws Error usage: no such engine
    explicit Session(const std::string& engine = "soft");
    /// With the caller's engine.
    explicit Session(std::unique_ptr<Engine> engine);  ///< @throws Error usage: null
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    /// Sets the scene. Blocks shared with the previous scene are not processed again. If only lights, cameras, fog or
    /// environment differ from the previous scene, the whole preparation is reused.
    /// @throws Error bad_file: an invalid scene (see validate()), or nothing to draw; the session keeps its previous
    ///         scene
    void set(Scene scene, const PrepareOptions& options = {});
    /// Sets a scene that this or another session has prepared. The session draws it as it was prepared, even if the
    /// settings of a picture would require a different preparation.
    void set(std::shared_ptr<const PreparedScene> scene);

    /// Returns the scene prepared for pictures with these settings. Prepares it first if necessary.
    /// @throws Error usage: impossible settings, or no scene was set; bad_file: over the memory budget; failed:
    ///         cancelled
    std::shared_ptr<const PreparedScene> prepared(const RenderSettings& settings, Context& context);

    /// Does all work of render() except drawing. Afterwards the engine has the scene and its textures, and the report
    /// has the remarks about the scene and the textures.
    /// @throws Error as render()
    void warm_up(const Camera& camera, const RenderSettings& settings, Context& context);
    /// Draws through a camera: one at a node of the scene, or one placed in world space. A scene without lights and
    /// without a lighting environment gets the default light rig, which is fixed to the camera.
    /// @throws Error as prepared(); usage: settings beyond the engine's capabilities
    RenderStats render(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context);

    /// The engine of the session.
    const Engine& engine() const;

private:
    friend void give(Session& session, std::shared_ptr<PreparedScene> scene);  // internal
    struct State;
    std::unique_ptr<State> state_;
};

/// The scene with its animated vertices posed. The first call poses them. The reference is valid as long as `prepared`
/// exists.
/// @throws Error bad_file: over the memory budget
RL_API const Scene& scene_of(const PreparedScene& prepared);
/// The same scene, but animated vertices may be in bind pose. It costs nothing: use it for all data except vertices.
RL_API const Scene& unposed_scene_of(const PreparedScene& prepared);

}  // namespace rakelight
