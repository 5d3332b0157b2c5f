// SPDX-License-Identifier: Apache-2.0
// What a run changed, guessed, dropped or warns about. It is part of the result; the library never prints it.
#pragma once
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <rakelight/base/export.h>

namespace rakelight {

/// The kind of a remark. `changed`, `guessed` and `dropped` are about the model's data. The programs print notes only
/// with --verbose, and all other remarks always.
enum class Remark { note, changed, guessed, dropped, warning };

/// The name of a remark in JSON: "note", "changed", "guessed", "dropped", "warning".
RL_API const char* name_of(Remark remark) noexcept;

/// One remark, as it was first made.
struct ReportEntry {
    Remark remark = Remark::note;
    std::string file{};       ///< as the caller named it; may be empty
    std::string place{};      ///< place of the first occurrence: "mesh 3 'body'", "line 12"
    std::string message{};    ///< one sentence without a full stop
    std::uint64_t count = 1;  ///< number of equal remarks
    /// Settings that `message` quotes, as keys of [render] in world files: "normal-map-green".
    std::vector<std::string> settings{};
};

/// Collects remarks. Thread-safe. Two remarks are equal if kind, file and message are equal. Equal remarks are stored
/// once and counted. At most 1000 distinct notes and 1000 other remarks are stored, so that a hostile file cannot fill
/// the memory with warnings. Further remarks are only counted. Entries are in the order of their first occurrence.
class RL_API Report {
public:
    /// Adds a remark, or counts it if an equal one is stored.
    void add(Remark remark, std::string file, std::string place, std::string message,
             std::vector<std::string> settings = {});
    /// A copy of the remarks so far.
    std::vector<ReportEntry> entries() const;
    std::uint64_t left_out() const;        ///< number of remarks that were not stored
    std::uint64_t notes_left_out() const;  ///< number of notes that were not stored
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
