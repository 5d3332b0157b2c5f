// SPDX-License-Identifier: Apache-2.0
#include "io/import/collada_cameras.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "io/import/xml_events.h"
#include "math/functions.h"

namespace rakelight::io {
namespace {

std::optional<double> number(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return std::nullopt;
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data() + begin, text.data() + text.size(), value);
    return problem == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Keeps what a file says of cameras and of the nodes that place them.
struct Walk final : XmlHandler {
    struct Place {
        std::string node_id, node_name, camera_id;
    };
    std::map<std::string, ColladaOptics> optics;  ///< by the camera's id
    std::vector<Place> placed;

    void start(std::string_view element, const XmlAttributes& attributes) override {
        content_.clear();
        if (element == "camera") {
            camera_ = attributes["id"];
        } else if (element == "node") {
            nodes_.push_back({std::string(attributes["id"]), std::string(attributes["name"]), {}});
        } else if (element == "instance_camera" && !nodes_.empty() && attributes["url"].starts_with('#')) {
            placed.push_back(nodes_.back());
            placed.back().camera_id = attributes["url"].substr(1);
        }
    }
    void text(std::string_view part, std::uint64_t) override {
        if (!camera_.empty() && content_.size() < 100) content_ += part;
    }
    void end(std::string_view element) override {
        if (element == "camera") camera_.clear();
        if (element == "node") nodes_.pop_back();
        if (!camera_.empty()) value(element);
        content_.clear();
    }

private:
    void value(std::string_view element) {
        ColladaOptics& o = optics[camera_];
        constexpr std::pair<std::string_view, std::optional<double> ColladaOptics::*> values[] = {
            {"xfov", &ColladaOptics::xfov_deg},
            {"yfov", &ColladaOptics::yfov_deg},
            {"aspect_ratio", &ColladaOptics::aspect},
            {"znear", &ColladaOptics::znear},
            {"zfar", &ColladaOptics::zfar},
            {"xmag", &ColladaOptics::xmag},
            {"ymag", &ColladaOptics::ymag}};
        for (const auto& [name, where] : values)
            if (element == name) o.*where = number(content_);
    }

    std::string camera_, content_;  ///< the camera that is open; the text of the innermost element
    std::vector<Place> nodes_;      ///< open ones
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

std::map<std::string, ColladaOptics> collada_cameras(std::span<const std::byte> bytes) {
    Walk walk;
    read_xml(bytes, walk);
    std::map<std::string, ColladaOptics> result;
    for (const Walk::Place& place : walk.placed) {
        const auto found = walk.optics.find(place.camera_id);
        if (found == walk.optics.end()) continue;
        if (!place.node_name.empty()) result.emplace(place.node_name, found->second);
        if (!place.node_id.empty())
            result.insert_or_assign(place.node_id, found->second);  // ids are unique, names need not be
    }
    return result;
}

void complete_views(const std::map<std::string, ColladaOptics>& cameras, std::vector<import_stream::View>& views) {
    for (import_stream::View& view : views)
        if (const auto found = cameras.find(view.name); found != cameras.end()) complete(found->second, view);
}

}  // namespace rakelight::io
