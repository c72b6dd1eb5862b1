#pragma once

#include "lissom/hair/strand_company.h"
#include "lissom/hair/tail_tie.h"

namespace lissom {

/// What keeps hair from looking combed by a machine: the local variation that a smooth field lacks (Fu 4.7).
struct DetailOptions {
    double clump = 0.4;                ///< 0..1: how closely tips gather
    double curl = 0;                   ///< 0..1: radius of the curls, 1 being 4 % of the head's height
    std::optional<double> curl_length; ///< of one turn, head units; 16 % of the head's height when left out
    double frizz = 0.25;               ///< 0..1: small waves of each strand's own
    double flyaways = 0.02;            ///< 0..1: share of strands that stand off
};

/// The shortest turn of the curls that `options` ask for, head units, up to twice that where they are so shallow that
/// a strand hardly changes its direction; none without curls.
[[nodiscard]] std::optional<double> shortest_turn(const DetailOptions& options, double head_height);

/// Adds detail to grown strands, each from its own number: the same strand whatever is grown beside it.
///
/// In this order: strands without company join their neighbours, clumps of two sizes, curls in a parallel-transported frame, frizz, flyaways, hair drawn
/// together where a ponytail is tied, and at last no point in the head and none across its parting.
class StrandDetail {
public:
    static constexpr int guides = 3000;       ///< strands that the small clumps gather round: the first of all
    static constexpr int large_guides = 300;  ///< those that the large clumps do

    /// @param guide_strands  the first `guides` strands as grown
    /// @throws InvalidInput `bad-option`
    StrandDetail(const HairVolume& volume, const HeadDistance& head, const PartingGuard& partings, const TailTie& ties,
                 const DetailOptions& options, std::uint64_t seed, std::vector<Strand> guide_strands);

    /// @returns number of the large clump that the strand belongs to; `large_guides` for none
    int apply(Strand& strand, std::uint64_t index) const;

private:
    void gather(Strand& strand, const Strand& guide, double strength, double root_share) const;
    void curl(Strand& strand, std::uint64_t index, std::uint64_t clump, const std::vector<double>& looseness) const;
    void roughen(Strand& strand, std::uint64_t index, const std::vector<double>& looseness) const;

    const HairVolume& volume_;
    const HeadDistance& head_;
    const PartingGuard& partings_;
    const TailTie& ties_;
    DetailOptions options_;
    std::uint64_t seed_;
    StrandCompany company_;
    std::vector<int> large_; // per guide its large clump; −1: none
};

} // namespace lissom
