// SPDX-License-Identifier: Apache-2.0
// Which lines are wanted over a picture, and the lines themselves.
#pragma once
#include <memory>
#include <vector>

#include <rakelight/render/session.h>

#include "gizmo.h"
#include "overlay.h"

namespace rakelight::viewer {

struct Marks {
    bool grid = false, axes = false, lights = false;
    bool vectors[3] = {};                ///< by VertexVector
    std::shared_ptr<const Seams> seams;  ///< null: none
    std::size_t light = 0;               ///< selected
    bool has_handles = false;            ///< of that light
    Handle lit = Handle::none;           ///< highlighted
    double scale = 1;                    ///< of the display
    bool operator==(const Marks&) const = default;

    /// Some that surfaces hide.
};

/// Keeps what takes long to find.
class MarkLines {
public:
    /// @param prepared  what the picture was drawn of  @param camera  and by what, of the world
    std::vector<Line> lines(const Marks& marks, const Look& look, const Model& model,
                            const std::shared_ptr<const PreparedScene>& prepared, const Camera& camera, int width,
                            int height);

private:
    std::vector<Line> vectors_;
    std::shared_ptr<const PreparedScene> vectors_of_;
    bool vectors_which_[3] = {};
};

}  // namespace rakelight::viewer
