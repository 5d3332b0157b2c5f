// SPDX-License-Identifier: Apache-2.0
// Shared parts of validate(): a place in the scene that throws errors, and the checks of arrays.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include <rakelight/scene/scene.h>

#include "base/enumerators.h"

namespace rakelight {

/// An element of a scene, for messages: "mesh 3 'body'".
struct Place {
    const char* kind;
    std::size_t number;
    const std::string& name;

    std::string text() const;
    /// @throws Error bad_file, always
    [[noreturn]] void fail(const std::string& reason) const;
    void index(const char* what, std::uint32_t value, std::size_t count) const;          ///< value < count
    void index_or_none(const char* what, std::uint32_t value, std::size_t count) const;  ///< value < count or `none`
    void size(const char* what, std::size_t is, std::size_t wanted, const char* unit) const;           ///< is == wanted
    void size_or_empty(const char* what, std::size_t is, std::size_t wanted, const char* unit) const;  ///< or 0
    void finite(const char* what, double value) const;
    void finite(const char* what, const dvec3& value) const;
    void finite(const char* what, const dvec4& value) const;
    void finite(const char* what, const dmat4& value) const;
    /// @param last  the last one that E has
    template <class E>
    void enumerator(const char* what, E value, E last) const {
        if (!exists(value, last)) fail(no_such(what, value));
    }
    void fine(const char* fault) const;  ///< null
};

/// Array sizes, index ranges and the material of one mesh.
/// @param known a mesh of a valid scene: equal index blocks are not checked again; may be null
/// @return 1 + the largest joint of an influence with weight > 0; 0 without influences
std::uint32_t check_mesh(const Scene& scene, std::size_t number, const Mesh* known);

/// Checks one clip.
/// @throws Error bad_file
void check_animation(const Scene& scene, std::size_t number);

/// Checks that a node's transform is finite.
void check_transform(const Place& place, const Transform& t);

/// Checks Scene::pose: one entry per node, finite.
void check_pose(const Scene& scene);

/// Checks nodes, sizes, and that times are finite and ascending. Shared blocks are checked once.
void check_animations(const Scene& scene);

}  // namespace rakelight
