#include "lissom/mesh/orientation.h"

#include "lissom/mesh/half_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

/// Across each side of each triangle: the one neighbour there, and whether both run that edge the same way.
struct Across {
    std::vector<int> neighbour; ///< 3·triangle + corner; −1: none, or more than one
    std::vector<bool> opposed;

    explicit Across(const TriangleMesh& mesh) : neighbour(3 * mesh.triangle_count(), -1), opposed(neighbour.size()) {
        const std::vector<HalfEdge> sides = half_edges(mesh);
        for_each_edge(sides, [&](auto first, auto last) {
            if (last - first != 2 || first->triangle == (first + 1)->triangle)
                return;
            const HalfEdge &s = *first, &t = *(first + 1);
            neighbour[3 * s.triangle + s.corner] = t.triangle;
            neighbour[3 * t.triangle + t.corner] = s.triangle;
            opposed[3 * s.triangle + s.corner] = opposed[3 * t.triangle + t.corner] = s.forward == t.forward;
        });
    }
};

/// Triangles that can be reached from each other across edges of two.
struct Patch {
    std::vector<int> triangles;
    int flipped = 0;         ///< triangles that must turn to agree with the first
    int conflicts_given = 0; ///< edges in conflict (each seen from both sides) as the triangles are
    int conflicts_left = 0;  ///< and once the flipped ones are turned
    bool closed = true;
    double volume = 0;       ///< once the flipped ones are turned
    Eigen::AlignedBox3d box;

    /// A closed patch without volume has no outside.
    [[nodiscard]] bool encloses() const {
        const double size = box.isEmpty() ? 0 : box.diagonal().norm();
        return closed && conflicts_left == 0 && std::abs(volume) > 1e-12 * size * size * size;
    }
};

Patch walk(const TriangleMesh& mesh, const Across& across, int seed, std::vector<signed char>& side) {
    Patch patch;
    const Eigen::Vector3d base = mesh.points.row(mesh.triangles(seed, 0));
    side[seed] = 1;
    patch.triangles.push_back(seed);
    for (std::size_t next = 0; next < patch.triangles.size(); ++next) { // breadth first
        const int t = patch.triangles[next];
        patch.flipped += side[t] < 0 ? 1 : 0;
        Eigen::Matrix3d corner;
        for (int k = 0; k < 3; ++k) {
            const int other = across.neighbour[3 * t + k];
            const bool opposed = across.opposed[3 * t + k];
            if (other < 0) {
                patch.closed = false;
            } else if (side[other] == 0) {
                side[other] = static_cast<signed char>(opposed ? -side[t] : side[t]);
                patch.triangles.push_back(other);
            }
            if (other >= 0) {
                patch.conflicts_given += opposed ? 1 : 0;
                patch.conflicts_left += opposed == (side[other] == side[t]) ? 1 : 0;
            }
            corner.col(k) = mesh.points.row(mesh.triangles(t, k)).transpose() - base;
            patch.box.extend(corner.col(k) + base);
        }
        patch.volume += side[t] * corner.determinant() / 6;
    }
    return patch;
}

} // namespace

Orientation orient(const TriangleMesh& mesh) {
    const Across across(mesh);
    std::vector<signed char> side(mesh.triangle_count(), 0); // ±1 relative to the first triangle of the patch
    std::vector<Patch> patches;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (side[t] == 0)
            patches.push_back(walk(mesh, across, t, side));

    const auto extent = [](const Patch& p) { return p.encloses() ? p.box.diagonal().norm() : -1; };
    const auto largest = std::max_element(patches.begin(), patches.end(),
                                          [&](const Patch& p, const Patch& q) { return extent(p) < extent(q); });
    Orientation result;
    result.turned.assign(mesh.triangle_count(), false);
    for (auto patch = patches.begin(); patch != patches.end(); ++patch) {
        const int count = static_cast<int>(patch->triangles.size());
        int turn = -1; // triangles on this side are turned
        if (patch->conflicts_left > 0) {
            result.one_sided.push_back(patch->triangles[0]);
            if (patch->conflicts_left >= patch->conflicts_given)
                continue;
        }
        if (patch->flipped == 0 && patch->encloses()) {
            const bool may_be_cavity = patch != largest && largest->box.contains(patch->box);
            if (patch->volume > 0 || may_be_cavity)
                continue;
            turn = 1;
        } else if (patch->encloses()) {
            turn = patch->volume > 0 ? -1 : 1;
        } else {
            turn = 2 * patch->flipped <= count ? -1 : 1;
        }
        std::vector<int>& reason = patch->flipped == 0 ? result.inside_out : result.inconsistent;
        for (const int t : patch->triangles)
            if (side[t] == turn) {
                result.turned[t] = true;
                reason.push_back(t);
            }
    }
    std::sort(result.inconsistent.begin(), result.inconsistent.end());
    std::sort(result.inside_out.begin(), result.inside_out.end());
    return result;
}

} // namespace lissom
