#include "sharp_finish.h"

#include "lissom/match/sharp_curves.h"
#include "lissom/mesh/triangle_tree.h"

#include <algorithm>
#include <limits>

namespace lissom {

using Eigen::Vector3d;

namespace {

std::vector<std::vector<int>> in_working_mesh(const PlacedModel& model, const std::vector<std::vector<int>>& chains) {
    const std::vector<int>& places = model.working.working_of_source;
    std::vector<std::vector<int>> all;
    for (const auto& chain : chains) {
        std::vector<int> mapped;
        for (const int v : chain) mapped.push_back(v >= 0 && v < std::ssize(places) ? places[v] : -1);
        if (!model.outer) all.push_back(std::move(mapped));
        else
            for (auto& piece : model.outer->along(mapped)) all.push_back(std::move(piece));
    }
    return all;
}

/// Pieces of lines as triangles (a, b, b).
TriangleMesh as_segments(const std::vector<Points>& lines) {
    Eigen::Index points = 0, pieces = 0;
    for (const Points& line : lines) {
        points += line.rows();
        pieces += std::max<Eigen::Index>(line.rows() - 1, 0);
    }
    TriangleMesh mesh{Points(points, 3), Triangles(pieces, 3)};
    Eigen::Index row = 0, piece = 0;
    for (const Points& line : lines) {
        mesh.points.middleRows(row, line.rows()) = line;
        for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) mesh.triangles.row(piece++).setConstant(static_cast<int>(row + i + 1))(0) = static_cast<int>(row + i);
        row += line.rows();
    }
    return mesh;
}

Points closed_up(const SharpLine& line) {
    if (!line.closed) return line.points;
    Points all(line.points.rows() + 1, 3);
    all << line.points, line.points.row(0);
    return all;
}

} // namespace

SharpFinish::SharpFinish(const PlacedModel& model, double angle, const std::vector<std::vector<int>>& picked) {
    if (!(angle > 0) && picked.empty()) return;
    curves_ = sharp_curves(model.mesh(), {.angle = angle}, in_working_mesh(model, picked));
    lines_ = sharp_lines(model.mesh().points, curves_);
}

Vector3d SharpFinish::snapped(const Vector3d& place, double reach) const {
    std::vector<Points> lines;
    for (const SharpLine& line : lines_) lines.push_back(closed_up(line));
    const TriangleMesh segments = as_segments(lines);
    const auto at = TriangleTree(segments).nearest_where(place, reach, -1, [](int) { return true; });
    return at.triangle < 0 ? place : at.point;
}

bool SharpFinish::step(TriangleMesh& skin, const FitSurface& surface, const std::vector<int>& marker, double edge_length) {
    if (empty()) return false;
    if (tracking_) return tracking_->step(skin);
    std::vector<Anchor> markers;
    std::vector<char> locked;
    for (int v = 0; v < skin.vertex_count(); ++v) {
        locked.push_back(marker[v] >= 0);
        if (marker[v] >= 0) markers.push_back({v, skin.points.row(v)});
    }
    // Markers near a curve are on it already, and stay where they are to the last digit.
    found_ = find_sharp_paths(skin, lines_, markers, {.edge_length = edge_length, .snap = 1e-6});
    tracking_.emplace(skin, surface, anchors_of(found_.paths), locked, SharpTracking::Options{});
    return true;
}

double SharpFinish::fraction() const { return tracking_ ? static_cast<double>(1 + tracking_->done()) / (1 + tracking_->slices()) : 0; }

double SharpFinish::error(const Points& skin) const {
    if (lines_.empty()) return 0;
    std::vector<Points> paths;
    for (const SharpPath& path : found_.paths) {
        Points& places = paths.emplace_back(static_cast<Eigen::Index>(path.curve.vertices.size()), 3);
        for (std::size_t i = 0; i < path.curve.vertices.size(); ++i) places.row(static_cast<Eigen::Index>(i)) = skin.row(path.curve.vertices[i]);
    }
    if (paths.empty()) return std::numeric_limits<double>::infinity();
    const TriangleMesh segments = as_segments(paths);
    const TriangleTree tree(segments);
    double most = 0;
    for (const SharpLine& line : lines_) {
        const Points points = closed_up(line);
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            most = std::max(most, tree.nearest(points.row(i)).distance);
            if (i > 0) most = std::max(most, tree.nearest((points.row(i) + points.row(i - 1)) / 2).distance);
        }
    }
    return most;
}

} // namespace lissom
