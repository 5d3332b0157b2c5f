// SPDX-License-Identifier: Apache-2.0
// The picture of what is behind transmissive surfaces (shading/behind.h) as kernels read it: taken tile by tile, then made a mip chain.
#pragma once
#include <memory>

#include <rakelight/engines/engine.h>

#include "cpu_shading/material_job.h"
#include "cpu_shading/textures.h"
#include "shading/picture_camera.h"

namespace rakelight::cpu_shading {

/// Not to be copied: views point into it.
class BehindPicture final : public Sink {
public:
    /// @param view  camera_behind() of the picture's
    /// @throws Error bad_file: over the memory budget
    BehindPicture(const shading::PictureCamera& view, Context& context);
    BehindPicture(const BehindPicture&) = delete;
    BehindPicture& operator=(const BehindPicture&) = delete;

    void begin(int, int, Window, std::uint32_t) override {}
    void tile(const Tile& tile) override;
    void end_pass(int) override {}

    /// After the last tile: each smaller level is the one above by the filter 1 3 3 1 along both sides, smoother than a box, whose
    /// squares would show. The same bits for any number of threads.
    void finish(Context& context);
    const BehindView* view() const { return &view_; }

private:
    MipChain chain_;
    std::shared_ptr<TextureData> packed_;
    TextureView texture_{};
    BehindView view_{};
};

}  // namespace rakelight::cpu_shading
