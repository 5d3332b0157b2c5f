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

bool take_number(int& to, const std::string& text, int low, int high) {
    int value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || end != text.data() + text.size() || value < low || value > high) return false;
    to = value;
    return true;
}

bool take_flag(bool& to, const std::string& value) {
    if (value != "on" && value != "off") return false;
    to = value == "on";
    return true;
}

/// False: it is not understood.
bool take(Remembered& to, const std::string& key, const std::string& value) {
    for (const Flag& flag : flags)
        if (key == flag.key) return take_flag(to.ui.*flag.field, value);
    for (std::size_t i = 0; i < panel_count; ++i)
        if (key == std::string("panel-") + panel_titles[i]) return take_flag(to.ui.open[i], value);
    if (key == "width") return take_number(to.width, value, 64, 16384);
    if (key == "height") return take_number(to.height, value, 64, 16384);
    if (key == "record-frames") return take_number(to.ui.record_frames, value, 1, 10000);
    if (key == "panel-width") {
        int width = 0;
        const bool is_number = take_number(width, value, 0, 16384);
        if (is_number) to.ui.panel_column = float(width);
        return is_number;
    }
    if (!key.starts_with("key ")) return false;
    const std::optional<OwnKey> own = own_key(key.substr(4), value);
    if (own) to.own_keys.push_back(*own);
    return own.has_value();
}

struct KeyValue {
    std::string key, value;  ///< key empty: it is none of "key = value"
};

KeyValue line_of(std::string text) {
    text.erase(text.find_last_not_of(" \t\r") + 1);
    const std::size_t at = text.rfind(" = ");
    return at == std::string::npos ? KeyValue{} : KeyValue{text.substr(0, at), text.substr(at + 3)};
}

std::vector<KeyValue> lines_of(const Remembered& remembered) {
    std::vector<KeyValue> lines;
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
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') continue;
        if (const KeyValue l = line_of(line); l.key.empty() || !take(out, l.key, l.value))
            out.wrong_lines.push_back("line " + std::to_string(number) + ": " + one_line(line, 80));
    }
    return out;
}

std::string settings_text(const Remembered& remembered, const std::string& before) {
    const std::vector<KeyValue> all = lines_of(remembered);
    std::vector<KeyValue> rest = all;
    std::string text;
    const auto put = [&text](const KeyValue& line) { text += line.key + " = " + line.value + "\n"; };
    std::istringstream lines(before);
    for (std::string line; std::getline(lines, line);) {
        const std::string key = line_of(line).key;
        const auto known = std::ranges::find(rest, key, &KeyValue::key);
        if (known != rest.end())
            put(*known), rest.erase(known);
        else if (std::ranges::find(all, key, &KeyValue::key) == all.end())  // else it stood there twice
            text += line + "\n";
    }
    std::ranges::for_each(rest, put);
    return text;
}

Remembered read_settings() { return parse_settings(text_of(settings_path()).value_or("")); }

std::string wrong_lines_text(const Remembered& remembered) {
    std::string text = settings_path() + " has lines that are not understood:";
    for (std::size_t i = 0; i < std::min<std::size_t>(5, remembered.wrong_lines.size()); ++i)
        text += "\n" + remembered.wrong_lines[i];
    return text;
}

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
