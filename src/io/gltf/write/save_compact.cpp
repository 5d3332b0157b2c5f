// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_compact.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "io/gltf/write/save_uses.h"

namespace rakelight::io::gltf {
namespace {

struct Range {
    std::uint64_t begin, end;
};

/// Bytes of buffer 0 that a view, or the extension that holds it compressed, lies in.
class ChannelRange {
public:
    explicit ChannelRange(std::uint64_t size) : size_(size) {}

    /// Adds the range of `place`, if it is one. False: it cannot be made out.
    bool add(const OrderedJson& place, std::vector<Range>& ranges) const {
        const auto buffer = whole_number(place, "buffer");
        if (!buffer) return !place.contains("buffer");
        if (*buffer != 0) return true;
        const auto begin = place.contains("byteOffset") ? whole_number(place, "byteOffset") : std::uint64_t(0),
                   length = whole_number(place, "byteLength");
        if (!begin || !length || *begin > size_ || *length > size_ - *begin) return false;
        if (*length > 0) ranges.push_back({*begin, *begin + *length});
        return true;
    }

private:
    std::uint64_t size_;
};

void unite(std::vector<Range>& ranges) {
    std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.begin < b.begin; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < ranges.size(); ++i) {
        if (ranges[i].begin <= ranges[last].end)
            ranges[last].end = std::max(ranges[last].end, ranges[i].end);
        else
            ranges[++last] = ranges[i];
    }
    if (!ranges.empty()) ranges.resize(last + 1);
}

/// What lies in `dead` alone, in pieces that begin at and are as long as multiples of 4. Both united.
std::vector<Range> removable(const std::vector<Range>& dead, const std::vector<Range>& live) {
    std::vector<Range> out;
    const auto add = [&](std::uint64_t begin, std::uint64_t end) {
        begin = (begin + 3) / 4 * 4, end = end / 4 * 4;
        if (begin < end) out.push_back({begin, end});
    };
    std::size_t l = 0;
    for (const Range& d : dead) {
        std::uint64_t at = d.begin;
        while (l < live.size() && live[l].end <= at) ++l;
        for (std::size_t i = l; i < live.size() && live[i].begin < d.end; ++i) {
            if (live[i].begin > at) add(at, live[i].begin);
            at = std::max(at, live[i].end);
        }
        if (at < d.end) add(at, d.end);
    }
    return out;
}

/// How far what begins at `offset` moves.
std::uint64_t shift_at(const std::vector<Range>& removed, const std::vector<std::uint64_t>& before,
                       std::uint64_t offset) {
    const auto after = std::upper_bound(removed.begin(), removed.end(), offset,
                                        [](std::uint64_t x, const Range& r) { return x < r.begin; });
    return before[std::size_t(after - removed.begin())];
}

void move(OrderedJson& place, const std::vector<Range>& removed, const std::vector<std::uint64_t>& before) {
    if (whole_number(place, "buffer") != 0u || !place.contains("byteOffset")) return;
    const std::uint64_t offset = *whole_number(place, "byteOffset"), shift = shift_at(removed, before, offset);
    if (shift > 0) place["byteOffset"] = offset - shift;
}

/// One byte that is there in any case.
void leave_nothing(OrderedJson& view) {
    for (const char* name : {"byteOffset", "byteStride", "extensions"}) view.erase(name);
    view["buffer"] = 0;
    view["byteLength"] = 1;
}

}  // namespace

std::uint64_t drop_dead_views(OrderedJson& tree, std::vector<std::byte>& binary) {
    const AccessorUses uses(tree);
    if (!uses.are_all_known() || !tree.contains("bufferViews") || binary.empty()) return 0;
    OrderedJson& views = tree["bufferViews"];
    const std::vector<bool> is_live = live_views(tree, uses);
    const ChannelRange range(binary.size());
    std::vector<Range> dead, live;
    for (std::size_t v = 0; v < views.size(); ++v) {
        std::vector<Range>& ranges = is_live[v] ? live : dead;
        if (!views[v].is_object() || !range.add(views[v], ranges)) return 0;
        if (views[v].contains("extensions"))
            for (const OrderedJson& extension : views[v]["extensions"])
                if (extension.is_object() && !range.add(extension, ranges)) return 0;
    }
    unite(dead), unite(live);
    const std::vector<Range> removed = removable(dead, live);
    if (removed.empty() || live.empty()) return 0;
    std::vector<std::uint64_t> before{0};  // bytes taken out before each range, and before the end
    for (const Range& r : removed) before.push_back(before.back() + (r.end - r.begin));
    for (std::size_t v = 0; v < views.size(); ++v) {
        if (!is_live[v]) {
            leave_nothing(views[v]);
            continue;
        }
        move(views[v], removed, before);
        if (views[v].contains("extensions"))
            for (OrderedJson& extension : views[v]["extensions"])
                if (extension.is_object()) move(extension, removed, before);
    }
    for (std::size_t a = 0; a < uses.accessors(); ++a) {
        OrderedJson& accessor = tree["accessors"][a];
        const auto view = whole_number(accessor, "bufferView");
        if (uses.count(a) > 0 || !view || *view >= views.size() || is_live[std::size_t(*view)]) continue;
        for (const char* name : {"bufferView", "byteOffset", "min", "max"}) accessor.erase(name);
    }
    auto to = binary.begin() + std::ptrdiff_t(removed[0].begin);
    for (std::size_t r = 0; r < removed.size(); ++r) {
        const std::uint64_t end = r + 1 < removed.size() ? removed[r + 1].begin : binary.size();
        to = std::copy(binary.begin() + std::ptrdiff_t(removed[r].end), binary.begin() + std::ptrdiff_t(end), to);
    }
    binary.erase(to, binary.end());
    return before.back();
}

}  // namespace rakelight::io::gltf
