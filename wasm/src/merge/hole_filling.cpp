#include "lissom/merge/hole_filling.h"

#include "polygon_splits.h"

#include <Eigen/Geometry>

#include <limits>
#include <numeric>
#include <utility>

namespace lissom {
namespace {

/// Corners up to which the filling of least area is searched for: 2e7 steps, some 0.1 s.
constexpr std::size_t k_searched = 512;

std::vector<std::array<int, 3>> searched(const std::vector<Eigen::Vector3d>& p) {
    const auto n = static_cast<int>(p.size());
    std::vector<double> area(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 0);
    std::vector<int> split(area.size(), -1);
    const auto at = [n](int i, int j) { return static_cast<std::size_t>(i) * static_cast<std::size_t>(n) + static_cast<std::size_t>(j); };
    for (int span = 2; span < n; ++span)
        for (int i = 0; i + span < n; ++i) {
            const int j = i + span;
            const Eigen::Vector3d chord = p[j] - p[i];
            double least = std::numeric_limits<double>::infinity();
            for (int k = i + 1; k < j; ++k) {
                const double sum = area[at(i, k)] + area[at(k, j)];
                if (sum >= least) continue;
                const double whole = sum + 0.5 * chord.cross(p[k] - p[i]).norm();
                if (whole < least) {
                    least = whole;
                    split[at(i, j)] = k;
                }
            }
            area[at(i, j)] = least;
        }
    return triangles_of_splits(n, [&](int i, int j) { return split[at(i, j)]; });
}

} // namespace

std::vector<std::array<int, 3>> least_area_filling(const Points& points, const std::vector<int>& loop) {
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> places(loop.size());
    std::iota(places.begin(), places.end(), 0);
    while (places.size() > k_searched) { // every other corner is cut off, which halves what is left
        std::vector<int> kept;
        for (std::size_t k = 0; k < places.size(); k += 2) {
            kept.push_back(places[k]);
            if (k + 1 < places.size()) triangles.push_back({places[k], places[k + 1], places[(k + 2) % places.size()]});
        }
        places = std::move(kept);
    }
    std::vector<Eigen::Vector3d> corners;
    for (const int place : places) corners.push_back(points.row(loop[static_cast<std::size_t>(place)]).transpose());
    for (const auto& [a, b, c] : searched(corners)) triangles.push_back({places[a], places[b], places[c]});
    return triangles;
}

} // namespace lissom
