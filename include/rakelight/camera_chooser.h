// SPDX-License-Identifier: Apache-2.0
// Cameras for many pictures of one scene.
#pragma once
#include <memory>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/request.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Chooses the cameras of many pictures. It reads all vertices of a scene once; then a choice takes far less time than
/// choose_camera() of picture.h, and the camera is the same, to the bit. Any number of threads may choose at the same
/// time, each with a context of its own. A moved-from chooser can only be assigned to or destroyed.
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

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rakelight
