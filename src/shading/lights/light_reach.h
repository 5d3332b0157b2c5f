// SPDX-License-Identifier: Apache-2.0
// Which lights can reach a part of a picture. A light with a range adds exactly nothing beyond it, so that leaving it out
// there changes no bit of the picture, whatever the parts and their order.
#pragma once
#include <cstdint>
#include <vector>

#include "lighting/light_parameters.h"
#include "shading/lights/light_box.h"
#include "shading/picture_camera.h"

namespace rakelight::shading {

/// How far each light of a picture reaches. Made once per picture.
class LightReach {
public:
    /// @param lights  about the eye; must outlive this
    explicit LightReach(const std::vector<lighting::LightParameters>& lights);

    /// Whether there are so many lights that end that lists are worth their making.
    bool is_worth_it() const { return ending_ > most_without_lists; }
    /// Lights that may reach a pixel of a square of the picture (px), in the order of the scene. Their spheres are not
    /// outside of the pyramid (of the beam, in parallel views) of its pixels.
    void in_square(const PictureCamera& view, int left, int top, int size, std::vector<std::uint32_t>& to) const;
    /// Those of `among` that may reach a box; all of them where `among` is null.
    void in_box(const LightBox& box, const std::vector<std::uint32_t>* among,
                std::vector<lighting::LightParameters>& to) const;

    static constexpr std::size_t most_without_lists = 8;

private:
    bool touches(const LightBox& box, std::size_t light) const;

    const std::vector<lighting::LightParameters>& lights_;
    std::vector<float> x_, y_, z_, radius_;  ///< infinity: it has no end
    std::size_t ending_ = 0;
};

}  // namespace rakelight::shading
