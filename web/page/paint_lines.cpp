// SPDX-License-Identifier: Apache-2.0
#include "paint_lines.h"

#include <cstring>

#include "../../apps/viewer/view/overlay.h"
#include "image/draw_line.h"

namespace rakelight::web {
namespace {

constexpr double slack_share = 2e-3;  // of the model's size

std::uint8_t code(float display) { return std::uint8_t(display * 255 + 0.5f); }

}  // namespace

void paint_lines(std::vector<std::uint32_t>& codes, std::span<const Line> lines, const Camera& camera,
                 std::span<const float> depth, int width, int height, double size) {
    if (lines.empty()) return;
    Pixels picture{.width = width, .height = height, .channels = 4};
    picture.bytes.resize(codes.size() * sizeof(codes[0]));
    std::memcpy(picture.bytes.data(), codes.data(), picture.bytes.size());
    for (const Line& line : viewer::visible_lines(lines, camera, depth, width, height, slack_share * size)) {
        const auto a = viewer::pixel_of(line.from, camera, width, height);
        const auto b = viewer::pixel_of(line.to, camera, width, height);
        if (!a || !b) continue;
        draw_line(picture, *a, *b, double(line.width_px), {code(line.color.x), code(line.color.y), code(line.color.z)});
    }
    std::memcpy(codes.data(), picture.bytes.data(), picture.bytes.size());
}

}  // namespace rakelight::web
