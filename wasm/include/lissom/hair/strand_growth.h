#pragma once

#include "lissom/hair/hair_volume.h"
#include "lissom/hair/head_distance.h"
#include "lissom/hair/parting_guard.h"
#include "lissom/hair/scalp_roots.h"
#include "lissom/hair/vector_field.h"

#include <optional>
#include <vector>

namespace lissom {

/// How strands grow. Lengths are in head units; left out, they follow the head's height.
struct GrowthOptions {
    std::uint64_t seed = 1;
    double step = 0.5;             ///< of a strand's segments, in grid steps (Fu 4.6)
    std::optional<double> length;  ///< longest strand; one head height when left out
    double length_variation = 0.2; ///< 0..1: how much shorter than its share a strand may be
    std::optional<double> volume;  ///< height of the hair over the skin; 3 % of the head's height when left out
    std::optional<double> wave;    ///< the shortest that detail will bend strands into: they get points enough for it
    std::vector<float> length_map; ///< factor of the length per vertex of the head, painted; empty: 1 everywhere
};

/// One strand before detail: where it runs, root first.
struct Strand {
    Root root;
    PartingGuard::Sides sides;           ///< of the partings
    double segment;                      ///< length of one, head units
    std::vector<Eigen::Vector3d> points; ///< at least the root, at most 255
};

/// Grows strands along a field from the scalp (Fu 4.6), never into the head.
///
/// A strand that would be rooted on the line of a parting is rooted elsewhere, by its own number.
/// Second-order Runge–Kutta on the normalised field, so that a strand's length is a length. A strand ends where the
/// field fades (magnitude below 0.05, once it has left its root), at the end of the volume, at its length or at
/// 255 points. Nearer to the skin than its share of the hair's height it is led along the skin and lifted.
class StrandGrowth {
public:
    static constexpr int max_points = 255; ///< what other programs take in one strand
    static constexpr double parting_reach = 0.06; ///< of the head height: longer than the centimetre that is promised

    /// All by reference: they outlive the growth.
    /// @throws InvalidInput `bad-option`
    StrandGrowth(const HairVolume& volume, const HeadDistance& head, const VectorField& field, const ScalpRoots& roots,
                 const PartingGuard& partings, GrowthOptions options);

    [[nodiscard]] Strand grow(std::uint64_t index) const;
    [[nodiscard]] const GrowthOptions& options() const { return options_; }

    /// How far from the skin a strand keeps this far along it: less and less towards its root.
    [[nodiscard]] static double clearance_at(double along, double head_height);

    /// A point no deeper than `clearance` above the skin allows, moved straight out.
    [[nodiscard]] static Eigen::Vector3d lifted(const HeadDistance& head, const Eigen::Vector3d& p, double clearance);

private:
    [[nodiscard]] Root root_of(std::uint64_t index) const;
    [[nodiscard]] double length_of(const Root& root, std::uint64_t index) const;

    const HairVolume& volume_;
    const HeadDistance& head_;
    const VectorField& field_;
    const ScalpRoots& roots_;
    const PartingGuard& partings_;
    GrowthOptions options_;
    double length_, height_, segment_;
    int pieces_ = 1; // that each segment is cut into once the strand has grown
};

/// The strand with each segment in equal pieces along the curve through its points (Catmull–Rom).
[[nodiscard]] Strand refined(Strand strand, int pieces);

} // namespace lissom
