// SPDX-License-Identifier: Apache-2.0
#include "image/maps/alpha_coverage.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace rakelight {
namespace {

constexpr int rows_per_task = 16;
constexpr int most_points = 8, fewest_points = 2;  ///< along a texel's side
constexpr int points_a_side = 2048;                ///< that a level has at least, up to `most_points` a texel
constexpr int points_of_first = 4;                 ///< of the full picture at least, whose alpha may be all or nothing
constexpr double unseen_part = 1e-3;               ///< stray texels, whatever becomes of them
constexpr double most_closed_part = 0.05;          ///< of holes that may close for the color's sake

/// The values of a level's tested channel, as they will be compared.
class TestedLevel {
public:
    TestedLevel(const MipChain& chain, const MipLevel& level, const AlphaTest& test, double scale, bool repeats_x,
                bool repeats_y)
        : level_(level),
          channel_(test.channel),
          is_float_(chain.is_float),
          repeats_x_(repeats_x),
          repeats_y_(repeats_y),
          scale_(float(scale)) {
        for (std::uint32_t code = 0; code < 256; ++code) of_codes_[code] = float(scaled(code));
    }

    float scaled(float value) const { return std::min(value * scale_, std::max(value, 1.0f)); }
    std::uint32_t scaled(std::uint32_t code) const {
        return std::uint32_t(std::min(float(code) * scale_ + 0.5f, 255.0f));
    }

    /// Row y, -1..height, with the texel before it and the one after it. @param to  [width + 2]
    void read(int y, float* to) const {
        if (y < 0) y = repeats_y_ ? level_.height - 1 : 0;
        if (y == level_.height) y = repeats_y_ ? 0 : level_.height - 1;
        const std::size_t at = std::size_t(y) * std::size_t(level_.width);
        const int width = level_.width;
        for (int x = 0; x < width; ++x) to[x + 1] = value(at + std::size_t(x));
        to[0] = to[repeats_x_ ? width : 1];
        to[width + 1] = to[repeats_x_ ? 1 : width];
    }

private:
    float value(std::size_t i) const {
        if (is_float_) return scaled(level_.rgba32f[i][std::size_t(channel_)]);
        return of_codes_[level_.rgba8[i] >> 8 * channel_ & 255u];
    }

    const MipLevel& level_;
    int channel_;
    bool is_float_, repeats_x_, repeats_y_;
    float scale_;
    std::array<float, 256> of_codes_;
};

/// Points of a texel along one axis. Those before its middle lie between the texel before and this one, others between
/// this one and the next.
struct TexelPoints {
    int count, middle;         ///< middle: those before it
    float along[most_points];  ///< 0..1 from the one texel to the other

    explicit TexelPoints(int points) : count(points), middle(points / 2), along{} {
        for (int i = 0; i < count; ++i) {
            const float at = (float(i) + 0.5f) / float(count) - 0.5f;
            along[i] = at < 0 ? at + 1 : at;
        }
    }
};

/// A row of texels, with the one before it and the one after it. [width + 2]
struct TestedRow {
    float* values;
    std::uint8_t* seen;  ///< 1: the texel is, else 0
};

/// Points between two rows of texels that are seen. Between four texels that are all seen, or all unseen, so is every
/// point: only the others are interpolated.
class PointsBetween {
public:
    PointsBetween(const TestedRow& upper, const TestedRow& lower, const TexelPoints& points, float cutoff)
        : upper_(upper), lower_(lower), points_(points), cutoff_(cutoff) {}

    /// @param first, end  of the points down a texel
    std::uint64_t seen(int width, int first, int end) const {
        std::uint64_t columns = 0, seen = 0;
        for (int x = 0; x <= width; ++x) {
            for (int alike = eight_alike(x, width); alike >= 0; alike = eight_alike(x, width))
                columns += std::uint64_t(8 * alike * points_.count), x += 8;
            const int of_four = upper_.seen[x] + upper_.seen[x + 1] + lower_.seen[x] + lower_.seen[x + 1];
            if (of_four == 0) continue;
            const int from = x > 0 ? points_.middle : points_.count,
                      to = points_.count + (x < width ? points_.middle : 0);
            if (of_four == 4)
                columns += std::uint64_t(to - from);
            else
                seen += seen_between(x, from, to, first, end);
        }
        return seen + columns * std::uint64_t(end - first);
    }

private:
    /// 1 or 0: all texels of the eight places from x on are seen, or none is; -1: some are, or the row ends.
    int eight_alike(int x, int width) const {
        if (x == 0 || x + 8 > width) return -1;
        std::uint64_t words[4];
        std::memcpy(&words[0], upper_.seen + x, 8), std::memcpy(&words[1], upper_.seen + x + 1, 8);
        std::memcpy(&words[2], lower_.seen + x, 8), std::memcpy(&words[3], lower_.seen + x + 1, 8);
        if ((words[0] | words[1] | words[2] | words[3]) == 0) return 0;
        return (words[0] & words[1] & words[2] & words[3]) == 0x0101010101010101u ? 1 : -1;
    }

    /// Between texels x and x + 1. @param from, to  of the points along both
    std::uint64_t seen_between(int x, int from, int to, int first, int end) const {
        std::uint64_t seen = 0;
        for (int y = first; y < end; ++y) {
            const float down = points_.along[y];
            const float one = upper_.values[x] + (lower_.values[x] - upper_.values[x]) * down,
                        other = upper_.values[x + 1] + (lower_.values[x + 1] - upper_.values[x + 1]) * down;
            for (int i = from; i < to; ++i)
                seen += one + (other - one) * points_.along[i < points_.count ? i : i - points_.count] >= cutoff_;
        }
        return seen;
    }

    TestedRow upper_, lower_;
    const TexelPoints& points_;
    float cutoff_;
};

int points_of(const MipLevel& level, const AlphaTest& test, bool is_first) {
    if (!test.is_linear) return 1;
    return std::clamp(points_a_side / std::max(level.width, level.height), is_first ? points_of_first : fewest_points,
                      most_points);
}

void scale_channel(MipLevel& level, const TestedLevel& tested, int channel) {
    for (std::uint32_t& texel : level.rgba8) {
        const std::uint32_t code = tested.scaled(texel >> 8 * channel & 255u);
        texel = (texel & ~(255u << 8 * channel)) | code << 8 * channel;
    }
    for (vec4& texel : level.rgba32f) {
        float& value = texel[std::size_t(channel)];
        value = tested.scaled(value);
    }
}

/// The scale of one level, by bisection.
class ScaleSearch {
public:
    template <class Coverage>
    ScaleSearch(double wanted, double close, double first, const Coverage& coverage) : wanted_(wanted), scale_(first) {
        const auto is_close = [&](double scale) {
            last_ = coverage(scale) - wanted_;
            if (std::abs(last_) < std::abs(error_)) error_ = last_, scale_ = scale;
            return std::abs(error_) <= close;
        };
        if (is_close(first)) return;
        double low = first, high = first;
        for (double step = 1.2; last_ < 0 && high < highest; step *= step)
            if (low = high, high *= step; is_close(high)) return;
        const bool is_below = low < high;
        for (double step = 1.2; !is_below && last_ > 0 && low > 1 / highest; step *= step)
            if (high = low, low /= step; is_close(low)) return;
        for (int i = 0; i < steps; ++i) {
            const double middle = 0.5 * (low + high);
            if (is_close(middle)) return;
            (last_ < 0 ? low : high) = middle;
        }
    }
    double scale() const { return scale_; }
    double error() const { return error_; }  ///< coverage beyond the wanted one

private:
    static constexpr double highest = 256;  ///< the least code times this is opaque
    static constexpr int steps = 10;
    double wanted_, scale_, error_ = 2, last_ = 0;
};

}  // namespace

double alpha_coverage(const MipChain& chain, const MipLevel& level, const AlphaTest& test, double scale, bool repeats_x,
                      bool repeats_y, Context& context) {
    const TestedLevel tested(chain, level, test, scale, repeats_x, repeats_y);
    const TexelPoints points(points_of(level, test, &level == chain.levels.data()));
    const float cutoff = chain.is_float ? test.cutoff : test.cutoff * 255.0f - 1e-3f;  // its own code is seen
    std::atomic<std::uint64_t> seen{0};
    context.parallel_for(std::size_t((level.height + rows_per_task - 1) / rows_per_task), [&](std::size_t task) {
        const std::size_t size = std::size_t(level.width) + 2;
        std::vector<float> values(3 * size);
        std::vector<std::uint8_t> seen_texels(3 * size);
        TestedRow rows[3];
        for (std::size_t r = 0; r < 3; ++r) rows[r] = {values.data() + r * size, seen_texels.data() + r * size};
        const auto read = [&](int y, const TestedRow& row) {
            tested.read(y, row.values);
            for (std::size_t x = 0; x < size; ++x) row.seen[x] = std::uint8_t(row.values[x] >= cutoff);
        };
        const int first = int(task) * rows_per_task, end = std::min(level.height, first + rows_per_task);
        read(first - 1, rows[0]);
        read(first, rows[1]);
        std::uint64_t sum = 0;
        for (int y = first; y < end; ++y) {
            read(y + 1, rows[2]);
            sum += PointsBetween(rows[0], rows[1], points, cutoff).seen(level.width, 0, points.middle);
            sum += PointsBetween(rows[1], rows[2], points, cutoff).seen(level.width, points.middle, points.count);
            std::rotate(rows, rows + 1, rows + 3);
        }
        seen += sum;
    });
    return double(seen) / (double(level.width) * level.height * points.count * points.count);
}

void keep_coverage(MipChain& chain, const AlphaTest& test, bool repeats_x, bool repeats_y, Context& context) {
    if (!(test.cutoff > 0) || chain.levels.size() < 2) return;
    const double wanted = alpha_coverage(chain, chain.levels[0], test, 1, repeats_x, repeats_y, context);
    if (wanted < unseen_part || 1 - wanted < unseen_part) return;
    const double close = 0.005 * std::min(wanted, 1 - wanted);
    const double most_error = std::max(0.25 * std::min(wanted, 1 - wanted), wanted < 0.5 ? 0.0 : most_closed_part);
    double scale = 1;
    for (std::size_t l = 1; l < chain.levels.size(); ++l) {
        MipLevel& level = chain.levels[l];
        const ScaleSearch search(wanted, close, scale, [&](double s) {
            return alpha_coverage(chain, level, test, s, repeats_x, repeats_y, context);
        });
        if (std::abs(search.error()) > most_error) return chain.levels.resize(l);
        scale = search.scale();
        scale_channel(level, TestedLevel(chain, level, test, scale, repeats_x, repeats_y), test.channel);
    }
}

}  // namespace rakelight
