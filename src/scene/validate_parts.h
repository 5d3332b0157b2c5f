// SPDX-License-Identifier: Apache-2.0
// What the parts of validate() share: a place in the scene that knows how to complain, and the checks of the big arrays.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include <rakelight/scene.h>

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
/// @param known  a mesh of a valid scene: its indices are not looked through again where they are these; may be null
/// @return 1 + the largest joint that an influence of weight > 0 names; 0 without influences
std::uint32_t check_mesh(const Scene& scene, std::size_t number, const Mesh* known);

/// One of them. @throws Error bad_file
void check_animation(const Scene& scene, std::size_t number);

/// A node's placement: finite.
void check_transform(const Place& place, const Transform& t);

/// Scene::pose: one entry a node, finite.
void check_pose(const Scene& scene);

/// Nodes, sizes, and times that are finite and ascending. Numbers that channels share are looked at once.
void check_animations(const Scene& scene);

}  // namespace rakelight
