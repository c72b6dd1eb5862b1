#include "sharp_truth.h"

#include "lissom/mesh/topology.h"
#include "lissom/mesh/triangle_tree.h"

#include <algorithm>
#include <map>

namespace sharp_truth {

using namespace lissom;

Error error(const std::vector<SharpLine>& lines, const Points& skin, const std::vector<SharpPath>& paths, double diagonal) {
    TriangleMesh edges{skin, Triangles(0, 3)};
    for (const SharpPath& path : paths)
        for (std::size_t i = 0; i + 1 < path.curve.vertices.size(); ++i) {
            edges.triangles.conservativeResize(edges.triangles.rows() + 1, 3);
            edges.triangles.row(edges.triangles.rows() - 1) << path.curve.vertices[i], path.curve.vertices[i + 1], path.curve.vertices[i + 1];
        }
    const TriangleTree tree(edges);
    double sum = 0, most = 0;
    int count = 0;
    for (const SharpLine& line : lines) {
        const Eigen::Index n = line.points.rows();
        for (Eigen::Index i = 0; i < n - (line.closed ? 0 : 1); ++i)
            for (int k = 0; k <= 4; ++k) {
                const double d = tree.nearest(((4 - k) * line.points.row(i) + k * line.points.row((i + 1) % n)).transpose() / 4).distance / diagonal;
                sum += d;
                most = std::max(most, d);
                ++count;
            }
    }
    return {sum / count, most};
}

bool are_single(const TriangleMesh& skin, const std::vector<SharpPath>& paths) {
    const VertexRings rings = vertex_rings(skin);
    std::map<int, int> inside, ends;
    for (const SharpPath& path : paths) {
        const std::vector<int>& v = path.curve.vertices;
        for (std::size_t i = 0; i + 1 < v.size(); ++i)
            if (!std::binary_search(rings[v[i]].begin(), rings[v[i]].end(), v[i + 1])) return false;
        for (std::size_t i = 0; i < v.size(); ++i) ++(i == 0 || i + 1 == v.size() ? ends : inside)[v[i]];
    }
    return std::all_of(inside.begin(), inside.end(), [&](const auto& at) { return at.second == 1 && !ends.contains(at.first); });
}

} // namespace sharp_truth
