// SPDX-License-Identifier: Apache-2.0
// The cameras and lights of a scene, at rest and at a moment, kept at hand: posing a scene and reading its vertices takes too
// long for every picture of a large model.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <rakelight/render/camera_chooser.h>
#include <rakelight/render/picture.h>
#include <rakelight/scene/motion.h>
#include <rakelight/scene/scene_queries.h>

namespace rakelight::viewer {

/// Matrices node -> world, [nodes], by the pose of a scene that passed validate().
std::vector<dmat4> node_matrices(const Scene& scene);

/// [m] world. @param world  matrix of the node that places the mesh
dvec3 position_in_world(const dmat4& world, const Mesh& mesh, std::size_t vertex);

class ViewBox {
public:
    ViewBox() = default;
    /// @throws Error bad_file: see validate(), or there is nothing to draw
    explicit ViewBox(const Scene& scene);

    const Bounds& bounds() const { return bounds_; }
    const std::vector<std::string>& cameras() const { return cameras_; }  ///< a title each
    std::size_t node_count() const { return stand_in_.nodes.size(); }     ///< that are looked at for a camera
    /// The same camera as choose_camera() gives for scene_at(scene, clips), to the bit. It is there at once for the
    /// scene at rest and for the last moment.
    /// @param scene  that the box was made of. @throws Error as choose_camera()
    Camera camera(const Scene& scene, const ViewRequest& view, double aspect, std::span<const ClipTime> clips = {},
                  Visibility visibility = Visibility::z_reversed) const;
    /// The same, if the view names the camera's place or one of the scene: at once for every moment, but with the
    /// depths of the scene at rest.
    Camera quick_camera(const Scene& scene, const ViewRequest& view, double aspect, std::span<const ClipTime> clips,
                        Visibility visibility = Visibility::z_reversed) const;
    /// The scene's own at a moment, placed in the world.
    std::vector<Light> lights(std::span<const ClipTime> clips) const;

private:
    Scene stand_in_at(std::span<const ClipTime> clips) const;

    std::shared_ptr<const CameraChooser> chooser_;  ///< of the scene at rest
    Bounds bounds_;
    Scene stand_in_;  ///< its cameras and lights, what carries them, and two vertices at the corners of its box
    std::vector<Animation> motion_;  ///< [animations of the scene] what of them moves the stand-in
    std::vector<std::string> cameras_;
    struct Known;
    std::shared_ptr<Known> known_;  ///< the last moment
};

}  // namespace rakelight::viewer
