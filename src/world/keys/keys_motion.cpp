// SPDX-License-Identifier: Apache-2.0
// Keys of clips and times.
#include "world/keys/key_fields.h"

namespace rakelight::keys {
namespace {

constexpr int all_clips = -1, max_clips = 1'000'000;
constexpr double longest_s = 1e6;

void read_name(PictureRequest& r, Words w) {
    if (w[0].empty()) throw values::wrong("animation-name", "needs the name of an animation");
    r.motion.name = w[0];
}

constexpr RenderKey table_of_motion[] = {
    RL_KEY("animation-index", value, r.motion.index, values::integer("animation-index", w[0], all_clips, max_clips),
           {std::to_string(*r.motion.index)}),
    {"animation-name", Kind::value, read_name, RL_WRITE(r.motion.name, {r.motion.name})},
    RL_KEY("animation-time", value, r.motion.time_s, values::number("animation-time", w[0], -longest_s, longest_s),
           {text_of(*r.motion.time_s)}),
    RL_KEY("animation-autoplay", flag, r.motion.autoplay, w[0] == "on", {"on"}),
};

}  // namespace

constinit const KeyTable motion_keys = table_of_motion;

}  // namespace rakelight::keys
