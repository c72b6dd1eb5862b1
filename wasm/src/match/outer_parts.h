#pragma once

#include "lissom/match/match_session.h"
#include "lissom/match/outer_surface.h"

#include <optional>
#include <utility>
#include <vector>

namespace lissom {

/// Finds, in slices, which models have pieces that reach into one another, and settles by that what the first skin is and whether skins are fitted to outer surfaces only.
///
/// A skin that is one closed surface cannot follow what is inside. So only a copy or an even remesh of a source that has such pieces itself is fitted to whole
/// models; by default that is taken where all models have as many pieces, and else the source is wrapped.
class OuterParts {
public:
    OuterParts(const std::vector<MatchModel>& models, FirstSkin wanted);

    /// One slice. @returns true while there is more
    bool step();
    [[nodiscard]] FirstSkin first() const { return first_; } ///< never automatic after the last step
    /// None where the whole model is fitted to. To be taken once.
    [[nodiscard]] std::optional<OuterSurface> take(std::size_t model) { return std::move(found_[model]); }

private:
    void settle();

    std::vector<const WorkingMesh*> models_;
    FirstSkin first_;
    std::vector<std::optional<OuterSurface>> found_;
    std::size_t model_ = 0;
    std::optional<OuterSurfaceFinder> finder_;
};

} // namespace lissom
