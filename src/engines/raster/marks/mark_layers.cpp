// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/marks/mark_layers.h"

#include <utility>

#include "engines/raster/blend.h"

namespace rakelight::raster {

MarkLayers::MarkLayers(const TileJob& job, std::size_t tile, TileScratch& scratch)
    : job_(job),
      s_(scratch),
      marks_(job, tile, scratch),
      ox_(job.grid.origin_x(tile)),
      oy_(job.grid.origin_y(tile)),
      lists_(tile_pixels),
      has_any_(tile_pixels) {
    marks_.for_each_fragment([this](const MarkFragment& f) {
        take(f);
        return false;  // those in front of a blended surface hide none behind it
    });
    s_.mark_tests += marks_.tests();
}

MarkLayers::~MarkLayers() { job_.front.memory.remove(charged_); }

void MarkLayers::take(const MarkFragment& f) {
    if (waiting_.size() == waiting_.capacity()) {
        const std::size_t room = std::max<std::size_t>(1024, 2 * waiting_.size());
        job_.front.memory.add(room * sizeof(Waiting));  // the old ones live until they are copied
        waiting_.reserve(room);
        job_.front.memory.remove(std::exchange(charged_, room * sizeof(Waiting)));
    }
    List& list = lists_[f.pixel];
    has_any_[f.pixel] = 1;
    const auto index = std::uint32_t(waiting_.size());
    (list.last == no_index ? list.first : waiting_[list.last].next) = index;
    list.last = index;
    waiting_.push_back({f, no_index});
}

void MarkLayers::lay_behind(const ScreenTriangle& t, std::size_t pixel, vec4* colors, std::size_t samples) {
    if (lists_[pixel].first == no_index) return;
    if (last_ != &t) {
        last_ = &t;
        plane_ = SurfacePlane(t, ox_, oy_);
    }
    const double key = plane_.key(pixel);
    const DepthTolerance tolerance = plane_.tolerance();
    lay(pixel, colors, samples,
        [&](const MarkFragment& f) { return double(f.key) + tolerance.of(double(f.key), double(f.reach)) < key; });
}

void MarkLayers::lay_rest() {
    for (std::size_t p = 0; p < tile_pixels; ++p) lay(p, &s_.color[p], 1, [](const MarkFragment&) { return true; });
    marks_.put_channels();
}

template <class Chosen>
void MarkLayers::lay(std::size_t pixel, vec4* to, std::size_t samples, const Chosen& is_chosen) {
    PendingMark pending;
    const auto lay_color = [&](vec4 color) {
        for (std::size_t k = 0; k < samples; ++k) lay_over(color, to[k]);
        ++s_.marked;
    };
    List& list = lists_[pixel];
    const List before = std::exchange(list, List{});
    for (std::uint32_t i = before.first; i != no_index;) {
        Waiting& w = waiting_[i];
        const std::uint32_t next = std::exchange(w.next, no_index);
        if (is_chosen(w.fragment)) {
            pending.add(w.fragment, lay_color);
        } else {
            (list.last == no_index ? list.first : waiting_[list.last].next) = i;
            list.last = i;
        }
        i = next;
    }
    pending.finish(lay_color);
}

}  // namespace rakelight::raster
