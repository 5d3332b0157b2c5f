// SPDX-License-Identifier: Apache-2.0
// What is computed about the model beside its pictures: the explanation of a pixel, the seams of its normals.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "../document/ui_state.h"
#include "../view/overlay.h"
#include "background.h"
#include "load_model.h"

namespace rakelight::viewer {

class Analysis {
public:
    /// @param start  limits of the work; texts and messages go to `ui`
    Analysis(const Start& start, std::function<void()> wake, UiState& ui);

    /// Explains a pixel of the scene as it is shown, with its changed materials, and opens the panel with the text.
    void explain(const std::shared_ptr<const Model>& model, const Look& look, int width, int height, int x, int y);
    /// Looks for seams if they are wanted and the model or its normals have changed.
    /// @param is_waiting  a search that runs is finished before the next one
    void look_for_seams(const std::shared_ptr<const Model>& model, const PrepareOptions& prepare, bool is_waiting);
    /// Until those of another model are found.
    void forget_seams() { seams_.reset(); }

    /// The last ones that were found. Null: none, or those of another model
    std::shared_ptr<const Seams> seams(const std::shared_ptr<const Model>& model) const {
        return seams_model_ == model ? seams_ : nullptr;
    }
    /// The same ones; null also if normals were computed in another way.
    std::shared_ptr<const Seams> seams(const std::shared_ptr<const Model>& model, const PrepareOptions& prepare) const {
        return seams_prepare_ == prepare ? seams(model) : nullptr;
    }

    void poll();
    void cancel();
    std::vector<const Background*> works() const { return {&explainer_, &seam_search_}; }

private:
    UiState& ui_;
    std::shared_ptr<const Seams> seams_;
    std::shared_ptr<const Model> seams_model_;  ///< of the last search
    PrepareOptions seams_prepare_;              ///< likewise
    Background explainer_, seam_search_;        ///< last: their work ends before what it uses
};

}  // namespace rakelight::viewer
