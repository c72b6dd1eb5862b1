#include "skin_editor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
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
    : lengths_(std::move(lengths)), longest_(longest), marker_(skins.marker), curves_(skins.curves), around_(static_cast<std::size_t>(skins.vertex_count())), vertices_(skins.vertex_count()) {
    for (const Points& points : skins.points) {
        Places& places = points_.emplace_back();
        for (int v = 0; v < skins.vertex_count(); ++v) places.push_back(points.row(v));
    }
    for (int t = 0; t < skins.triangles.rows(); ++t) {
        triangles_.push_back({skins.triangles(t, 0), skins.triangles(t, 1), skins.triangles(t, 2)});
        attach(t);
    }
    gone_.assign(triangles_.size(), 0);
}

void SkinEditor::attach(int triangle) {
    for (const int v : triangles_[triangle]) around_[v].push_back(triangle);
}

void SkinEditor::detach(int triangle) {
    for (const int v : triangles_[triangle]) std::erase(around_[v], triangle);
}

void SkinEditor::replace(int triangle, const Corners& corners) {
    detach(triangle);
    triangles_[triangle] = corners;
    attach(triangle);
}

std::vector<std::pair<int, int>> SkinEditor::edges() const {
    std::vector<std::pair<int, int>> all;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        if (!gone_[t])
            for (int k = 0; k < 3; ++k) all.emplace_back(std::minmax(triangles_[t][k], triangles_[t][(k + 1) % 3]));
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

SkinEditor::Sides SkinEditor::sides(int a, int b) const {
    Sides found;
    for (const int t : around_[a])
        for (int k = 0; k < 3; ++k) {
            const Corners& c = triangles_[t];
            const int from = c[k], to = c[(k + 1) % 3], corner = c[(k + 2) % 3];
            if (from == a && to == b) {
                found.sound = found.sound && found.left < 0;
                found.left = t;
                found.left_corner = corner;
            } else if (from == b && to == a) {
                found.sound = found.sound && found.right < 0;
                found.right = t;
                found.right_corner = corner;
            }
        }
    return found;
}

std::vector<int> SkinEditor::ring(int v) const {
    std::vector<int> all;
    for (const int t : around_[v])
        for (const int w : triangles_[t])
            if (w != v) all.push_back(w);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// Around an inner vertex every neighbour stands in two triangles.
bool SkinEditor::on_border(int v) const { return ring(v).size() != around_[v].size(); }

Vector3d SkinEditor::normal(const Corners& corners, const Places& p) {
    return (p[corners[1]] - p[corners[0]]).cross(p[corners[2]] - p[corners[0]]);
}

bool SkinEditor::split(int a, int b) {
    const Sides at = sides(a, b);
    if (!at.sound || (at.left < 0 && at.right < 0)) return false;
    if (curves_ && !curves_->may_split(a, b)) return false;
    const int middle = static_cast<int>(around_.size());
    if (curves_) curves_->split(a, b, middle);
    for (Places& p : points_) p.push_back(((p[a] + p[b]) / 2).eval());
    lengths_.push_back((lengths_[a] + lengths_[b]) / 2);
    marker_.push_back(-1);
    around_.emplace_back();
    ++vertices_;
    for (const int t : {at.left, at.right}) {
        if (t < 0) continue;
        Corners first = triangles_[t], second = first;
        std::replace(first.begin(), first.end(), b, middle);
        std::replace(second.begin(), second.end(), a, middle);
        replace(t, first);
        triangles_.push_back(second);
        gone_.push_back(0);
        attach(static_cast<int>(triangles_.size()) - 1);
    }
    return true;
}

bool SkinEditor::harms(int v, int other, const Vector3d& place, const Places& p) const {
    for (const int t : around_[v]) {
        const Corners& c = triangles_[t];
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
    const Sides at = sides(a, b);
    if (!at.sound || (at.left < 0 && at.right < 0)) return false;
    if (marker_[a] >= 0 && marker_[b] >= 0) return false;
    const bool border_a = on_border(a), border_b = on_border(b), along = !at.inner();
    if (border_a && border_b && !along) return false; // would pinch the surface
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
    const std::vector<int> ring_a = ring(a), ring_b = ring(b);
    std::vector<int> common;
    std::set_intersection(ring_a.begin(), ring_a.end(), ring_b.begin(), ring_b.end(), std::back_inserter(common));
    if (std::ssize(common) != (at.left >= 0) + (at.right >= 0)) return false; // link condition
    for (const int corner : common)
        if (around_[corner].size() <= (on_border(corner) ? 1u : 3u)) return false; // would be left without a fan
    const auto place = [&](const Places& p) -> Vector3d { return (1 - part) * p[kept] + part * p[taken]; };
    for (const Places& p : points_)
        if (harms(kept, taken, place(p), p) || harms(taken, kept, place(p), p)) return false;
    for (Places& p : points_) p[kept] = place(p);
    for (const int t : {at.left, at.right})
        if (t >= 0) {
            detach(t);
            gone_[t] = 1;
        }
    for (const int t : std::vector<int>(around_[taken])) {
        Corners corners = triangles_[t];
        std::replace(corners.begin(), corners.end(), taken, kept);
        replace(t, corners);
    }
    if (curves_) curves_->collapse(kept, taken);
    --vertices_;
    return true;
}

bool SkinEditor::swap_if_better(int a, int b) {
    const Sides at = sides(a, b);
    if (!at.inner()) return false;
    const int p = at.left_corner, q = at.right_corner;
    if (p == q || (curves_ && !curves_->may_swap(a, b))) return false;
    // Criterion 3: the largest angle has the smallest cosine.
    double before = 1, after = 1;
    for (const Places& x : points_) {
        before = std::min({before, facing_cosine(x[p], x[a], x[b]), facing_cosine(x[q], x[a], x[b])});
        after = std::min({after, facing_cosine(x[a], x[p], x[q]), facing_cosine(x[b], x[p], x[q])});
    }
    if (!(after > before + k_better)) return false;
    if (around_[a].size() <= 3 || around_[b].size() <= 3) return false;
    const std::vector<int> near = ring(p);
    if (std::binary_search(near.begin(), near.end(), q)) return false;
    const Corners first{a, q, p}, second{q, b, p}; // of (a, b, p) and (b, a, q)
    for (const Places& x : points_) {
        const Vector3d old = normal(triangles_[at.left], x) + normal(triangles_[at.right], x);
        for (const Corners& corners : {first, second}) {
            const Vector3d fresh = normal(corners, x);
            if (!(fresh.dot(old) > k_swap_turn * fresh.norm() * old.norm())) return false;
        }
    }
    replace(at.left, first);
    replace(at.right, second);
    return true;
}

SkinSet SkinEditor::take() const {
    SkinSet skins;
    std::vector<int> place(around_.size(), -1);
    for (std::size_t v = 0; v < around_.size(); ++v) {
        if (around_[v].empty() && marker_[v] < 0) continue;
        place[v] = skins.vertex_count();
        skins.marker.push_back(marker_[v]);
    }
    skins.curves = curves_;
    if (skins.curves) skins.curves->renumber(place, skins.vertex_count());
    for (const Places& p : points_) {
        Points& points = skins.points.emplace_back(skins.vertex_count(), 3);
        for (std::size_t v = 0; v < around_.size(); ++v)
            if (place[v] >= 0) points.row(place[v]) = p[v].transpose();
    }
    skins.triangles.resize(static_cast<Eigen::Index>(std::count(gone_.begin(), gone_.end(), 0)), 3);
    int row = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        if (gone_[t]) continue;
        for (int k = 0; k < 3; ++k) skins.triangles(row, k) = place[triangles_[t][k]];
        ++row;
    }
    return skins;
}

} // namespace lissom
