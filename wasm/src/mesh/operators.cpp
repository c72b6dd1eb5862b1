#include "lissom/mesh/operators.h"

#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lissom {

namespace {

/// A triangle counts as at least this much height per longest edge, so a cotangent stays below 1e4.
/// Larger ones, squared in a bilaplacian, would cost half the digits of a double; angles that small
/// (0.006 degrees) carry no shape anyway.
constexpr double k_height_floor = 1e-4;

/// Below this height per longest edge a triangle's normal is rounding error.
constexpr double k_flat = 1e-14;

/// What the operators need of one triangle.
struct Corners {
    std::array<Eigen::Vector3d, 3> side; ///< side[k] lies opposite corner k
    Eigen::Vector3d cross;               ///< normal with length twice the area
    double longest2 = 0;                 ///< squared length of the longest side

    Corners(const TriangleMesh& mesh, int t) {
        const auto p = [&](int k) -> Eigen::Vector3d { return mesh.points.row(mesh.triangles(t, k % 3)); };
        for (int k = 0; k < 3; ++k) {
            side[k] = p(k + 2) - p(k + 1);
            longest2 = std::max(longest2, side[k].squaredNorm());
        }
        cross = side[0].cross(side[1]);
    }
    /// |a||b|cos of the angle at corner k
    [[nodiscard]] double dot(int k) const { return -side[(k + 1) % 3].dot(side[(k + 2) % 3]); }
    /// Cotangent at corner k. All three share one floored denominator: the triangle's stiffness is then the
    /// exact one times a factor in [0, 1], so it stays semi-definite.
    [[nodiscard]] double cotangent(int k) const {
        return longest2 > 0 ? dot(k) / std::max(cross.norm(), k_height_floor * longest2) : 0;
    }
};

} // namespace

double diagonal(const Points& points) {
    return points.rows() < 2 ? 0 : (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

double mean_edge_length(const TriangleMesh& mesh) {
    const std::vector<Edge> all = edges(mesh);
    double sum = 0;
    for (const Edge& e : all)
        sum += (mesh.points.row(e.a) - mesh.points.row(e.b)).norm();
    return all.empty() ? 0 : sum / static_cast<double>(all.size());
}

Eigen::VectorXd triangle_areas(const TriangleMesh& mesh) {
    Eigen::VectorXd areas(mesh.triangle_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        areas[t] = 0.5 * Corners(mesh, t).cross.norm();
    return areas;
}

double signed_volume(const TriangleMesh& mesh) {
    if (mesh.triangle_count() == 0)
        return 0;
    // Measured from a vertex of the mesh, not from the origin, which may lie far away.
    const Eigen::Vector3d base = mesh.points.row(mesh.triangles(0, 0));
    double sum = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const auto p = [&](int k) -> Eigen::Vector3d {
            return mesh.points.row(mesh.triangles(t, k)).transpose() - base;
        };
        sum += p(0).dot(p(1).cross(p(2)));
    }
    return sum / 6;
}

Points vertex_normals(const TriangleMesh& mesh) {
    Points normals = Points::Zero(mesh.vertex_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Corners c(mesh, t);
        const double twice_area = c.cross.norm();
        if (!(twice_area > k_flat * c.longest2))
            continue;
        for (int k = 0; k < 3; ++k)
            normals.row(mesh.triangles(t, k)) += std::atan2(twice_area, c.dot(k)) / twice_area * c.cross.transpose();
    }
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const double length = normals.row(v).norm();
        // Two sides of one sheet cancel but for rounding: no direction is better than a random one.
        if (length > 1e-12)
            normals.row(v) /= length;
        else
            normals.row(v).setZero();
    }
    return normals;
}

Eigen::VectorXd vertex_areas(const TriangleMesh& mesh) {
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Corners c(mesh, t);
        const double twice_area = c.cross.norm();
        int obtuse = -1;
        for (int k = 0; k < 3; ++k)
            if (c.dot(k) < 0)
                obtuse = k;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            double share = 0;
            if (obtuse >= 0 || !(twice_area > k_flat * c.longest2)) // Meyer et al. 2003, the mixed cell
                share = twice_area * (k == obtuse ? 0.25 : 0.125);
            else // Meyer et al. 2003, the Voronoi cell: one triangle's part
                share = (c.side[i].squaredNorm() * c.dot(i) + c.side[j].squaredNorm() * c.dot(j)) / (8 * twice_area);
            areas[mesh.triangles(t, k)] += share;
        }
    }
    return areas.size() == 0 ? areas : areas.cwiseMax(1e-6 * areas.mean()).eval();
}

SparseMatrix cotangent_laplacian(const TriangleMesh& mesh) {
    struct Weight {
        int a, b;
        double value;
    };
    const int n = mesh.vertex_count();
    std::vector<Weight> weights;
    std::vector<int> per_column(n, 1);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(n);
    const std::vector<HalfEdge> sides = half_edges(mesh);
    for_each_edge(sides, [&](auto first, auto last) {
        double value = 0;
        for (auto side = first; side != last; ++side)
            value += 0.5 * Corners(mesh, side->triangle).cotangent((side->corner + 2) % 3);
        weights.push_back({first->a, first->b, value});
        for (const int v : {first->a, first->b}) {
            ++per_column[v];
            sums[v] += value;
        }
    });

    // Edges come ordered by (a, b), so every column is filled from the top: above, on and below the diagonal.
    SparseMatrix laplacian(n, n);
    laplacian.reserve(per_column);
    for (const Weight& w : weights)
        laplacian.insert(w.a, w.b) = w.value;
    for (int v = 0; v < n; ++v)
        laplacian.insert(v, v) = -sums[v];
    for (const Weight& w : weights)
        laplacian.insert(w.b, w.a) = w.value;
    laplacian.makeCompressed();
    return laplacian;
}

} // namespace lissom
