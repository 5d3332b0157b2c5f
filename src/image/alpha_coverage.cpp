// SPDX-License-Identifier: Apache-2.0
#include "image/alpha_coverage.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>

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
          scale_(float(scale)) {}

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
        return float(scaled(level_.rgba8[i] >> 8 * channel_ & 255u));
    }

    const MipLevel& level_;
    int channel_;
    bool is_float_, repeats_x_, repeats_y_;
    float scale_;
};

/// One of the points of a texel along one axis: between which texels it lies.
struct Point {
    int first;    ///< 0: the texel before and this one; 1: this one and the next
    float along;  ///< 0..1 from the one to the other
};

Point point(int number, int points) {
    const float at = (float(number) + 0.5f) / float(points) - 0.5f;
    return at < 0 ? Point{0, at + 1} : Point{1, at};
}

/// Points of a row that are seen. @param rows  three rows as TestedLevel::read() gives them
std::uint64_t seen_in_row(const float* const* rows, int width, int points, float cutoff, float* between) {
    std::uint64_t seen = 0;
    for (int py = 0; py < points; ++py) {
        const Point v = point(py, points);
        const float *const upper = rows[v.first], *const lower = rows[v.first + 1];
        for (int x = 0; x < width + 2; ++x) between[x] = upper[x] + (lower[x] - upper[x]) * v.along;
        for (int px = 0; px < points; ++px) {
            const Point u = point(px, points);
            const float* const left = between + u.first;
            std::uint32_t count = 0;
            for (int x = 0; x < width; ++x) count += left[x] + (left[x + 1] - left[x]) * u.along >= cutoff;
            seen += count;
        }
    }
    return seen;
}

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
    const int points = points_of(level, test, &level == chain.levels.data());
    const float cutoff = chain.is_float ? test.cutoff : test.cutoff * 255.0f - 1e-3f;  // its own code is seen
    std::atomic<std::uint64_t> seen{0};
    context.parallel_for(std::size_t((level.height + rows_per_task - 1) / rows_per_task), [&](std::size_t task) {
        const std::size_t size = std::size_t(level.width) + 2;
        std::vector<float> memory(4 * size);
        float* rows[3] = {memory.data(), memory.data() + size, memory.data() + 2 * size};
        const int first = int(task) * rows_per_task, end = std::min(level.height, first + rows_per_task);
        tested.read(first - 1, rows[0]);
        tested.read(first, rows[1]);
        std::uint64_t sum = 0;
        for (int y = first; y < end; ++y) {
            tested.read(y + 1, rows[2]);
            sum += seen_in_row(rows, level.width, points, cutoff, memory.data() + 3 * size);
            std::rotate(rows, rows + 1, rows + 3);
        }
        seen += sum;
    });
    return double(seen) / (double(level.width) * level.height * points * points);
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
