// SPDX-License-Identifier: Apache-2.0
// The camera of a picture, and cameras for many pictures of one scene.
#pragma once
#include <memory>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/world/request.h>

namespace rakelight {

/// The camera for a picture of `aspect` = width / height. It is placed in world space, with near and far planes around
/// the model. If a camera of the file has another aspect, its field of view is widened until the picture contains the
/// original field of view. If the model's bounding box is outside of the view of that camera, a fitted camera replaces
/// it, with a warning.
/// @throws Error usage: no such side or camera, impossible angle or position; bad_file "nothing to draw".
RL_API Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Context& context);

/// The camera that render_picture() chooses for a picture with this hidden-surface removal. The z-buffers of the textbook
/// (z_float, z16, z24, z32) lose precision if near is small: a camera inside of a scene then has near = far / 10000. All
/// others show what is nearer.
RL_API Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Visibility visibility,
                            Context& context);

/// Chooses the cameras of many pictures. It checks a scene and reads all its vertices once. If near vertices follow one
/// another, as in most files, a choice then looks at few of them. The camera is that of choose_camera(), to
/// the bit. Any number of threads may choose at the same time, each with a context of its own. A moved-from chooser can
/// only be assigned to or destroyed.
///
///     const CameraChooser chooser(scene, context);
///     for (double angle = 0; angle < 6.28; angle += 0.1)
///         session.render(chooser.choose({.azimuth_rad = angle}, 1.5, context), settings, frame, context);
class RL_API CameraChooser {
public:
    /// Keeps the scene, which shares its blocks, as its vertices are posed now.
    /// @throws Error bad_file: an invalid scene (see validate()), or over the memory budget
    CameraChooser(Scene scene, Context& context);
    ~CameraChooser();
    CameraChooser(CameraChooser&&) noexcept;
    CameraChooser& operator=(CameraChooser&&) noexcept;

    /// The camera that choose_camera() gives for this scene, with the same remarks.
    /// @param aspect  width / height of the picture, > 0
    /// @throws Error as choose_camera()
    Camera choose(const ViewRequest& view, double aspect, Context& context) const;
    /// For a picture with this hidden-surface removal, as choose_camera().
    Camera choose(const ViewRequest& view, double aspect, Visibility visibility, Context& context) const;
    /// Axis-aligned box in world space of all that is drawn; empty if there is nothing.
    const Bounds& bounds() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rakelight
