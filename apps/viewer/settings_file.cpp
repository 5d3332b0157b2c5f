// SPDX-License-Identifier: Apache-2.0
#include "settings_file.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
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
    if (key.starts_with("key "))
        if (auto own = own_key(key.substr(4), value)) to.own_keys.push_back(std::move(*own));
    if (key == "record-frames") to.ui.record_frames = number_in(value, 1, 10000, to.ui.record_frames);
    for (std::size_t i = 0; i < panel_count; ++i)
        if (key == std::string("panel-") + panel_titles[i]) to.ui.open[i] = value == "on";
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
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(" = ");
        if (at != std::string::npos) take(out, line.substr(0, at), line.substr(at + 3));
    }
    return out;
}

std::string settings_text(const Remembered& remembered) {
    std::string text;
    const auto put = [&text](const std::string& key, const std::string& value) { text += key + " = " + value + "\n"; };
    for (const Flag& flag : flags) put(flag.key, remembered.ui.*flag.field ? "on" : "off");
    put("width", std::to_string(remembered.width));
    put("height", std::to_string(remembered.height));
    put("panel-width", std::to_string(int(remembered.ui.panel_column)));
    put("record-frames", std::to_string(remembered.ui.record_frames));
    for (std::size_t i = 0; i < panel_count; ++i)
        put(std::string("panel-") + panel_titles[i], remembered.ui.open[i] ? "on" : "off");
    for (const OwnKey& own : remembered.own_keys) put("key " + own.keys, own.usual);
    return text;
}

Remembered read_settings() {
    std::ifstream file(settings_path());
    std::string text(65536, '\0');
    file.read(text.data(), std::streamsize(text.size()));
    text.resize(std::size_t(std::max<std::streamsize>(file.gcount(), 0)));
    return parse_settings(text);
}

void write_settings(const Remembered& remembered) noexcept try {
    const fs::path path = settings_path();
    if (path.empty()) return;
    fs::create_directories(path.parent_path());
    const fs::path part = path.string() + ".part";
    {
        std::ofstream file(part);
        file << settings_text(remembered);
        if (!file.flush()) return;
    }
    fs::rename(part, path);
} catch (const std::exception&) {  // the viewer works without
}

}  // namespace rakelight::viewer
