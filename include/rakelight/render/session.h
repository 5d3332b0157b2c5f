// SPDX-License-Identifier: Apache-2.0
// Many pictures of one scene, or of a changing scene: intermediate results are reused.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/engines/engine.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/render/shot.h>
#include <rakelight/scene/motion.h>
#include <rakelight/world/request.h>

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
    /// Sets a loaded scene as a request wants it at the moment of some clips: with its materials, coloring, environment,
    /// preset, points and fog, to be prepared by its options. What does not depend on the moment is kept, too.
    /// @param loaded  passed validate()
    /// @param request  after decide()
    /// @return the scene that was set, to choose camera and lights by; valid until another is set
    /// @throws Error as set(); usage: no such clip or attribute; not_found, bad_file: a picture of the request
    const Scene& show(const std::shared_ptr<const Scene>& loaded, const PictureRequest& request,
                      std::span<const ClipTime> clips, Context& context);
    /// The scene that show() would set.
    Scene asked(const std::shared_ptr<const Scene>& loaded, const PictureRequest& request,
                std::span<const ClipTime> clips, Context& context);
    /// Sets a scene that this or another session has prepared. The session draws it as it was prepared, even if the
    /// settings of a picture would require a different preparation.
    void set(std::shared_ptr<const PreparedScene> scene);
    /// Sets a scene of which a single picture is drawn. Each stage takes it over from the one before, and the engine at last,
    /// so that no more memory is needed than for that picture. Later shots may differ in camera and lights, but draw the
    /// scene as it was prepared for the first one.
    /// @return the scene, to choose camera and lights by; valid until it is prepared
    /// @throws Error as set()
    const Scene& set_single(Scene scene, const PrepareOptions& options);

    /// Returns the scene prepared for pictures with these settings. Prepares it first if necessary.
    /// @throws Error usage: impossible settings, or no scene was set; bad_file: over the memory budget; failed:
    ///         cancelled
    std::shared_ptr<const PreparedScene> prepared(const RenderSettings& settings, Context& context);

    /// The same for a shot: under radiosity, its lights are in the colors of the vertices.
    /// @throws Error likewise; bad_file: an invalid light
    std::shared_ptr<const PreparedScene> prepared_for(const Shot& shot, Context& context);

    /// Does all work of render() except drawing. Afterwards the engine has the scene and its textures, and the report
    /// has the remarks about the scene and the textures.
    /// @throws Error as render()
    void warm_up(const Shot& shot, Context& context);
    /// Draws a shot.
    /// @throws Error as prepared(); usage: settings beyond the engine's capabilities
    RenderStats render(const Shot& shot, Sink& sink, Context& context);
    /// The same with the lights of the scene, or the default rig.
    RenderStats render(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context);

    /// The engine of the session.
    const Engine& engine() const;

private:
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
