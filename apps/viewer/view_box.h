// SPDX-License-Identifier: Apache-2.0
// The cameras of a scene, kept at hand: choose_camera() goes over all vertices, which takes too long for every picture of a
// large model.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include <rakelight/picture.h>
#include <rakelight/scene_queries.h>

namespace rakelight::viewer {

class ViewBox {
public:
    ViewBox() = default;
    /// @throws Error bad_file: see validate(), or there is nothing to draw
    explicit ViewBox(const Scene& scene);

    const Bounds& bounds() const { return bounds_; }
    const std::vector<std::string>& cameras() const { return cameras_; }  ///< a title each
    std::size_t node_count() const { return stand_in_.nodes.size(); }     ///< that are looked at for a camera
    /// What choose_camera() gives for the scene, to the bit; a second time at once, and at once where the view names the camera's
    /// place. @param scene  that the box was made of. @throws Error as choose_camera()
    Camera camera(const Scene& scene, const ViewRequest& view, double aspect) const;

private:
    Bounds bounds_;
    Scene stand_in_;  ///< its cameras, what carries them, and two vertices at the corners of its box
    std::vector<std::string> cameras_;
    struct Known;
    std::shared_ptr<Known> known_;  ///< the last that took all vertices
};

}  // namespace rakelight::viewer
