// SPDX-License-Identifier: Apache-2.0
#include "frames.h"

#include <cmath>
#include <utility>

#include "arrays.h"

namespace rakelight::python {
namespace {

/// Codes with R in the low byte as rows of RGB, or of RGBA.
py::array image_of(const std::vector<std::uint32_t>& codes, int width, int height, bool has_alpha) {
    const std::size_t channels = has_alpha ? 4 : 3;
    std::vector<std::uint8_t> bytes(codes.size() * channels);
    for (std::size_t i = 0; i < codes.size(); ++i)
        for (std::size_t c = 0; c < channels; ++c) bytes[i * channels + c] = std::uint8_t(codes[i] >> (8 * c));
    return take(std::move(bytes), {height, width, py::ssize_t(channels)});
}

/// Pixels from the camera's axes: x to the right, y down, z ahead. Rows first.
py::object intrinsics_of(const Camera& camera, const Frame& frame) {
    if (camera.projection != Projection::perspective) return py::none();
    const double fy = frame.height / 2.0 / std::tan(camera.vertical_fov_rad / 2);
    const double fx = camera.horizontal_fov_rad ? frame.width / 2.0 / std::tan(*camera.horizontal_fov_rad / 2) : fy;
    const double cx = frame.width / 2.0 - frame.window.x, cy = frame.height / 2.0 - frame.window.y;
    return take(std::vector<double>{fx, 0, cx, 0, fy, cy, 0, 0, 1}, {3, 3});
}

py::dict camera_of(const Camera& camera, const Frame& frame) {
    py::dict out;
    out["to_world"] = array_of_matrix(camera.to_world);
    out["intrinsics"] = intrinsics_of(camera, frame);
    out["near"] = camera.z_near;
    out["far"] = camera.z_far;
    return out;
}

}  // namespace

py::dict arrays_of(Drawn drawn, bool has_image, bool has_color) {
    Frame& f = drawn.frame;
    const int width = f.window.width, height = f.window.height;
    py::dict out;
    const auto put = [&](const char* name, auto& values) {
        if (!values.empty()) out[name] = take(std::move(values), {height, width});
    };
    if (has_image) out["image"] = image_of(drawn.codes, width, height, drawn.has_alpha);
    if (has_color) put("color", drawn.linear ? drawn.linear->color : f.color);
    put("depth", f.depth), put("normal", f.normal), put("object", f.object), put("material", f.material);
    put("mesh", f.mesh), put("triangle", f.triangle), put("face_normal", f.face_normal), put("tangent", f.tangent);
    put("position", f.position), put("barycentric", f.barycentric), put("uv", f.uv), put("uv1", f.uv1);
    put("overdraw", f.overdraw), put("base_color", f.base_color), put("ambient", f.ambient);
    put("diffuse", f.diffuse), put("specular", f.specular), put("emission", f.emission), put("albedo", f.albedo);
    put("direct", f.direct), put("indirect", f.indirect), put("variance", f.variance);
    put("ambient_occlusion", f.ambient_occlusion);
    out["camera"] = camera_of(drawn.camera, f);
    return out;
}

}  // namespace rakelight::python
