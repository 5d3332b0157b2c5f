// SPDX-License-Identifier: Apache-2.0
// Progress on a terminal: one line that is rewritten, and wiped when the work is done.
#pragma once
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "console.h"

namespace rakelight::cli {

/// The state that the progress lines of one run share.
struct FileCount {
    std::size_t of = 1;     ///< files that there are to work on
    std::size_t begun = 0;  ///< with the one that is worked on
    double start_s = 0;     ///< when the first began; 0: none has
};

/// The content of a progress line: which file of how many, the stage and how much of it is done, the time so far and
/// the likely remaining time.
struct ProgressText {
    std::string file{}, stage{};
    double fraction = 0;                        ///< of the stage, 0..1; 0: not known
    double file_s = 0, stage_s = 0, run_s = 0;  ///< since each began
    FileCount files{};
};
/// "[3/12] helmet.glb: render 45 %, 4 s, about 5 s left; about 2 min for all", cut to `columns` characters.
std::string to_text(const ProgressText& progress, std::size_t columns);

/// A progress line for a terminal; nothing when standard error is none, when it cannot be rewritten (TERM=dumb), or with --quiet. It
/// appears within the first second and is kept by a thread of its own, so that stages that report nothing are seen too. It has no colors.
class ProgressLine {
public:
    /// @param files  is counted up; must outlive it
    ProgressLine(const std::string& file, Loudness loudness, FileCount& files);
    ~ProgressLine() { wipe(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    /// For ContextOptions::progress; empty when there is nothing to show.
    std::function<void(std::string_view, double)> callback();
    /// Before anything else is written to the terminal. The line does not come back.
    void wipe();

private:
    void note(std::string_view stage, double fraction);
    void keep_shown();
    void show(std::unique_lock<std::mutex>& lock);

    ProgressText text_;
    double start_s_ = 0, stage_start_s_ = 0, run_start_s_ = 0;
    bool is_enabled_ = false, is_shown_ = false, is_done_ = false;
    std::mutex mutex_;
    std::condition_variable done_;
#if RL_THREADS
    std::thread thread_;
#endif
};

}  // namespace rakelight::cli
