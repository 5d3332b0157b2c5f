// SPDX-License-Identifier: Apache-2.0
// Many lights: each run of pixels is lit by those alone that can reach it. A light with a range adds exactly nothing
// beyond it, so that leaving it out there changes no bit of the picture, whatever the tiles, the runs and their order.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engines/raster/kernel_types.h"
#include "engines/raster/view.h"

namespace rakelight::raster {

struct TileScratch;

/// How far each light of a picture reaches. Made once a picture.
class LightReach {
public:
    /// @param lights  about the eye; must outlive this
    explicit LightReach(const std::vector<lighting::LightParameters>& lights);

    /// Whether there are so many lights that end that lists are worth their making.
    bool is_worth_it() const { return ending_ > most_without_lists; }
    /// Lights that may reach a pixel of the tile, in the order of the scene: those whose spheres are not outside of the
    /// pyramid (of the beam, in parallel views) of its pixels.
    void in_tile(const View& view, int tile_x, int tile_y, std::vector<std::uint32_t>& to) const;
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

/// What Kernels::shade() does, in runs of pixels that have light lists of their own.
/// @param reach  null, or not worth it: the job's own lights
std::int32_t shade_with_lists(const Kernels& kernels, const LightReach* reach, const ShadeJob& job, TileScratch& s);

}  // namespace rakelight::raster
