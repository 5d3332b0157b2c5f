// SPDX-License-Identifier: Apache-2.0
// What a run changed, guessed, dropped or warns about. It is part of the result; the library never prints it.
#pragma once
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <rakelight/export.h>

namespace rakelight {

/// The kind of a remark. `changed`, `guessed` and `dropped` are about the model's data. Programs print these and
/// `warning` always, and `note` only when asked (--verbose).
enum class Remark { note, changed, guessed, dropped, warning };

/// The name of a remark in JSON: "note", "changed", "guessed", "dropped", "warning".
RL_API const char* name_of(Remark remark) noexcept;

/// One remark, as it was first made.
struct ReportEntry {
    Remark remark = Remark::note;
    std::string file{};       ///< as the caller named it; may be empty
    std::string place{};      ///< "mesh 3 'body'", "line 12"; that of the first occurrence
    std::string message{};    ///< one sentence without a full stop
    std::uint64_t count = 1;  ///< how often the same remark was made for the same file
    /// Settings that `message` quotes, as keys of [render] in world files: "normal-map-green".
    std::vector<std::string> settings{};
};

/// Collects remarks. Thread-safe. Equal remarks (kind, file, message) are stored once and counted. At most 1000
/// distinct notes and 1000 others are kept and the rest only counted, so a hostile file cannot fill memory with
/// warnings. Entries are in the order of their first occurrence.
class RL_API Report {
public:
    /// Adds a remark, or counts it if an equal one is stored.
    void add(Remark remark, std::string file, std::string place, std::string message,
             std::vector<std::string> settings = {});
    /// A copy of the remarks so far.
    std::vector<ReportEntry> entries() const;
    std::uint64_t left_out() const;        ///< remarks beyond the first 1000 distinct ones of notes, and of others
    std::uint64_t notes_left_out() const;  ///< the notes among left_out()
    /// Removes all remarks.
    void clear();

private:
    mutable std::mutex mutex_;
    std::vector<ReportEntry> entries_;
    /// Kind, file and message -> place in entries_. Ordered: files choose the texts and could make all hashes equal.
    std::map<std::string, std::size_t> known_;
    std::size_t notes_ = 0;  ///< among entries_
    std::uint64_t left_out_ = 0, notes_left_out_ = 0;
};

}  // namespace rakelight
