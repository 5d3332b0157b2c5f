// SPDX-License-Identifier: Apache-2.0
#include "console.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <rakelight/io/world.h>
#include <rakelight_internal/base/file_ending.h>

namespace rakelight::cli {
namespace {

constexpr std::size_t max_lines = 20;  ///< warnings a file
constexpr std::size_t max_text = 600;  ///< bytes of a message

bool has_colors() {
    static const bool answer = [] {
        const char* no_color = std::getenv("NO_COLOR");  // https://no-color.org: present and not empty
        const char* term = std::getenv("TERM");
        return isatty(STDERR_FILENO) && !(no_color && *no_color) && term && std::string_view(term) != "dumb";
    }();
    return answer;
}

std::string line_of(const char* kind, const char* color, const std::string& text) {
    std::string line = "rakelight: ";
    if (*kind) line += has_colors() ? std::string(color) + kind + ":\033[0m " : std::string(kind) + ": ";
    return line + text + "\n";
}

/// One write a line, so that lines of several processes do not mix.
void print_line(const char* kind, const char* color, const std::string& text) {
    const std::string line = line_of(kind, color, text);
    std::fwrite(line.data(), 1, line.size(), stderr);
}

void print_remark(bool is_note, const std::string& text) {
    if (is_note)
        print_line("note", "\033[36m", text);
    else
        print_line("warning", "\033[33m", text);
}

/// "SIZE": options have small letters.
bool is_positional(const std::string& name) { return name[0] >= 'A' && name[0] <= 'Z'; }

std::string text_of(const ReportEntry& r) {
    std::string text;
    if (!r.file.empty()) text += one_line(r.file) + ": ";
    if (!r.place.empty() && r.place != r.file) text += one_line(r.place, 120) + ": ";
    text += with_options(one_line(r.message, max_text), r.settings);
    if (r.count > 1) text += " (" + std::to_string(r.count) + " times)";
    return text;
}

/// The order if not all are shown: first what the world file or the command line asks for and does not get, then what
/// was lost, then the rest. Each group keeps its order.
void most_important_first(std::vector<ReportEntry>& remarks) {
    const auto rank = [](const ReportEntry& r) {
        const bool is_asked = is_world_file(r.file) || r.file.empty();
        return is_asked ? 0 : r.remark == Remark::dropped ? 1 : 2;
    };
    std::stable_sort(remarks.begin(), remarks.end(),
                     [&](const ReportEntry& a, const ReportEntry& b) { return rank(a) < rank(b); });
}

}  // namespace

std::string with_options(std::string text, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings)
        for (std::size_t at; (at = text.find("'" + setting + "'")) != text.npos;)
            text.replace(at, setting.size() + 2, "--" + setting);
    return text;
}

std::string text_of(const Error& error) {
    if (error.code() == ErrorCode::bad_file && file_ending(error.file()) == "toml")
        return with_options(error.what(),
                            {"allow-outside", "allow-shaders"});  // else its keys, of a world or a configuration
    const std::string setting =
        error.setting().empty() || is_positional(error.setting()) ? error.setting() : "--" + error.setting();
    const auto named = [&](const std::string& text) { return with_options(text, error.related()); };
    return Error(error.code(), named(error.reason()), error.place(), named(error.advice()))
        .about(setting)
        .with_file(error.file())
        .what();
}

void print_error(const Error& error) { print_line("error", "\033[31m", text_of(error)); }

std::string error_line(const Error& error) {
    return (isatty(STDERR_FILENO) ? wipe_line : "") + line_of("error", "\033[31m", text_of(error));
}

std::string cancelled_line(const std::string& file) {
    return error_line(Error(ErrorCode::failed, "cancelled").with_file(file));
}

void print_remarks(const Report& report, Loudness loudness) {
    if (loudness == Loudness::quiet) return;
    std::vector<ReportEntry> remarks = report.entries();
    const bool is_verbose = loudness == Loudness::verbose;
    if (!is_verbose) most_important_first(remarks);
    std::uint64_t lines = 0, notes = report.notes_left_out(), warnings = report.left_out() - notes;
    for (const ReportEntry& r : remarks) {
        const bool is_note = r.remark == Remark::note;
        if (is_note && !is_verbose) continue;
        if (++lines > max_lines && !is_verbose)
            ++warnings;
        else
            print_remark(is_note, text_of(r));
    }
    const std::string file =
        remarks.empty() || remarks.front().file.empty() ? "" : one_line(remarks.front().file) + ": ";
    if (warnings)
        print_remark(false, file + "... " + std::to_string(warnings) + " more, see " +
                                (is_verbose ? "" : "--verbose or ") + "--json");
    if (notes && is_verbose) print_remark(true, file + "... " + std::to_string(notes) + " more notes were left out");
}

void print_note(const std::string& text, Loudness loudness) {
    if (loudness == Loudness::verbose) print_line("", "", one_line(text, max_text));
}

void print_message(const std::string& text, Loudness loudness) {
    if (loudness != Loudness::quiet) print_line("", "", one_line(text, max_text));
}

std::string summary(const PictureResult& r) {
    char text[400];
    std::snprintf(text, sizeof text,
                  ": %d x %d pixels, %llu objects, %llu triangles; load %.1f, prepare %.1f, render %.1f, write %.1f ms "
                  "(%s, %s, %d threads)",
                  r.width, r.height, static_cast<unsigned long long>(r.objects),
                  static_cast<unsigned long long>(r.triangles), r.load_ms, r.prepare_ms, r.render_ms, r.write_ms,
                  r.engine.c_str(), r.isa.c_str(), r.threads);
    return one_line(r.output) + text;
}

void print_data(const std::string& text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0) throw Error(ErrorCode::failed, "cannot write to standard output");
}

void print_text(const std::string& text) {
    std::string safe;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at), size = (end == text.npos ? text.size() : end) - at;
        safe += one_line(text.substr(at, size), size);
        if (end != text.npos) safe += '\n';
        at += size + 1;
    }
    print_data(safe);
}

}  // namespace rakelight::cli
