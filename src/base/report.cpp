// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/report.h>

namespace rakelight {
namespace {
constexpr std::size_t max_entries = 1000;
}

const char* name_of(Remark remark) noexcept {
    switch (remark) {
        case Remark::note:
            return "note";
        case Remark::changed:
            return "changed";
        case Remark::guessed:
            return "guessed";
        case Remark::dropped:
            return "dropped";
        case Remark::warning:
            return "warning";
    }
    return "note";
}

void Report::add(Remark remark, std::string file, std::string place, std::string message,
                 std::vector<std::string> settings) {
    std::string key = std::to_string(int(remark)) + file;
    key += '\0';  // no name holds one
    key += message;
    const std::lock_guard lock(mutex_);
    if (const auto known = known_.find(key); known != known_.end()) {
        ++entries_[known->second].count;
    } else if ((remark == Remark::note ? notes_ : entries_.size() - notes_) >= max_entries) {
        ++left_out_;
        notes_left_out_ += remark == Remark::note;
    } else {
        known_.emplace(std::move(key), entries_.size());
        notes_ += remark == Remark::note;
        entries_.push_back({remark, std::move(file), std::move(place), std::move(message), 1, std::move(settings)});
    }
}

std::vector<ReportEntry> Report::entries() const {
    const std::lock_guard lock(mutex_);
    return entries_;
}

std::uint64_t Report::left_out() const {
    const std::lock_guard lock(mutex_);
    return left_out_;
}

std::uint64_t Report::notes_left_out() const {
    const std::lock_guard lock(mutex_);
    return notes_left_out_;
}

void Report::clear() {
    const std::lock_guard lock(mutex_);
    entries_.clear();
    known_.clear();
    notes_ = 0;
    left_out_ = notes_left_out_ = 0;
}

}  // namespace rakelight
