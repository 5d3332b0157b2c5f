// SPDX-License-Identifier: Apache-2.0
#include "io/import/collada_cameras.h"

#include <charconv>
#include <cmath>

#include "math/functions.h"

namespace rakelight::io {
namespace {

/// The value of an attribute of a tag, empty when it has none.
std::string attribute(std::string_view tag, std::string_view name) {
    for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
        const std::size_t equals = at + name.size();
        const bool whole =
            at > 0 && (tag[at - 1] == ' ' || tag[at - 1] == '\t' || tag[at - 1] == '\n' || tag[at - 1] == '\r');
        if (!whole || equals + 1 >= tag.size() || tag[equals] != '=') continue;
        const char quote = tag[equals + 1];
        const std::size_t end = tag.find(quote, equals + 2);
        if ((quote == '"' || quote == '\'') && end != std::string_view::npos)
            return std::string(tag.substr(equals + 2, end - equals - 2));
    }
    return {};
}

std::optional<double> number(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return std::nullopt;
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data() + begin, text.data() + text.size(), value);
    return problem == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Walks over the tags of a text and keeps what it says of cameras and of the nodes that place them.
struct Walk {
    std::map<std::string, ColladaOptics> optics;                                      ///< by the camera's id
    std::vector<std::pair<std::string, std::string>> nodes;                           ///< open ones: id, name
    std::vector<std::pair<std::pair<std::string, std::string>, std::string>> placed;  ///< node, camera's id
    std::string camera;                                                               ///< the one that is open

    void value(std::string_view element, std::string_view text) {
        ColladaOptics& o = optics[camera];
        if (element == "xfov") o.xfov_deg = number(text);
        if (element == "yfov") o.yfov_deg = number(text);
        if (element == "aspect_ratio") o.aspect = number(text);
        if (element == "znear") o.znear = number(text);
        if (element == "zfar") o.zfar = number(text);
        if (element == "xmag") o.xmag = number(text);
        if (element == "ymag") o.ymag = number(text);
    }
    void tag(std::string_view element, std::string_view tag, std::string_view text) {
        if (element == "camera")
            camera = attribute(tag, "id");
        else if (element == "/camera")
            camera.clear();
        else if (element == "node" && !tag.ends_with("/>"))
            nodes.push_back({attribute(tag, "id"), attribute(tag, "name")});
        else if (element == "/node" && !nodes.empty())
            nodes.pop_back();
        else if (element == "instance_camera" && !nodes.empty()) {
            const std::string url = attribute(tag, "url");
            if (url.starts_with('#')) placed.push_back({nodes.back(), url.substr(1)});
        } else if (!camera.empty())
            value(element, text);
    }
};

bool is_angle(const std::optional<double>& degrees) { return degrees && *degrees > 0.1 && *degrees < 179.9; }

double tangent_of_half(double degrees) { return math::tan(radians(degrees) / 2); }

void complete(const ColladaOptics& o, import_stream::View& view) {
    const bool has_x = is_angle(o.xfov_deg), has_y = is_angle(o.yfov_deg);
    if (o.aspect && *o.aspect > 0) view.aspect = *o.aspect;
    if (has_x && has_y) view.aspect = tangent_of_half(*o.xfov_deg) / tangent_of_half(*o.yfov_deg);
    const double aspect = view.aspect > 0 ? view.aspect : 4.0 / 3.0;  // as where views become cameras
    if (has_x)
        view.horizontal_fov_rad = radians(*o.xfov_deg);
    else if (has_y)
        view.horizontal_fov_rad = 2 * math::atan2(tangent_of_half(*o.yfov_deg) * aspect, 1);
    if (o.xmag)
        view.half_width = *o.xmag;
    else if (o.ymag)
        view.half_width = *o.ymag * aspect;
    if (o.znear) view.z_near = *o.znear;
    if (o.zfar) view.z_far = *o.zfar;
}

}  // namespace

std::map<std::string, ColladaOptics> collada_cameras(std::string_view text) {
    Walk walk;
    for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
        if (text.substr(at).starts_with("<!--")) {
            at = text.find("-->", at);
            if (at == std::string_view::npos) break;
            continue;
        }
        const std::size_t end = text.find('>', at);
        if (end == std::string_view::npos) break;
        const std::string_view tag = text.substr(at, end + 1 - at);
        const std::string_view element = tag.substr(1, tag.find_first_of(" \t\r\n>", 1) - 1);
        const std::size_t next = std::min(text.find('<', end), text.size());
        walk.tag(element.ends_with('/') && element.size() > 1 ? element.substr(0, element.size() - 1) : element, tag,
                 text.substr(end + 1, next - end - 1));
    }
    std::map<std::string, ColladaOptics> result;
    for (const auto& [node, camera] : walk.placed) {
        const auto found = walk.optics.find(camera);
        if (found == walk.optics.end()) continue;
        if (!node.second.empty()) result.emplace(node.second, found->second);
        if (!node.first.empty())
            result.insert_or_assign(node.first, found->second);  // ids are unique, names need not be
    }
    return result;
}

void complete_views(const std::map<std::string, ColladaOptics>& cameras, std::vector<import_stream::View>& views) {
    for (import_stream::View& view : views)
        if (const auto found = cameras.find(view.name); found != cameras.end()) complete(found->second, view);
}

}  // namespace rakelight::io
