#include "skin_editor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

namespace {

/// Cosine between a triangle's normals before and after a collapse, below which it counts as turned over.
constexpr double k_collapse_turn = 0.3;
/// Between each new triangle of a swap and the two old ones together: bends of more than some 35 degrees are shape.
constexpr double k_swap_turn = 0.82;
/// Cosine by which the largest angle must fall for a swap: rounding decides nothing.
constexpr double k_better = 1e-6;

/// Cosine of the angle at p that faces the edge from a to b; −1 where there is none.
double facing_cosine(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    const Vector3d u = a - p, v = b - p;
    const double lengths = u.norm() * v.norm();
    return lengths > 0 ? u.dot(v) / lengths : -1;
}

} // namespace

SkinEditor::SkinEditor(const SkinSet& skins, std::vector<double> lengths, double longest)
    : surgery_(skins.triangles, skins.vertex_count()), lengths_(std::move(lengths)), longest_(longest), marker_(skins.marker), curves_(skins.curves) {
    for (const Points& points : skins.points) {
        Places& places = points_.emplace_back();
        for (int v = 0; v < skins.vertex_count(); ++v) places.push_back(points.row(v));
    }
}

Vector3d SkinEditor::normal(const Corners& corners, const Places& p) {
    return (p[corners[1]] - p[corners[0]]).cross(p[corners[2]] - p[corners[0]]);
}

bool SkinEditor::split(int a, int b) {
    if (curves_ && !curves_->may_split(a, b)) return false;
    const int middle = surgery_.split(a, b);
    if (middle < 0) return false;
    if (curves_) curves_->split(a, b, middle);
    for (Places& p : points_) p.push_back(((p[a] + p[b]) / 2).eval());
    lengths_.push_back((lengths_[a] + lengths_[b]) / 2);
    marker_.push_back(-1);
    return true;
}

bool SkinEditor::harms(int v, int other, const Vector3d& place, const Places& p) const {
    for (const int t : surgery_.around(v)) {
        const Corners& c = surgery_.corners(t);
        if (std::find(c.begin(), c.end(), other) != c.end()) continue; // goes
        const int k = static_cast<int>(std::find(c.begin(), c.end(), v) - c.begin());
        const int next = c[(k + 1) % 3], last = c[(k + 2) % 3];
        const Vector3d &q = p[next], &r = p[last];
        if ((q - place).norm() > longest_ * wanted(v, next) || (r - place).norm() > longest_ * wanted(v, last)) return true;
        const Vector3d before = normal(c, p), after = (q - place).cross(r - place);
        if (!(after.dot(before) > k_collapse_turn * after.norm() * before.norm())) return true;
    }
    return false;
}

bool SkinEditor::collapse(int a, int b) {
    if (marker_[a] >= 0 && marker_[b] >= 0) return false;
    if (!surgery_.may_collapse(a, b)) return false;
    const bool border_a = surgery_.on_border(a), border_b = surgery_.on_border(b);
    // Which end stays where it is: a marker before a border, else they meet in the middle.
    if ((marker_[a] >= 0 && border_b && !border_a) || (marker_[b] >= 0 && border_a && !border_b)) return false; // would pull the border inwards
    int kept = a, taken = b;
    double part = 0.5; // of the way from kept to taken
    if (marker_[a] >= 0 || marker_[b] >= 0 || border_a != border_b) {
        part = 0;
        if (marker_[b] >= 0 || (marker_[a] < 0 && border_b && !border_a)) std::swap(kept, taken);
    }
    if (curves_) {
        const EdgeCurves::Collapse of_curves = curves_->may_collapse(a, b);
        if (!of_curves.allowed) return false;
        if (of_curves.kept >= 0) {
            const int other = of_curves.kept == a ? b : a;
            if (marker_[other] >= 0 || (part == 0 && kept == other)) return false; // a border or a marker must stay, too
            kept = of_curves.kept;
            taken = other;
            part = 0;
        }
    }
    const auto place = [&](const Places& p) -> Vector3d { return (1 - part) * p[kept] + part * p[taken]; };
    for (const Places& p : points_)
        if (harms(kept, taken, place(p), p) || harms(taken, kept, place(p), p)) return false;
    for (Places& p : points_) p[kept] = place(p);
    surgery_.collapse(kept, taken);
    if (curves_) curves_->collapse(kept, taken);
    return true;
}

bool SkinEditor::swap_if_better(int a, int b) {
    const EdgeSurgery::Sides at = surgery_.sides(a, b);
    if (!at.inner() || (curves_ && !curves_->may_swap(a, b))) return false;
    const int p = at.left_corner, q = at.right_corner;
    // Criterion 3: the largest angle has the smallest cosine.
    double before = 1, after = 1;
    for (const Places& x : points_) {
        before = std::min({before, facing_cosine(x[p], x[a], x[b]), facing_cosine(x[q], x[a], x[b])});
        after = std::min({after, facing_cosine(x[a], x[p], x[q]), facing_cosine(x[b], x[p], x[q])});
    }
    if (!(after > before + k_better)) return false;
    if (!surgery_.may_swap(a, b)) return false;
    const Corners first{a, q, p}, second{q, b, p}; // of (a, b, p) and (b, a, q)
    for (const Places& x : points_) {
        const Vector3d old = normal(surgery_.corners(at.left), x) + normal(surgery_.corners(at.right), x);
        for (const Corners& corners : {first, second}) {
            const Vector3d fresh = normal(corners, x);
            if (!(fresh.dot(old) > k_swap_turn * fresh.norm() * old.norm())) return false;
        }
    }
    surgery_.swap(a, b);
    return true;
}

SkinSet SkinEditor::take() const {
    SkinSet skins;
    std::vector<int> place(marker_.size(), -1);
    for (int v = 0; v < surgery_.numbered(); ++v) {
        if (!surgery_.alive(v) && marker_[v] < 0) continue;
        place[v] = skins.vertex_count();
        skins.marker.push_back(marker_[v]);
    }
    skins.curves = curves_;
    if (skins.curves) skins.curves->renumber(place, skins.vertex_count());
    for (const Places& p : points_) {
        Points& points = skins.points.emplace_back(skins.vertex_count(), 3);
        for (std::size_t v = 0; v < place.size(); ++v)
            if (place[v] >= 0) points.row(place[v]) = p[v].transpose();
    }
    skins.triangles = surgery_.triangles(place);
    return skins;
}

} // namespace lissom
