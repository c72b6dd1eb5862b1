#include "lissom/merge/optimal_boundary.h"

#include "lissom/merge/ring_cycle.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/polar.h"
#include "lissom/mesh/surface_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace lissom {
namespace {

using Eigen::Matrix3d;
using Eigen::RowVector3d;
using Eigen::Vector3d;

/// What a boundary costs, edge by edge. A similarity acts on edges by its linear part alone.
class Energy {
public:
    Energy(const RegionMaps& maps, const Placement& placement) : maps_(maps), locator_(maps.disk_map, maps.disk.triangles) {
        outline_ = placement(maps.ring_map);
        images_.resize(maps.ring.vertex_count(), 3);
        normals_ = vertex_normals(maps.ring);
        image_normals_ = Points::Zero(maps.ring.vertex_count(), 3);
        const Points disk_normals = vertex_normals(maps.disk);
        for (int v = 0; v < maps.ring.vertex_count(); ++v) {
            places_.push_back(locator_.locate(outline_.row(v).transpose()));
            images_.row(v).setZero();
            if (const PlanePlace& place = places_.back(); place.triangle >= 0)
                for (int c = 0; c < 3; ++c) {
                    images_.row(v) += place.weight[c] * maps.disk.points.row(maps.disk.triangles(place.triangle, c));
                    image_normals_.row(v) += place.weight[c] * disk_normals.row(maps.disk.triangles(place.triangle, c));
                }
            image_normals_.row(v).stableNormalize();
        }
    }

    [[nodiscard]] bool is_inside(int v) const { return places_[v].triangle >= 0; }
    [[nodiscard]] const PlanePlace& place(int v) const { return places_[v]; }
    [[nodiscard]] const PlanePoints& outline() const { return outline_; }

    [[nodiscard]] double of_edge(int a, int b, const Matrix3d& A) const {
        if (!is_inside(a) || !is_inside(b)) return std::numeric_limits<double>::infinity();
        const Vector3d e = edge(maps_.ring.points, a, b), n = normal(normals_, a, b, e.norm()), image = normal(image_normals_, a, b, 1);
        const Vector3d turned = A * n - (A * n).norm() * image;
        return std::sqrt((A * e - edge(images_, a, b)).squaredNorm() + turned.squaredNorm()) * e.norm();
    }
    [[nodiscard]] double of_loop(const std::vector<int>& loop, const Matrix3d& A) const {
        double sum = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) sum += of_edge(loop[i], loop[(i + 1) % loop.size()], A);
        return sum;
    }

    /// Fu 3.4.3, step 2: the rotation of the closed form, the scale of the average edge lengths.
    [[nodiscard]] Similarity closed_form(const std::vector<int>& loop) const {
        Points from(std::ssize(loop), 3), to(std::ssize(loop), 3);
        double length = 0, image_length = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            from.row(static_cast<Eigen::Index>(i)) = maps_.ring.points.row(loop[i]);
            to.row(static_cast<Eigen::Index>(i)) = images_.row(loop[i]);
            length += edge(maps_.ring.points, loop[i], loop[(i + 1) % loop.size()]).norm();
            image_length += edge(images_, loop[i], loop[(i + 1) % loop.size()]).norm();
        }
        Similarity map = fit_similarity(from, to);
        if (length > 0 && image_length > 0) map.scale = image_length / length;
        map.translation = to.colwise().mean().transpose() - map.scale * map.rotation * from.colwise().mean().transpose();
        return map;
    }

    /// The best of several starts, each improved by least squares with weights that turn squares into lengths.
    [[nodiscard]] Similarity best_map(const std::vector<int>& loop, const std::vector<Similarity>& starts) const {
        Similarity best;
        double least = std::numeric_limits<double>::infinity();
        for (Similarity map : starts) {
            double energy = of_loop(loop, linear(map));
            for (int round = 0; round < 30; ++round) {
                const Similarity next = reweighted(loop, map);
                const double there = of_loop(loop, linear(next));
                if (!(there < energy * (1 - 1e-10))) break;
                map = next;
                energy = there;
            }
            if (energy < least) {
                least = energy;
                best = map;
            }
        }
        return best;
    }

    [[nodiscard]] static Matrix3d linear(const Similarity& map) { return map.scale * map.rotation; }

private:
    [[nodiscard]] static Vector3d edge(const Points& points, int a, int b) { return (points.row(b) - points.row(a)).transpose(); }

    /// Of an edge: the mean of its ends', of the length given.
    [[nodiscard]] static Vector3d normal(const Points& normals, int a, int b, double length) {
        const Vector3d sum = (normals.row(a) + normals.row(b)).transpose();
        return sum.norm() > 0 ? Vector3d(sum * (length / sum.norm())) : Vector3d(Vector3d::Zero());
    }

    [[nodiscard]] Similarity reweighted(const std::vector<int>& loop, const Similarity& map) const {
        Matrix3d C = Matrix3d::Zero(), N = Matrix3d::Zero();
        double spread = 0, mean = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) mean += edge(images_, loop[i], loop[(i + 1) % loop.size()]).norm() / static_cast<double>(loop.size());
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vector3d e = edge(maps_.ring.points, loop[i], loop[(i + 1) % loop.size()]), image = edge(images_, loop[i], loop[(i + 1) % loop.size()]);
            const Vector3d n = normal(normals_, loop[i], loop[(i + 1) % loop.size()], e.norm()), image_n = normal(image_normals_, loop[i], loop[(i + 1) % loop.size()], map.scale * e.norm());
            const double error = std::sqrt((linear(map) * e - image).squaredNorm() + (linear(map) * n - image_n).squaredNorm());
            const double weight = e.norm() / std::max(error, 1e-9 * mean);
            C += weight * image * e.transpose();
            N += weight * image_n * n.transpose();
            spread += weight * e.squaredNorm();
        }
        Similarity next = map;
        if (!(spread > 0)) return next;
        next.rotation = nearest_rotation(C + N);
        const double scale = next.rotation.cwiseProduct(C).sum() / spread;
        if (scale > 0) next.scale = scale;
        return next;
    }

    const RegionMaps& maps_;
    PlaneLocator locator_;
    PlanePoints outline_;
    std::vector<PlanePlace> places_;
    Points images_, normals_, image_normals_;
};

} // namespace

Placement best_placement(const RegionMaps& maps) {
    double room = std::numeric_limits<double>::infinity(), reach = 0;
    for (std::size_t i = 0; i < maps.border.size(); ++i) {
        const Eigen::RowVector2d a = maps.disk_map.row(maps.border[i]), b = maps.disk_map.row(maps.border[(i + 1) % maps.border.size()]);
        const double f = (b - a).squaredNorm() > 0 ? std::clamp(-a.dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) : 0;
        room = std::min(room, (a + f * (b - a)).norm());
    }
    for (const int v : maps.outer) reach = std::max(reach, maps.ring_map.row(v).norm());
    Placement best, placement;
    placement.scale = reach > 0 ? 0.9 * room / reach : 1;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 72; ++k) {
        placement.turn = 5.0 * k;
        const Energy energy(maps, placement);
        const Similarity map = energy.closed_form(maps.outer);
        if (const double value = energy.of_loop(maps.outer, Energy::linear(map)); value < least * (1 - 1e-6) || k == 0) {
            least = value;
            best = placement;
        }
    }
    return best;
}

OptimalBoundary optimal_boundary(const RegionMaps& maps, const Placement& placement, int rounds) {
    const Energy energy(maps, placement);
    const auto outside = std::count_if(maps.outer.begin(), maps.outer.end(), [&](int v) { return !energy.is_inside(v); });
    if (outside > 0)
        throw InvalidInput("placement-outside", "The source region does not fit into the target region as placed: " + std::to_string(outside) + " of " +
                                                    std::to_string(maps.outer.size()) + " points of its edge fall outside. Move or shrink it, or paint more of the target.");
    const std::vector<int> across = path_across(maps.ring, maps.outer, maps.inner); // cut C of Fu fig. 3.8
    if (across.empty()) throw InvalidInput("region-not-a-ring", "There is no way across the source region from its edge to the feature. Paint the region wider.");
    const SlitRing slit = slit_ring(maps.ring, across);
    WeightedGraph graph = edge_graph(slit.mesh);

    std::vector<int> loop = maps.outer;
    OptimalBoundary out;
    out.map = energy.best_map(loop, {energy.closed_form(loop)});
    out.energies.push_back(energy.of_loop(loop, Energy::linear(out.map)));
    for (int round = 0; round < rounds; ++round) {
        for (int v = 0; v < graph.size(); ++v)
            for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
                graph.lengths[e] = energy.of_edge(slit.original[v], slit.original[graph.ends[e]], Energy::linear(out.map));
        const RingCycle cycle = cheapest_cycle(graph, slit.left, slit.right);
        if (cycle.path.empty()) break;
        std::vector<int> next;
        for (std::size_t i = 0; i + 1 < cycle.path.size(); ++i) next.push_back(slit.original[cycle.path[i]]);
        const Similarity map = energy.best_map(next, {out.map, energy.closed_form(next)});
        const double value = energy.of_loop(next, Energy::linear(map)), last = out.energies.back();
        if (!(value < last)) break;
        loop = std::move(next);
        out.map = map;
        out.energies.push_back(value);
        if (value > last * (1 - 1e-6)) break;
    }
    // The outer border has the ring, and so the feature, to its left; a cycle may run either way.
    double turn = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::RowVector2d a = maps.ring_map.row(loop[i]), b = maps.ring_map.row(loop[(i + 1) % loop.size()]);
        turn += a.x() * b.y() - a.y() * b.x();
    }
    if (turn < 0) std::reverse(loop.begin(), loop.end());
    out.outline.resize(std::ssize(loop), 2);
    for (std::size_t i = 0; i < loop.size(); ++i) {
        out.loop.push_back(maps.ring_vertices[loop[i]]);
        out.places.push_back(energy.place(loop[i]));
        out.outline.row(static_cast<Eigen::Index>(i)) = energy.outline().row(loop[i]);
    }
    return out;
}

} // namespace lissom
