#include "lissom/match/sharp_tracking.h"

#include "lissom/match/smoothing_rings.h"
#include "lissom/mesh/operators.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace lissom {

using Eigen::RowVector3d;

namespace {

constexpr double k_mean = 0.4; // of the ring, in where a vertex looks for its place
constexpr int k_fading = 8;    // sweeps by which moves of paths fade into the strip
constexpr int k_sweeps = 5;    // of settling between guarded steps
constexpr double k_turned = 0.3; // cosine of a triangle's normals before and after a sweep

} // namespace

SharpTracking::SharpTracking(const TriangleMesh& skin, const FitSurface& surface, const std::vector<Anchor>& held, const std::vector<char>& locked, const Options& options)
    : surface_(surface), held_(held), options_(options), rings_(vertex_rings(skin)), guard_(skin), settled_{Points(0, 3), skin.triangles}, hints_(static_cast<std::size_t>(skin.vertex_count()), -1) {
    const std::vector<bool> border = boundary_vertices(skin);
    std::vector<char> seen(static_cast<std::size_t>(skin.vertex_count()), 0);
    std::vector<int> front;
    for (const Anchor& anchor : held_) {
        seen[anchor.vertex] = 1;
        front.push_back(anchor.vertex);
    }
    for (int ring = 0; ring < options_.strip; ++ring) {
        std::vector<int> next;
        for (const int v : front)
            for (const int w : rings_[v])
                if (!seen[w]) {
                    seen[w] = 1;
                    next.push_back(w);
                }
        for (const int v : next)
            if (!locked[v] && !border[v]) strip_.push_back(v);
        front = std::move(next);
    }
    std::sort(strip_.begin(), strip_.end());
    around_.resize(static_cast<std::size_t>(skin.vertex_count()));
    for (const int v : strip_) around_[v].reserve(6);
    std::vector<char> in_strip(static_cast<std::size_t>(skin.vertex_count()), 0);
    for (const int v : strip_) in_strip[v] = 1;
    for (int t = 0; t < skin.triangle_count(); ++t)
        for (const int v : skin.triangles.row(t))
            if (in_strip[v]) around_[v].push_back(t);
}

int SharpTracking::slices() const { return options_.approach + options_.settle + (options_.settle + k_sweeps - 1) / k_sweeps; }

void SharpTracking::approach(const Points& points, Points& moves) const {
    const double part = 1.0 / std::max(1, options_.approach - slice_);
    for (const Anchor& anchor : held_) moves.row(anchor.vertex) = part * (anchor.place.transpose() - points.row(anchor.vertex));
    for (int sweep = 0; sweep < k_fading; ++sweep) {
        const Points before = moves;
        for (const int v : strip_) moves.row(v) = ring_mean(before, rings_, v);
    }
}

bool SharpTracking::turns(int v, const RowVector3d& place) const {
    const TriangleMesh& skin = settled_;
    for (const int t : around_[v]) {
        const auto corners = skin.triangles.row(t);
        const int k = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
        const RowVector3d p = skin.points.row(v), q = skin.points.row(corners[(k + 1) % 3]), r = skin.points.row(corners[(k + 2) % 3]);
        const RowVector3d before = (q - p).cross(r - p), after = (q - place).cross(r - place);
        if (!(after.dot(before) > k_turned * after.norm() * before.norm())) return true;
    }
    return false;
}

/// One after the other, so that each sees where the others have gone.
void SharpTracking::settle() {
    Points& points = settled_.points;
    const Points normals = vertex_normals(settled_);
    for (const int v : strip_) {
        const RowVector3d p = points.row(v), q = (1 - k_mean) * p + k_mean * ring_mean(points, rings_, v);
        const auto place = surface_.nearest(q.transpose(), normals.row(v).transpose(), options_.least_cosine, options_.reach, hints_[v]);
        hints_[v] = place.triangle;
        if (place.triangle >= 0 && !place.on_border && !turns(v, place.point.transpose())) points.row(v) = place.point.transpose();
    }
}

bool SharpTracking::step(TriangleMesh& skin) {
    if (slice_ >= slices()) return false;
    const int settling = slice_ - options_.approach, at = settling % (k_sweeps + 1); // five sweeps, then a guarded step
    if (settling < 0) {
        Points moves = Points::Zero(skin.points.rows(), 3);
        approach(skin.points, moves);
        guard_.take(skin, moves);
    } else if (at == k_sweeps || slice_ + 1 == slices()) guard_.take(skin, settled_.points - skin.points);
    else {
        if (at == 0) {
            settled_.points = skin.points;
            for (const Anchor& anchor : held_) settled_.points.row(anchor.vertex) = anchor.place.transpose(); // those that the guard kept back try again
        }
        settle();
    }
    return ++slice_ < slices();
}

double SharpTracking::farthest(const Points& skin) const {
    double most = 0;
    for (const Anchor& anchor : held_) most = std::max(most, (skin.row(anchor.vertex) - anchor.place.transpose()).norm());
    return most;
}

} // namespace lissom
