#pragma once

#include "lissom/match/affine_fit.h"
#include "lissom/match/correspondences.h"
#include "lissom/match/fit_surface.h"
#include "lissom/match/node_graph.h"
#include "lissom/match/pull.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace lissom {

/// How a skin is carried along: with markers it starts near, without it must find its way.
struct CarrySchedule {
    double radius;                  ///< of the first graph
    int iterations;                 ///< on each
    double first_reach, last_reach;
    double least_cosine;
};
[[nodiscard]] CarrySchedule carry_schedule(int markers);

/// Ever finer node graphs of one skin, each made when it is first asked for.
class GraphLevels {
public:
    /// @param skin    about unit size
    /// @param radius  of the first; each further one half of that, but so that there are no more than some 3000 nodes
    GraphLevels(const TriangleMesh& skin, double radius, int count, std::uint64_t seed = 0);

    [[nodiscard]] const NodeGraph& operator[](int level);
    [[nodiscard]] int count() const { return count_; }

private:
    WeightedGraph edges_;
    double radius_, least_;
    int count_;
    std::uint64_t seed_;
    std::deque<NodeGraph> graphs_; ///< referred to while more are made
};

/// What is known of a skin before it is carried.
struct CarryGuides {
    std::vector<Pull> pulls;    ///< places of the skin and where they belong, weights in vertices
    std::vector<char> left_out; ///< one flag per vertex: it is told where to go already, or nothing is to be asked about it
    std::vector<char> masked;   ///< one flag per vertex, or none: no place of the surface pulls at triangles of only these
};

/// Carries a skin onto a surface by the affine maps of ever finer node graphs (`AffineFit`), asking again and again where its places should go (`Correspondences`).
///
/// Source: what the paper's own loop (004, Eq 1) does not do.
/// Cost: a step is one solve and one round of nearest places; levels × iterations of them.
class SkinCarrier {
public:
    /// @param rest      the skin as it lies on the surface at first, about unit size
    /// @param triangles,graphs,surface  kept by reference
    SkinCarrier(Points rest, const Triangles& triangles, GraphLevels& graphs, const FitSurface& surface, CarryGuides guides, const CarrySchedule& schedule, std::uint64_t seed = 0);

    /// @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] int steps() const { return graphs_.count() * schedule_.iterations; }
    [[nodiscard]] double fraction() const { return static_cast<double>(iteration_) / steps(); }
    [[nodiscard]] int levels_done() const { return iteration_ / schedule_.iterations; }
    [[nodiscard]] const Points& points() const { return points_; }
    /// What the last step could not avoid, see `AffineFit::energy`.
    [[nodiscard]] double energy() const { return energy_; }

private:
    void begin_level(int level);

    Points rest_, points_;
    const Triangles& triangles_;
    GraphLevels& graphs_;
    const FitSurface& surface_;
    CarryGuides guides_;
    CarrySchedule schedule_;
    std::uint64_t seed_;
    int iteration_ = 0;
    double energy_ = 0;
    int asked_ = 0; ///< vertices, and samples, by which it is carried on this level
    std::optional<Correspondences> correspondences_;
    std::optional<AffineFit> affine_;
};

} // namespace lissom
