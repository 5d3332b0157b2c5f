// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/motion/animations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/format_text.h"
#include "scene/motion/sample_channel.h"

namespace rakelight::io::gltf {
namespace {

class AnimationReader {
public:
    AnimationReader(Accessors& accessors, const ChannelTargets& targets, Scene& scene)
        : accessors_(accessors), targets_(targets), scene_(scene) {}

    void read(const Value& source, std::uint32_t index) {
        Animation animation;
        animation.name = Document::name_of(source, animation_kind, index);
        const Value channels = source.list("channels");
        for (std::size_t c = 0; c < channels.size(); ++c)
            read_or_drop(document(), "an animation channel", [&] {
                const Value channel = channels.element(c, format_text("{}, channel {}", source.place(), c));
                read_channel(source, channel, animation.channels);
            });
        scene_.animations.push_back(std::move(animation));  // an empty one, too: others keep their numbers
    }

private:
    const Document& document() const { return accessors_.document(); }

    void read_channel(const Value& animation, const Value& channel, std::vector<AnimationChannel>& into) {
        const ChannelTarget target = targets_.of(channel);
        if (target.elements.empty()) return;
        AnimationChannel result;
        result.path = target.path, result.property = target.property;
        const Value samplers = animation.list("samplers");
        const std::uint32_t index = channel.required_index("sampler");
        if (index >= samplers.size()) channel.fail(format_text("sampler {} does not exist", index));
        const Value sampler = samplers.element(index, channel.place());
        result.interpolation = interpolation_of(sampler);
        result.times = numbers(times_, sampler.required_index("input"), {"key times", components(1), float_only},
                               sampler, check_times);
        result.values = numbers(values_, sampler.required_index("output"),
                                {"key values", components(target.width), float_or_small}, sampler, check_values);
        if (!target.factors.empty()) result.values = multiplied(result.values, target.factors);
        document().scene_charge().grow((target.elements.size() - 1) * sizeof(AnimationChannel), "animations");
        for (const std::uint32_t element : target.elements) {
            result.element = element;
            check_size(result, sampler);
            into.push_back(result);
        }
    }

    /// By one factor; or each number by three, side by side.
    Block<float> multiplied(const Block<float>& values, const std::vector<float>& factors) const {
        if (factors == std::vector<float>{1}) return values;
        constexpr float most = std::numeric_limits<float>::max();
        MemoryCharge charge(document().context().memory(), values.size() * factors.size() * sizeof(float),
                            "animations");
        std::vector<float> all;
        all.reserve(values.size() * factors.size());
        for (const float value : values)
            for (const float factor : factors) all.push_back(std::clamp(value * factor, -most, most));
        return {std::move(all), std::move(charge)};
    }

    static Interpolation interpolation_of(const Value& sampler) {
        const std::string word = sampler.text("interpolation", "LINEAR");
        if (word == "LINEAR") return Interpolation::linear;
        if (word == "STEP") return Interpolation::step;
        if (word == "CUBICSPLINE") return Interpolation::cubic_spline;
        sampler.fail("its interpolation '" + one_line(word, 30) + "' is unknown");
    }

    /// Accessors of animations are shared by many channels, so each becomes one block, checked once.
    template <class Check>
    Block<float> numbers(std::map<std::uint32_t, Block<float>>& cache, std::uint32_t accessor, const Expected& expected,
                         const Value& from, Check check) {
        const Elements shape = accessors_.description(accessor, expected, from);
        if (const auto known = cache.find(accessor); known != cache.end()) return known->second;
        const Elements elements = accessors_.elements(accessor, expected, from);
        MemoryCharge charge(document().context().memory(), elements.count * shape.components * sizeof(float),
                            "animations");
        Block<float> read(to_scalars(elements), std::move(charge));
        check(read, from);
        return cache.emplace(accessor, std::move(read)).first->second;
    }

    static void check_times(const Block<float>& times, const Value& sampler) {
        if (times.empty()) sampler.fail("it has no keys");
        for (std::size_t k = 0; k < times.size(); ++k)
            if (!std::isfinite(times[k]) || (k > 0 && times[k] < times[k - 1]))
                sampler.fail("its key times do not ascend at key " + std::to_string(k));
    }

    static void check_values(const Block<float>& values, const Value& sampler) {
        for (const float value : values)
            if (!std::isfinite(value)) sampler.fail("a key value is not finite");
    }

    void check_size(const AnimationChannel& channel, const Value& sampler) const {
        const std::size_t width = channel.path == AnimationPath::morph_weights
                                      ? scene_.nodes[channel.element].morph_weights.size()
                                      : channel_width(scene_, channel);
        const std::size_t per_key = width * (channel.interpolation == Interpolation::cubic_spline ? 3 : 1);
        if (per_key == 0 || channel.values.size() / per_key != channel.times.size() ||
            channel.values.size() % per_key != 0)
            sampler.fail(format_text("it has {} keys of {} numbers, but {} numbers", channel.times.size(), per_key,
                                     channel.values.size()));
    }

    Accessors& accessors_;
    const ChannelTargets& targets_;
    Scene& scene_;
    std::map<std::uint32_t, Block<float>> times_, values_;
};

}  // namespace

void read_animations(Accessors& accessors, const ChannelTargets& targets, Scene& scene) {
    const Document& document = accessors.document();
    AnimationReader reader(accessors, targets, scene);
    for (std::uint32_t a = 0; a < document.count(animation_kind); ++a) {
        const std::size_t before = scene.animations.size();
        read_or_drop(document, "animation " + std::to_string(a),
                     [&] { reader.read(document.element(animation_kind, a, document.root()), a); });
        if (scene.animations.size() == before) scene.animations.emplace_back();
    }
}

}  // namespace rakelight::io::gltf
