#pragma once

#include "lissom/hair/strand_growth.h"

#include <span>

namespace lissom {

/// The guides of a head of hair: its first strands, found again by place, and cured of what a smooth field does to
/// single strands. Where the field turns about a point, strands between two ways of going take a third one of their
/// own, across the face or straight up; on a head they would be combed over to their neighbours.
class StrandCompany {
public:
    static constexpr int nearby = 6; ///< guides that are asked where a strand should go

    /// @param guides  as grown; those without company among their neighbours follow the nearest that has some
    StrandCompany(std::vector<Strand> guides, double head_height);

    [[nodiscard]] const std::vector<Strand>& guides() const { return guides_; }
    /// To change a guide's points; roots stay.
    [[nodiscard]] Strand& guide(int g) { return guides_[static_cast<std::size_t>(g)]; }

    /// The guides nearest to a root on its side of all partings, nearest first, at most `most`.
    /// @param among  only the first so many guides
    [[nodiscard]] std::vector<int> nearest(const Root& root, const PartingGuard::Sides& sides, int among, int most) const;

    /// The guide that a strand goes along with, the nearest such; −1 without any guide. A strand that goes along
    /// with none of those near it is laid beside the nearest.
    int join(Strand& strand) const;

private:
    [[nodiscard]] bool together(const Strand& a, const Strand& b) const;
    void follow(Strand& strand, const Strand& guide) const;

    std::vector<Strand> guides_;
    double reach_; // over which a follower comes closer to its guide, head units
    Grid buckets_; // of guide roots
    std::vector<std::vector<int>> bucket_;
};

} // namespace lissom
