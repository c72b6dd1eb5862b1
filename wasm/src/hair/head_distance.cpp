#include "lissom/hair/head_distance.h"

#include "lissom/mesh/capped.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/nearest_on_triangle.h"
#include "lissom/mesh/operators.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace lissom {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr double k_band = 2.5; // cells on either side of the surface whose samples are exact

/// Normals of the corners, edges and inside of each triangle, by feature number.
class PseudoNormals {
public:
    explicit PseudoNormals(const TriangleMesh& mesh) : mesh_(mesh), corners_(vertex_normals(mesh)) {
        for (int t = 0; t < mesh.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k) {
                auto [at, fresh] = edges_.try_emplace(edge(t, k), Vector3d::Zero());
                at->second += face(t);
            }
    }

    [[nodiscard]] Vector3d operator()(int t, int feature) const {
        if (feature < 3) return corners_.row(mesh_.triangles(t, feature)).transpose();
        return feature < 6 ? edges_.at(edge(t, feature - 3)) : face(t);
    }

private:
    [[nodiscard]] Vector3d face(int t) const {
        const Vector3d a = mesh_.points.row(mesh_.triangles(t, 0)), b = mesh_.points.row(mesh_.triangles(t, 1)),
                       c = mesh_.points.row(mesh_.triangles(t, 2));
        return (b - a).cross(c - a).normalized();
    }
    [[nodiscard]] std::pair<int, int> edge(int t, int opposite) const {
        return std::minmax(int(mesh_.triangles(t, (opposite + 1) % 3)), int(mesh_.triangles(t, (opposite + 2) % 3)));
    }

    const TriangleMesh& mesh_;
    Points corners_;
    std::map<std::pair<int, int>, Vector3d> edges_;
};

constexpr float k_far = std::numeric_limits<float>::max();

/// Exact signed distances at the nodes near the surface; k_far elsewhere.
std::vector<float> band(const TriangleMesh& mesh, const Grid& grid) {
    const PseudoNormals normals(mesh);
    const double reach = k_band * grid.step;
    std::vector<float> out(static_cast<std::size_t>(grid.count()), k_far);
    std::vector<double> best(out.size(), reach * reach);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vector3d a = mesh.points.row(mesh.triangles(t, 0)), b = mesh.points.row(mesh.triangles(t, 1)),
                       c = mesh.points.row(mesh.triangles(t, 2));
        if ((b - a).cross(c - a).squaredNorm() == 0) continue;
        const Vector3d low = grid.local(a.cwiseMin(b).cwiseMin(c)).array() - k_band;
        const Vector3d high = grid.local(a.cwiseMax(b).cwiseMax(c)).array() + k_band;
        const Vector3i from = low.array().ceil().max(0.0).cast<int>();
        const Vector3i to = high.array().floor().min((grid.size.array() - 1).cast<double>()).cast<int>();
        for (int z = from.z(); z <= to.z(); ++z)
            for (int y = from.y(); y <= to.y(); ++y)
                for (int x = from.x(); x <= to.x(); ++x) {
                    const int node = grid.node(x, y, z);
                    const auto at = static_cast<std::size_t>(node);
                    const Vector3d p = grid.position(node);
                    const NearestOnTriangle near = nearest_on_triangle(p, a, b, c);
                    const double squared = (p - near.point).squaredNorm();
                    if (squared >= best[at]) continue;
                    best[at] = squared;
                    const bool outside = (p - near.point).dot(normals(t, near.feature)) >= 0;
                    out[at] = static_cast<float>(outside ? std::sqrt(squared) : -std::sqrt(squared));
                }
    }
    return out;
}

/// The nodes that can be reached from the grid's walls without passing a sample of the band.
std::vector<char> outside_nodes(const std::vector<float>& samples, const Grid& grid) {
    std::vector<char> outside(samples.size(), 0);
    std::vector<int> open;
    const auto visit = [&](int x, int y, int z) {
        const int node = grid.node(x, y, z);
        char& seen = outside[static_cast<std::size_t>(node)];
        if (seen || samples[static_cast<std::size_t>(node)] != k_far) return;
        seen = 1;
        open.push_back(node);
    };
    const Vector3i n = grid.size;
    for (int z = 0; z < n.z(); ++z)
        for (int y = 0; y < n.y(); ++y)
            for (int x = 0; x < n.x(); ++x)
                if (x == 0 || y == 0 || z == 0 || x == n.x() - 1 || y == n.y() - 1 || z == n.z() - 1) visit(x, y, z);
    while (!open.empty()) {
        const Vector3i at = grid.cell(open.back());
        open.pop_back();
        for (int d = 0; d < 3; ++d)
            for (const int by : {-1, 1}) {
                Vector3i next = at;
                next[d] += by;
                if (next[d] >= 0 && next[d] < n[d]) visit(next.x(), next.y(), next.z());
            }
    }
    return outside;
}

/// One upwind step of |∇u| = 1 from the smallest neighbour along each axis.
double eikonal(double a, double b, double c, double h) {
    double v[3] = {a, b, c};
    std::sort(v, v + 3);
    double u = v[0] + h;
    if (u > v[1]) {
        u = 0.5 * (v[0] + v[1] + std::sqrt(std::max(0.0, 2 * h * h - (v[0] - v[1]) * (v[0] - v[1]))));
        if (u > v[2]) {
            const double s = v[0] + v[1] + v[2], q = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            u = (s + std::sqrt(std::max(0.0, s * s - 3 * (q - h * h)))) / 3;
        }
    }
    return u;
}

/// Carries |distance| from the band to everywhere: eight sweeping directions, each once.
void sweep(std::vector<float>& samples, const std::vector<char>& known, const Grid& grid) {
    const Vector3i n = grid.size;
    const auto value = [&](int x, int y, int z) -> double {
        return std::abs(samples[static_cast<std::size_t>(grid.node(x, y, z))]);
    };
    for (int pass = 0; pass < 8; ++pass) {
        const bool dx = pass & 1, dy = pass & 2, dz = pass & 4;
        for (int k = 0; k < n.z(); ++k)
            for (int j = 0; j < n.y(); ++j)
                for (int i = 0; i < n.x(); ++i) {
                    const int x = dx ? n.x() - 1 - i : i, y = dy ? n.y() - 1 - j : j, z = dz ? n.z() - 1 - k : k;
                    const auto at = static_cast<std::size_t>(grid.node(x, y, z));
                    if (known[at]) continue;
                    const double a = std::min(x > 0 ? value(x - 1, y, z) : k_far, x + 1 < n.x() ? value(x + 1, y, z) : k_far);
                    const double b = std::min(y > 0 ? value(x, y - 1, z) : k_far, y + 1 < n.y() ? value(x, y + 1, z) : k_far);
                    const double c = std::min(z > 0 ? value(x, y, z - 1) : k_far, z + 1 < n.z() ? value(x, y, z + 1) : k_far);
                    if (std::min({a, b, c}) == k_far) continue;
                    const double u = eikonal(a, b, c, grid.step);
                    if (u < std::abs(samples[at])) samples[at] = static_cast<float>(samples[at] < 0 ? -u : u);
                }
    }
}

} // namespace

HeadDistance::HeadDistance(const TriangleMesh& head, const Grid& grid) : grid_(grid) {
    if (head.triangle_count() == 0 || triangle_areas(head).sum() <= 0)
        throw InvalidInput("head-empty", "the head has no triangle with area, so there is nothing for hair to grow on");
    samples_ = band(capped(head), grid);
    const std::vector<char> outside = outside_nodes(samples_, grid);
    std::vector<char> known(samples_.size());
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        known[i] = samples_[i] != k_far;
        if (!known[i] && !outside[i]) samples_[i] = -k_far;
    }
    sweep(samples_, known, grid);
}

HeadDistance::Sample HeadDistance::sample(const Vector3d& p) const {
    const Vector3d q = grid_.local(p);
    const Vector3d inside = q.array().max(0.0).min((grid_.size.array() - 1).cast<double>());
    const int x = std::min(static_cast<int>(inside.x()), grid_.size.x() - 2),
              y = std::min(static_cast<int>(inside.y()), grid_.size.y() - 2),
              z = std::min(static_cast<int>(inside.z()), grid_.size.z() - 2);
    const double u = inside.x() - x, v = inside.y() - y, w = inside.z() - z;
    const auto row = static_cast<std::size_t>(grid_.size.x()), slab = row * static_cast<std::size_t>(grid_.size.y());
    const float* s = samples_.data() + static_cast<std::size_t>(grid_.node(x, y, z));
    const double s000 = s[0], s100 = s[1], s010 = s[row], s110 = s[row + 1], s001 = s[slab], s101 = s[slab + 1],
                 s011 = s[slab + row], s111 = s[slab + row + 1];
    const double x00 = s000 + u * (s100 - s000), x10 = s010 + u * (s110 - s010), x01 = s001 + u * (s101 - s001),
                 x11 = s011 + u * (s111 - s011);
    const double y0 = x00 + v * (x10 - x00), y1 = x01 + v * (x11 - x01);
    const Vector3d gradient((1 - w) * ((1 - v) * (s100 - s000) + v * (s110 - s010)) +
                                w * ((1 - v) * (s101 - s001) + v * (s111 - s011)),
                            (1 - w) * (x10 - x00) + w * (x11 - x01), y1 - y0);
    return {y0 + w * (y1 - y0) + (q - inside).norm() * grid_.step, gradient / grid_.step};
}

double HeadDistance::at(const Vector3d& p) const { return sample(p).distance; }

Vector3d HeadDistance::gradient(const Vector3d& p) const { return sample(p).gradient; }

} // namespace lissom
