#pragma once

#include "lissom/mesh/self_intersections.h"
#include "lissom/mesh/types.h"

#include <array>
#include <utility>
#include <vector>

namespace lissom {

/// Pairs of triangles at each edge of exactly two that agree about their sides.
using TrianglePairs = std::vector<std::pair<int, int>>;
[[nodiscard]] TrianglePairs neighbouring_triangles(const TriangleMesh& mesh);

/// Neighbours whose normals point apart by a cosine below this lie on each other: folded. What the report counts.
constexpr double k_fold = -0.2;
/// Folded so far that it is mended: thin parts (ears, rims of sleeves) rightly have edges between the two.
constexpr double k_sharp_fold = -0.7;

/// Edges with a cosine below `least` between their triangles' normals.
[[nodiscard]] int count_folds(const TriangleMesh& mesh, const TrianglePairs& pairs, double least = k_fold);

/// What is wrong with a surface as it lies: triangles that meet others, and sharply folded ones.
struct Tangle {
    int crossings = 0;          ///< triangles that meet another
    std::vector<int> triangles; ///< these and folded ones, ascending
};
[[nodiscard]] Tangle tangle_of(const TriangleMesh& mesh, const TrianglePairs& pairs, IntersectionFinder& finder);

/// Smooths where a surface is tangled, and around, until it no longer is: the triangles and one ring, one ring more every four rounds, three steps of 0.6 towards the
/// mean of the neighbours each. Border vertices move towards those along their border.
/// @param locked  one flag per vertex: stays
/// @param rounds  at most
/// @returns what is left; more than nothing where the rounds were not enough
Tangle untangle(TriangleMesh& mesh, const std::vector<char>& locked, int rounds = 24);

/// Moves a surface as far along as it can without harm.
///
/// The whole step is taken first; where that makes triangles meet, turn over or fold, their vertices go half as far, then a quarter, then a sixteenth, then not at all,
/// with ever more around them, at most twelve times; after that nothing moves. What was tangled before may stay so, no more triangles are.
/// So a surface that is clean stays clean whatever it is asked.
class GuardedStep {
public:
    explicit GuardedStep(const TriangleMesh& mesh);

    struct Taken {
        int shortened = 0;  ///< vertices that went less far than asked
        int crossings = 0;  ///< triangles that meet another, afterwards
        bool refused = false; ///< nothing moved
    };
    /// @param moves  n×3. @param mesh  of the triangles that this was made for
    Taken take(TriangleMesh& mesh, const Points& moves);

private:
    TrianglePairs pairs_;
    IntersectionFinder finder_;
    std::vector<std::vector<int>> around_; ///< triangles at each vertex
    Points last_;            ///< where the last step ended
    SelfIntersections met_;  ///< what meets there
};

} // namespace lissom
