// SPDX-License-Identifier: Apache-2.0
#include "settings_file.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

struct Flag {
    const char* key;
    bool UiState::*field;
};
constexpr Flag flags[] = {{"dark", &UiState::is_dark},        {"arcball", &UiState::is_arcball},
                          {"grid", &UiState::grid},           {"axes", &UiState::axes},
                          {"file-name", &UiState::file_name}, {"frame-time", &UiState::frame_time},
                          {"announce", &UiState::announces},  {"blender-mouse", &UiState::has_blender_mouse}};

int number_in(const std::string& text, int low, int high, int otherwise) {
    int value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() && value >= low && value <= high ? value
                                                                                                     : otherwise;
}

void take(Remembered& to, const std::string& key, const std::string& value) {
    for (const Flag& flag : flags)
        if (key == flag.key && (value == "on" || value == "off")) to.ui.*flag.field = value == "on";
    if (key == "width") to.width = number_in(value, 64, 16384, to.width);
    if (key == "height") to.height = number_in(value, 64, 16384, to.height);
    if (key == "panel-width") to.ui.panel_column = float(number_in(value, 0, 16384, int(to.ui.panel_column)));
    if (key.starts_with("key ")) {
        auto own = own_key(key.substr(4), value);
        own ? to.own_keys.push_back(std::move(*own)) : to.wrong_lines.push_back(key + " = " + value);
    }
    if (key == "record-frames") to.ui.record_frames = number_in(value, 1, 10000, to.ui.record_frames);
    for (std::size_t i = 0; i < panel_count; ++i)
        if (key == std::string("panel-") + panel_titles[i]) to.ui.open[i] = value == "on";
}

struct Line {
    std::string key, value;  ///< key empty: it is none of "key = value"
};

Line line_of(std::string text) {
    text.erase(text.find_last_not_of(" \t\r") + 1);
    const std::size_t at = text.rfind(" = ");
    return at == std::string::npos ? Line{} : Line{text.substr(0, at), text.substr(at + 3)};
}

std::vector<Line> lines_of(const Remembered& remembered) {
    std::vector<Line> lines;
    for (const Flag& flag : flags) lines.push_back({flag.key, remembered.ui.*flag.field ? "on" : "off"});
    lines.push_back({"width", std::to_string(remembered.width)});
    lines.push_back({"height", std::to_string(remembered.height)});
    lines.push_back({"panel-width", std::to_string(int(remembered.ui.panel_column))});
    lines.push_back({"record-frames", std::to_string(remembered.ui.record_frames)});
    for (std::size_t i = 0; i < panel_count; ++i)
        lines.push_back({std::string("panel-") + panel_titles[i], remembered.ui.open[i] ? "on" : "off"});
    return lines;
}

/// Empty where there is no file; none: it cannot be read whole.
std::optional<std::string> text_of(const fs::path& path) {
    constexpr std::uintmax_t most_bytes = 65536;
    std::error_code fault;
    if (!fs::exists(path, fault)) return fault ? std::nullopt : std::optional<std::string>("");
    if (!fs::is_regular_file(path, fault) || fs::file_size(path, fault) > most_bytes) return {};
    std::ifstream file(path, std::ios::binary);
    if (!file) return {};
    return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

std::string settings_path() {
    const char* const config = std::getenv("XDG_CONFIG_HOME");
    const char* const home = std::getenv("HOME");
    if (config && fs::path(config).is_absolute()) return (fs::path(config) / "rakelight" / "view.conf").string();
    if (home && *home) return (fs::path(home) / ".config" / "rakelight" / "view.conf").string();
    return {};
}

Remembered parse_settings(const std::string& text) {
    Remembered out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (const Line l = line_of(line); !l.key.empty()) take(out, l.key, l.value);
    return out;
}

std::string settings_text(const Remembered& remembered, const std::string& before) {
    const std::vector<Line> all = lines_of(remembered);
    std::vector<Line> rest = all;
    std::string text;
    const auto put = [&text](const Line& line) { text += line.key + " = " + line.value + "\n"; };
    std::istringstream lines(before);
    for (std::string line; std::getline(lines, line);) {
        const std::string key = line_of(line).key;
        const auto known = std::ranges::find(rest, key, &Line::key);
        if (known != rest.end())
            put(*known), rest.erase(known);
        else if (std::ranges::find(all, key, &Line::key) == all.end())  // else it stood there twice
            text += line + "\n";
    }
    std::ranges::for_each(rest, put);
    return text;
}

Remembered read_settings() { return parse_settings(text_of(settings_path()).value_or("")); }

void write_settings(const Remembered& remembered) noexcept try {
    if (settings_path().empty()) return;
    fs::path path = settings_path();
    fs::create_directories(path.parent_path());
    if (fs::is_symlink(path)) path = fs::weakly_canonical(path);
    const std::optional<std::string> before = text_of(path);
    if (!before) return;
    const fs::path part = path.string() + ".part";
    {
        std::ofstream file(part);
        file << settings_text(remembered, *before);
        if (!file.flush()) return;
    }
    fs::rename(part, path);
} catch (const std::exception&) {  // the viewer works without
}

}  // namespace rakelight::viewer
