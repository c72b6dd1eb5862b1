#include "lissom/merge/hole_filling.h"

#include "polygon_splits.h"

#include <Eigen/Geometry>

#include <limits>
#include <utility>

namespace lissom {

std::vector<std::array<int, 3>> least_area_filling(const Points& points, const std::vector<int>& loop) {
    const auto n = static_cast<int>(loop.size());
    std::vector<Eigen::Vector3d> p;
    for (const int v : loop) p.push_back(points.row(v).transpose());
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

} // namespace lissom
