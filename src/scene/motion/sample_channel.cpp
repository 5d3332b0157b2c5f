// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/sample_channel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <rakelight/scene/animated_properties.h>
#include <rakelight/scene/motion.h>

#include "math/functions.h"

namespace rakelight {
namespace {

/// The position of a moment: between two keys, or at one key (from == to).
struct Moment {
    std::size_t from = 0, to = 0;
    double share = 0, seconds = 0;  ///< of the way; from key to key
};

Moment moment_of(const Block<float>& times, double t) {
    const auto after = std::upper_bound(times.begin(), times.end(), t, [](double x, float key) { return x < key; });
    const auto to = std::size_t(after - times.begin());
    if (to == 0) return {};
    if (to == times.size()) return {to - 1, to - 1};
    const double from = times[to - 1], seconds = times[to] - from;  // > 0: the first key after t
    return {to - 1, to, (t - from) / seconds, seconds};
}

/// Values of a key; for splines its in-tangent (0), value (1) or out-tangent (2).
std::span<const float> key(const AnimationChannel& c, std::size_t k, std::size_t part, std::size_t width) {
    const bool is_spline = c.interpolation == Interpolation::cubic_spline;
    return {c.values.data() + (is_spline ? 3 * k + part : k) * width, width};
}

dvec4 quaternion(std::span<const float> v) {
    const dvec4 q{v[0], v[1], v[2], v[3]};
    const double size = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return size > 0 ? dvec4{q.x / size, q.y / size, q.z / size, q.w / size} : dvec4{0, 0, 0, 1};
}

void put(dvec4 q, std::span<float> out) {
    const double size = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    if (!(size > 0)) q = {0, 0, 0, 1};
    const double s = size > 0 ? 1 / size : 1;
    out[0] = float(q.x * s), out[1] = float(q.y * s), out[2] = float(q.z * s), out[3] = float(q.w * s);
}

void slerp(dvec4 a, dvec4 b, double share, std::span<float> out) {
    double cosine = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
    if (cosine < 0) b = {-b.x, -b.y, -b.z, -b.w}, cosine = -cosine;
    double of_a = 1 - share, of_b = share;
    if (cosine < 1 - 1e-9) {
        const double angle = math::acos(cosine), sine = math::sin(angle);
        of_a = math::sin((1 - share) * angle) / sine, of_b = math::sin(share * angle) / sine;
    }
    put({of_a * a.x + of_b * b.x, of_a * a.y + of_b * b.y, of_a * a.z + of_b * b.z, of_a * a.w + of_b * b.w}, out);
}

/// Hermite spline between two keys; tangents are per second.
void spline(const AnimationChannel& c, const Moment& m, std::span<float> out) {
    const std::size_t width = out.size();
    const double s = m.share, s2 = s * s, s3 = s2 * s;
    const auto p0 = key(c, m.from, 1, width), m0 = key(c, m.from, 2, width), m1 = key(c, m.to, 0, width),
               p1 = key(c, m.to, 1, width);
    constexpr double most = std::numeric_limits<float>::max();  // tangents from files may lead beyond
    for (std::size_t i = 0; i < width; ++i) {
        const double x = ((2 * s3 - 3 * s2 + 1) * p0[i] + m.seconds * (s3 - 2 * s2 + s) * m0[i] +
                          (-2 * s3 + 3 * s2) * p1[i] + m.seconds * (s3 - s2) * m1[i]);
        out[i] = float(std::clamp(x, -most, most));
    }
}

}  // namespace

std::size_t channel_width(const Scene& scene, const AnimationChannel& channel) {
    switch (channel.path) {
        case AnimationPath::rotation:
            return 4;
        case AnimationPath::translation:
        case AnimationPath::scale:
            return 3;
        case AnimationPath::morph_weights:
            break;
        default:
            return animated_property(channel.path, channel.property)->width;
    }
    std::size_t targets = 0;
    for (const std::uint32_t mesh : scene.nodes[channel.element].meshes)
        targets = std::max(targets, scene.meshes[mesh].targets.size());
    return targets;
}

void sample_channel(const AnimationChannel& channel, double time_s, std::span<float> out) {
    const std::size_t width = out.size();
    const Moment m = moment_of(channel.times, time_s);
    const auto from = key(channel, m.from, 1, width), to = key(channel, m.to, 1, width);
    const bool turns = channel.path == AnimationPath::rotation;
    if (m.from == m.to || channel.interpolation == Interpolation::step)
        std::copy(from.begin(), from.end(), out.begin());
    else if (channel.interpolation == Interpolation::cubic_spline)
        spline(channel, m, out);
    else if (turns)
        return slerp(quaternion(from), quaternion(to), m.share, out);
    else
        for (std::size_t i = 0; i < width; ++i) out[i] = float((1 - m.share) * from[i] + m.share * to[i]);
    if (turns) put(quaternion(out), out);
}

}  // namespace rakelight
