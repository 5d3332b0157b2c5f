// SPDX-License-Identifier: Apache-2.0
// Many pictures of one scene, or of a scene that changes: what was made for one is kept for the next.
#pragma once
#include <memory>
#include <string>

#include <rakelight/engine.h>
#include <rakelight/export.h>
#include <rakelight/prepare.h>

namespace rakelight {

/// A scene made ready to be drawn: repaired, with normals, tangents, height maps and displaced meshes. Immutable: any number of
/// sessions, in any threads, may share it.
class PreparedScene;

/// An engine with a scene. The same pictures as render() of render.h gives, without its cost for each: decoded textures, mip chains,
/// shadow maps, made normals and the engine's own memory stay. One thread at a time; different sessions are independent. One that was
/// moved from can only be assigned to or destroyed.
///
///     Session session;
///     session.set(load("helmet.glb", {}, context));
///     for (const Camera& camera : cameras) session.render(camera, settings, frame, context);
class RL_API Session {
public:
    /// @throws Error usage: no such engine
    explicit Session(const std::string& engine = "soft");
    /// With an engine of the caller's.
    explicit Session(std::unique_ptr<Engine> engine);  ///< @throws Error usage: null
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    /// Draws another scene from now on. Blocks that it shares with the one before are not taken up again; where only lights,
    /// cameras, fog or environment differ, nothing is made anew.
    /// @throws Error bad_file: see validate(), or there is nothing to draw; the scene before stays
    void set(Scene scene, const PrepareOptions& options = {});
    /// Draws a scene that was made ready before, here or by another session, as it was prepared, whatever the settings of a
    /// picture would ask for.
    void set(std::shared_ptr<const PreparedScene> scene);

    /// The scene as pictures with these settings need it; made where it is not there yet.
    /// @throws Error usage: impossible settings, no scene was set; bad_file, failed: cancelled
    std::shared_ptr<const PreparedScene> prepared(const RenderSettings& settings, Context& context);

    /// All that render() does before it draws: the engine has the scene with its textures then, and what is to be said of them
    /// is in the report. @throws Error as render()
    void take_up(const Camera& camera, const RenderSettings& settings, Context& context);
    /// Draws through a camera of the scene, or one placed in the world. A scene that has no lights, and no environment that is one, gets
    /// the default rig, which stands with the camera.
    /// @throws Error as prepared(); what the engine throws: settings beyond its abilities
    RenderStats render(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context);

    /// The engine that it draws with.
    const Engine& engine() const;

private:
    friend void give(Session& session, std::shared_ptr<PreparedScene> scene);  // of the library itself
    struct State;
    std::unique_ptr<State> state_;
};

/// The scene that was made ready; it lives as long as the prepared one. Vertices that move are posed when this is first
/// asked. @throws Error bad_file: over the memory budget
RL_API const Scene& scene_of(const PreparedScene& prepared);
/// The same, but that vertices which move may be in bind pose: for questions about all else, at no cost.
RL_API const Scene& unposed_scene_of(const PreparedScene& prepared);

}  // namespace rakelight
