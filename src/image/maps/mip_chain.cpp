// SPDX-License-Identifier: Apache-2.0
#include "image/maps/mip_chain.h"

#include <algorithm>
#include <span>

#include "image/maps/mip_rows.h"
#include "image/srgb_encoder.h"
#include "math/color.h"
#include "math/isa.h"
#include "math/linear.h"

namespace rakelight {

namespace mip {
namespace {
using HalveRow = void (*)(const Row&, const Tables&);
HalveRow halve_row_for(Isa isa) { return RL_BY_ISA(isa, halve_row); }
}  // namespace
}  // namespace mip

namespace {

constexpr int rows_per_task = 16;

/// The texels of the larger level covered by one texel of the smaller one along one axis, with their weights.
struct Taps {
    int first = 0, count = 1;
    float weight[3] = {1, 0, 0};
};

/// Even: pairs. Odd, n = 2k + 1 -> k: texel i covers i n / k .. (i + 1) n / k, which are parts (k - i) / n of texel 2i,
/// k / n of 2i + 1 and (i + 1) / n of 2i + 2 (Guthe & Heckbert 2005, section 3).
Taps taps_of(int i, int larger) {
    if (larger == 1) return {};
    if (larger % 2 == 0) return {2 * i, 2, {0.5f, 0.5f, 0}};
    const int k = larger / 2;
    const double n = larger;
    return {2 * i, 3, {float((k - i) / n), float(k / n), float((i + 1) / n)}};
}

/// Averages the rows that one row of the smaller level covers.
void filter_vertically(const vec4* rows, int width, const Taps& taps, vec4* out) {
    const vec4* row = rows + std::size_t(taps.first) * std::size_t(width);
    for (int x = 0; x < width; ++x) out[x] = row[x] * taps.weight[0];
    for (int t = 1; t < taps.count; ++t) {
        row += width;
        for (int x = 0; x < width; ++x) out[x] = out[x] + row[x] * taps.weight[t];
    }
}

void filter_horizontally(const vec4* row, int larger, int smaller, vec4* out) {
    if (larger == 1) {
        out[0] = row[0];
    } else if (larger % 2 == 0) {
        for (int x = 0; x < smaller; ++x) out[x] = (row[2 * x] + row[2 * x + 1]) * 0.5f;
    } else {
        for (int x = 0; x < smaller; ++x) {
            const Taps taps = taps_of(x, larger);
            out[x] = row[2 * x] * taps.weight[0] + row[2 * x + 1] * taps.weight[1] + row[2 * x + 2] * taps.weight[2];
        }
    }
}

/// The next smaller level of a float picture.
std::vector<vec4> halve(std::span<const vec4> larger, int width, int height, Context& context) {
    const int half_width = std::max(1, width / 2), half_height = std::max(1, height / 2);
    std::vector<vec4> smaller(std::size_t(half_width) * std::size_t(half_height));
    context.parallel_for(std::size_t((half_height + rows_per_task - 1) / rows_per_task), [&](std::size_t task) {
        std::vector<vec4> row{std::size_t(width)};
        const int first = int(task) * rows_per_task, last = std::min(half_height, first + rows_per_task);
        for (int y = first; y < last; ++y) {
            filter_vertically(larger.data(), width, taps_of(y, height), row.data());
            filter_horizontally(row.data(), width, half_width,
                                smaller.data() + std::size_t(y) * std::size_t(half_width));
        }
    });
    return smaller;
}

mip::Tables make_tables() {
    mip::Tables tables{};
    for (std::size_t i = 0; i < 256; ++i) tables.linear[i] = linear_from_srgb8(std::uint8_t(i));
    tables.encode_srgb = SrgbEncoder::instance().table();
    return tables;
}

/// Weights of the texels of an odd row.
struct ColumnWeights {
    std::vector<float> first, last;
    float middle = 0;

    explicit ColumnWeights(int larger) {
        if (larger == 1 || larger % 2 == 0) return;
        for (int x = 0; x < larger / 2; ++x) {
            const Taps taps = taps_of(x, larger);
            first.push_back(taps.weight[0]), last.push_back(taps.weight[2]);
            middle = taps.weight[1];
        }
    }
};

/// The levels of 8-bit pictures, by kernels: each from the unrounded averages of the one above.
class CodeLevels {
public:
    CodeLevels(MipChain& chain, Context& context)
        : chain_(chain), context_(context), halve_row_(mip::halve_row_for(isa_from_environment())) {}

    void add_all() {
        while (chain_.levels.back().width > 1 || chain_.levels.back().height > 1) add();
    }

private:
    void add() {
        const MipLevel& larger = chain_.levels.back();
        MipLevel smaller{std::max(1, larger.width / 2), std::max(1, larger.height / 2), {}, {}};
        smaller.rgba8.resize(std::size_t(smaller.width) * std::size_t(smaller.height));
        std::vector<float> averages(smaller.rgba8.size() * 4);
        const ColumnWeights weights(larger.width);
        static const mip::Tables tables = make_tables();
        const auto tasks = std::size_t((smaller.height + rows_per_task - 1) / rows_per_task);
        context_.parallel_for(tasks, [&](std::size_t task) {
            const int first = int(task) * rows_per_task, last = std::min(smaller.height, first + rows_per_task);
            for (int y = first; y < last; ++y) {
                mip::Row row = row_of(larger, weights, y);
                const std::size_t at = std::size_t(y) * std::size_t(smaller.width);
                row.smaller = smaller.width;
                row.to_averages = averages.data() + 4 * at;
                row.to_codes = smaller.rgba8.data() + at;
                halve_row_(row, tables);
            }
        });
        averages_ = std::move(averages);
        chain_.levels.push_back(std::move(smaller));
    }

    mip::Row row_of(const MipLevel& larger, const ColumnWeights& weights, int y) const {
        mip::Row row{};
        const Taps taps = taps_of(y, larger.height);
        row.rows = taps.count;
        for (int t = 0; t < taps.count; ++t) {
            const std::size_t at = std::size_t(taps.first + t) * std::size_t(larger.width);
            if (averages_.empty())
                row.codes[t] = larger.rgba8.data() + at;
            else
                row.averages[t] = averages_.data() + 4 * at;
            row.row_weight[t] = taps.weight[t];
        }
        row.larger = larger.width;
        row.first_weight = weights.first.data(), row.last_weight = weights.last.data();
        row.middle_weight = weights.middle;
        row.is_srgb = chain_.is_srgb;
        return row;
    }

    MipChain& chain_;
    Context& context_;
    mip::HalveRow halve_row_;
    std::vector<float> averages_;  ///< of the last level; empty for the first one
};

void add_rgba32f_levels(MipChain& chain, Context& context) {
    while (chain.levels.back().width > 1 || chain.levels.back().height > 1) {
        const MipLevel& larger = chain.levels.back();
        MipLevel smaller{std::max(1, larger.width / 2), std::max(1, larger.height / 2), {}, {}};
        smaller.rgba32f = halve(larger.rgba32f, larger.width, larger.height, context);
        chain.levels.push_back(std::move(smaller));
    }
}

/// Texels of all levels, or of all but the first.
std::uint64_t texels_of(int width, int height, bool with_first) {
    std::uint64_t count = with_first ? std::uint64_t(width) * std::uint64_t(height) : 0;
    while (width > 1 || height > 1) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        count += std::uint64_t(width) * std::uint64_t(height);
    }
    return count;
}

std::uint64_t level_bytes(const Pixels& pixels) {
    return texels_of(pixels.width, pixels.height, true) *
           (pixels.component == Component::u8 ? sizeof(std::uint32_t) : sizeof(vec4));
}

/// Unrounded averages are kept besides the 8-bit levels until all are computed.
std::uint64_t averages_bytes(const Pixels& pixels) {
    return pixels.component == Component::u8 ? texels_of(pixels.width, pixels.height, false) * sizeof(vec4) : 0;
}

}  // namespace

vec3 linear_texel(const MipChain& chain, const MipLevel& level, std::size_t i) {
    if (chain.is_float) return level.rgba32f[i].xyz();
    const std::uint32_t code = level.rgba8[i];
    const auto linear = [](std::uint32_t c) { return linear_from_srgb8(std::uint8_t(c)); };
    return {linear(code & 255u), linear(code >> 8 & 255u), linear(code >> 16 & 255u)};
}

std::uint64_t mip_chain_bytes(const Pixels& pixels) { return level_bytes(pixels) + averages_bytes(pixels); }

MipChain make_mip_chain(const Pixels& pixels, ColorSpace space, Context& context) {
    MipChain chain;
    chain.is_float = pixels.component != Component::u8;
    chain.is_srgb = !chain.is_float && space == ColorSpace::srgb && !pixels.is_linear;
    if (pixels.width <= 0 || pixels.height <= 0) return chain;
    MipLevel base{pixels.width, pixels.height, {}, {}};
    chain.charge = MemoryCharge(context.memory(), level_bytes(pixels), "the texture");
    const MemoryCharge averages(context.memory(), averages_bytes(pixels), "the texture while it is made smaller");
    if (chain.is_float) {
        base.rgba32f = to_rgba32f(pixels, space, context);
        chain.levels.push_back(std::move(base));
        add_rgba32f_levels(chain, context);
    } else {
        base.rgba8 = to_rgba8(pixels, context);
        chain.levels.push_back(std::move(base));
        CodeLevels(chain, context).add_all();
    }
    return chain;
}

}  // namespace rakelight
