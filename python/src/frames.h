// SPDX-License-Identifier: Apache-2.0
// What was drawn, as arrays.
#pragma once
#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <vector>

#include <rakelight/engines/engine.h>

namespace rakelight::python {

namespace py = pybind11;

/// One picture.
struct Drawn {
    Frame frame{};
    std::optional<Frame> linear{};  ///< where the linear picture has another background than the one for the display
    std::vector<std::uint32_t> codes{};  ///< of the image, where it was asked for
    bool has_alpha = false;              ///< the image keeps it
    Camera camera{};
};

/// {"image": [H, W, 3 or 4] uint8, "color": [H, W, 4], "depth": [H, W], ..., "camera": {"to_world", "intrinsics", ...}}.
/// Channels are the frame's memory; the image is a copy.
py::dict arrays_of(Drawn drawn, bool has_image, bool has_color);

}  // namespace rakelight::python
