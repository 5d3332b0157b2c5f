// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>

#include <rakelight/base/context.h>
#include <rakelight/image/image.h>

namespace rakelight::io::codec {

/// @return how many blocks of `factor` pixels cover a side of `size` pixels
constexpr int divided_up(int size, int factor) { return (size + factor - 1) / factor; }

/// A picture at 1/factor of its size: each pixel is the mean code value of factor * factor pixels, fewer at the right
/// and lower border. @param row_at  row y of the whole picture; called once a row, from top to bottom
Pixels block_means(const Pixels& header, int factor, const std::function<const std::byte*(int y)>& row_at,
                   Context& context);

}  // namespace rakelight::io::codec
