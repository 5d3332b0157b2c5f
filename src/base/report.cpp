// SPDX-License-Identifier: Apache-2.0
#include <rakelight/report.h>

namespace rakelight {
namespace {
constexpr std::size_t max_entries = 1000;
}

const char* name_of(Remark remark) noexcept {
    switch (remark) {
        case Remark::note: return "note";
        case Remark::changed: return "changed";
        case Remark::guessed: return "guessed";
        case Remark::dropped: return "dropped";
        case Remark::warning: return "warning";
    }
    return "note";
}

void Report::add(Remark remark, std::string file, std::string place, std::string message) {
    const std::lock_guard lock(mutex_);
    for (ReportEntry& e : entries_)
        if (e.remark == remark && e.message == message && e.file == file) {
            ++e.count;
            return;
        }
    if (entries_.size() >= max_entries)
        ++left_out_;
    else
        entries_.push_back({remark, std::move(file), std::move(place), std::move(message), 1});
}

std::vector<ReportEntry> Report::entries() const {
    const std::lock_guard lock(mutex_);
    return entries_;
}

std::uint64_t Report::left_out() const {
    const std::lock_guard lock(mutex_);
    return left_out_;
}

void Report::clear() {
    const std::lock_guard lock(mutex_);
    entries_.clear();
    left_out_ = 0;
}

}  // namespace rakelight
