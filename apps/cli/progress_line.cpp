// SPDX-License-Identifier: Apache-2.0
#include "progress_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace rakelight::cli {
namespace {

constexpr std::chrono::milliseconds patience{400}, pause{200};
constexpr std::size_t usual_columns = 80;

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

bool can_rewrite_lines() {
    const char* const term = std::getenv("TERM");
    return isatty(STDERR_FILENO) && term && *term && std::string_view(term) != "dumb";
}

std::size_t terminal_columns() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual_columns;
}

/// "12 s", "3 min", "2 h"
std::string duration_text(double seconds) {
    const auto [count, unit] = seconds < 100    ? std::pair(seconds, "s")
                               : seconds < 6000 ? std::pair(seconds / 60, "min")
                                                : std::pair(seconds / 3600, "h");
    char text[40];
    std::snprintf(text, sizeof text, "%.0f %s", count, unit);
    return text;
}

/// The remaining time when a share of the work took so long; empty as long as little is known.
std::string time_left(double elapsed_s, double share) {
    constexpr double least_known_s = 1, least_share = 0.01, least_said_s = 1;
    if (elapsed_s < least_known_s || share < least_share) return {};
    const double left = elapsed_s * (1 - share) / share;
    return left < least_said_s ? std::string() : "about " + duration_text(left);
}

/// At most so many characters of UTF-8.
std::string cut(const std::string& text, std::size_t columns) {
    std::size_t at = 0, count = 0;
    while (at < text.size()) {
        std::size_t next = at + 1;
        while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0) == 0x80) ++next;
        if (++count > columns) break;
        at = next;
    }
    return text.substr(0, at);
}

/// Without its folder where the whole would take half of a line.
std::string short_name(const std::string& file) {
    constexpr std::size_t most = 40;
    return one_line(file.size() > most ? std::filesystem::path(file).filename().string() : file, most);
}

}  // namespace

std::string to_text(const ProgressText& p, std::size_t columns) {
    std::string text;
    const FileCount& files = p.files;
    if (files.of > 1) text += "[" + std::to_string(files.begun) + "/" + std::to_string(files.of) + "] ";
    text += p.file + ": " + (p.stage.empty() ? "begin" : p.stage);
    const double fraction = std::clamp(p.fraction, 0.0, 1.0);
    if (fraction > 0) text += " " + std::to_string(std::lround(100 * fraction)) + " %";
    text += ", " + duration_text(p.file_s);
    if (const std::string left = time_left(p.stage_s, fraction); !left.empty()) text += ", " + left + " left";
    const double whole_files = double(files.begun) - 1;
    if (files.of > 1 && whole_files > 0)
        if (const std::string left = time_left(p.run_s - p.file_s, whole_files / double(files.of)); !left.empty())
            text += "; " + left + " for all that is left";
    return cut(text, columns);
}

ProgressLine::ProgressLine(const std::string& file, Loudness loudness, FileCount& files)
    : start_s_(now_s()), is_enabled_(loudness != Loudness::quiet && can_rewrite_lines()) {
    ++files.begun;
    if (files.start_s == 0) files.start_s = start_s_;
    text_.file = short_name(file), text_.files = files;
    stage_start_s_ = start_s_, run_start_s_ = files.start_s;
#if RL_THREADS
    if (is_enabled_) thread_ = std::thread([this] { keep_shown(); });
#endif
}

void ProgressLine::wipe() {
    {
        const std::lock_guard lock(mutex_);
        is_done_ = true;
    }
    done_.notify_all();
#if RL_THREADS
    if (thread_.joinable()) thread_.join();
#endif
    if (is_shown_) std::fputs(wipe_line, stderr);
    is_shown_ = false;
}

std::function<void(std::string_view, double)> ProgressLine::callback() {
    if (!is_enabled_) return {};
    return [this](std::string_view stage, double fraction) { note(stage, fraction); };
}

void ProgressLine::note(std::string_view stage, double fraction) {
    const std::lock_guard lock(mutex_);
    const bool is_anew = stage != text_.stage || fraction == 0;
    if (is_anew) text_.stage = stage, text_.fraction = 0, stage_start_s_ = now_s();
    text_.fraction = std::max(text_.fraction, fraction);  // threads may report out of order
}

void ProgressLine::keep_shown() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);  // signals are for the thread that works
    std::unique_lock lock(mutex_);
    for (auto wait = patience; !done_.wait_for(lock, wait, [this] { return is_done_; }); wait = pause) show(lock);
}

void ProgressLine::show(std::unique_lock<std::mutex>& lock) {
    const double now = now_s();
    text_.file_s = now - start_s_, text_.stage_s = now - stage_start_s_, text_.run_s = now - run_start_s_;
    const std::size_t columns = terminal_columns();
    const std::string line = wipe_line + to_text(text_, columns > 1 ? columns - 1 : columns);
    is_shown_ = true;
    lock.unlock();  // a terminal that was stopped holds up nobody but this thread
    std::fwrite(line.data(), 1, line.size(), stderr);
    std::fflush(stderr);
    lock.lock();
}

}  // namespace rakelight::cli
