// SPDX-License-Identifier: Apache-2.0
// A loaded scene as a request wants it: at a moment, with its materials, coloring, environment, preset, points and fog.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <rakelight/scene/motion.h>
#include <rakelight/world/request.h>

namespace rakelight {

/// A loaded scene at the moment of some clips.
/// @throws Error usage: no such clip
Scene at_moment(Scene loaded, std::span<const ClipTime> clips, Context& context);

/// as_requested() of shot.h for a single picture: the array and the range of the coloring are chosen, too.
/// @param moment   of at_moment(); passed validate()
/// @param request  gets what is chosen
Scene asked_single(Scene moment, PictureRequest& request, Context& context);

/// The members of a request that its surfaces depend on; all others have their defaults.
PictureRequest surfaces_of(const PictureRequest& request);

/// Such scenes of one loaded scene after another: what does not depend on the moment is kept. They have the clips that are
/// shown alone: of a character with a hundred clips a copy of all takes as long as its pose.
class AskedScenes {
public:
    /// @param request  the choices of its look have been made
    /// @throws Error usage: no such clip or attribute; not_found, bad_file: a picture of the request
    Scene at(const std::shared_ptr<const Scene>& loaded, const PictureRequest& request, std::span<const ClipTime> clips,
             Context& context);

private:
    std::shared_ptr<const Scene> loaded_;
    std::optional<PictureRequest> surfaces_;  ///< what of the request asked_ depends on
    /// Where clips move materials that the request changes: the moment that asked_ is at, else empty.
    std::vector<ClipTime> clips_;
    Scene asked_;  ///< without clips
};

}  // namespace rakelight
