#pragma once

#include "lissom/match/match_session.h"

#include <memory>
#include <vector>

namespace lissom {

/// Skins of one connectivity over n models as the paper has them (Skins 4): the source is matched with each target by itself; the skins of the first pair stay, and
/// for every other target j a copy of S₀ is carried through the pair S₀₍ⱼ₎, S₍ⱼ₎: each vertex to its nearest place of the one and by the same weights onto the other.
///
/// That adds up the errors of both; two guarded projections onto places that face alike undo it, as section 4 proposes. What masks leave out is projected by nothing. Sharp edges of targets after the first are not
/// kept (the paper's open problem). `MatchSession` with all models at once has neither trouble: this is to compare.
/// Interface and slices are those of `MatchSession`.
class PairwiseMatch {
public:
    /// @param models  two or more, the source first. @throws InvalidInput as `MatchSession`; for picked edges only once their pair's turn comes
    explicit PairwiseMatch(std::vector<MatchModel> models, const MatchOptions& options = {});
    ~PairwiseMatch();
    PairwiseMatch(PairwiseMatch&&) noexcept;

    bool step();
    [[nodiscard]] double fraction() const;

    /// Warnings are those of the pairs, each about its target, and `sharp-lost` (count: curves of a target that its skin has no more).
    /// @throws InvalidInput `not-begun` before all pairs are matched
    [[nodiscard]] MatchResult result() const;

    /// While pairs are matched the skins of the pair in hand, and nothing for the other models.
    [[nodiscard]] Points positions(int model) const;
    [[nodiscard]] const Triangles& triangles() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
