#include "lissom/match/marker_curves.h"

#include "lissom/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr int k_most_places = 500; // a curve

std::vector<double> lengths_along(const Points& line) {
    std::vector<double> at{0};
    for (Eigen::Index i = 1; i < line.rows(); ++i) at.push_back(at.back() + (line.row(i) - line.row(i - 1)).norm());
    return at;
}

void bring_onto(const FitSurface& surface, Points& places) {
    for (Eigen::Index i = 0; i < places.rows(); ++i) places.row(i) = surface.nearest(places.row(i), Vector3d::Zero(), -1, std::numeric_limits<double>::infinity()).point.transpose();
}

} // namespace

Points places_along_polyline(const Points& line, int count) {
    const std::vector<double> at = lengths_along(line);
    Points places(count, 3);
    for (int i = 0; i < count; ++i) {
        const double wanted = count > 1 ? at.back() * i / (count - 1) : 0;
        const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(at.begin(), at.end(), wanted) - at.begin(), 1, std::ssize(at) - 1);
        const double whole = at[next] - at[next - 1], part = whole > 0 ? std::clamp((wanted - at[next - 1]) / whole, 0.0, 1.0) : 0;
        places.row(i) = (1 - part) * line.row(next - 1) + part * line.row(next);
    }
    return places;
}

MarkerCurves::MarkerCurves(const std::vector<Points>& on_source, const FitSurface& source, double edge_length) {
    for (const Points& curve : on_source) counts_.push_back(std::clamp(static_cast<int>(std::ceil(lengths_along(curve).back() / edge_length)) + 1, 2, k_most_places));
    places_ = on(on_source, source);
}

Points MarkerCurves::on(const std::vector<Points>& curves, const FitSurface& surface) const {
    Eigen::Index all = 0;
    for (const int count : counts_) all += count;
    Points places(all, 3);
    Eigen::Index row = 0;
    for (std::size_t c = 0; c < counts_.size(); ++c, row += counts_[c - 1]) places.middleRows(row, counts_[c]) = places_along_polyline(curves[c], counts_[c]);
    bring_onto(surface, places);
    return places;
}

std::vector<Pull> MarkerCurves::pulls(const TriangleMesh& source_skin, const Points& targets) const {
    std::vector<Pull> found;
    if (empty()) return found;
    const TriangleTree tree(source_skin);
    for (Eigen::Index i = 0; i < places_.rows(); ++i) {
        const auto at = tree.nearest(places_.row(i));
        if (at.triangle < 0) continue;
        const auto corners = source_skin.triangles.row(at.triangle);
        found.push_back({{corners[0], corners[1], corners[2]}, corner_weights(source_skin, at.triangle, at.point), targets.row(i), 1});
    }
    return found;
}

} // namespace lissom
