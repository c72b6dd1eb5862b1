#include "lissom/mesh/plane_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

namespace {

using EdgeName = std::pair<int, int>;

struct Piece {
    std::array<EdgeName, 2> ends;
};

/// Length, area and centroid of a line whose points are known.
void measure(SectionLine& line, const Vector3d& normal) {
    const std::size_t n = line.points.size(), sides = line.closed ? n : n - 1;
    const Vector3d origin = line.points.front();
    Vector3d along = Vector3d::Zero(), moment = Vector3d::Zero();
    double area = 0;
    for (std::size_t i = 0; i < sides; ++i) {
        const Vector3d a = line.points[i] - origin, b = line.points[(i + 1) % n] - origin;
        const double length = (b - a).norm(), twice = normal.dot(a.cross(b));
        line.length += length;
        along += length * (a + b) / 2;
        area += twice / 2;
        moment += twice / 2 * (a + b) / 3;
    }
    line.centroid = origin + (line.length > 0 ? Vector3d(along / line.length) : Vector3d(Vector3d::Zero()));
    if (!line.closed) return;
    line.area = std::abs(area);
    // A line that is folded onto itself encloses nothing: its own centre then.
    if (line.area > 1e-9 * line.length * line.length) line.centroid = origin + moment / area;
}

bool encloses(const SectionLine& line, const Vector3d& normal, const Vector3d& p) {
    double turn = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vector3d a = line.points[i] - p, b = line.points[(i + 1) % line.points.size()] - p;
        turn += std::atan2(normal.dot(a.cross(b)), a.dot(b));
    }
    return std::abs(turn) > std::numbers::pi;
}

} // namespace

double SectionLine::radius() const { return closed ? std::sqrt(area / std::numbers::pi) : length / 2; }

double SectionLine::nearest(const Vector3d& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
        const Vector3d a = points[i], b = points[(i + 1) % points.size()] - a;
        const double share = b.squaredNorm() > 0 ? std::clamp((p - a).dot(b) / b.squaredNorm(), 0.0, 1.0) : 0;
        least = std::min(least, (a + share * b - p).norm());
    }
    return least;
}

double SectionLine::farthest(const Vector3d& p) const {
    double most = 0;
    for (const Vector3d& q : points) most = std::max(most, (q - p).norm());
    return most;
}

std::vector<SectionLine> plane_section(const TriangleMesh& mesh, const TriangleTree& tree, const Vector3d& normal, const Vector3d& at) {
    const double offset = normal.dot(at);
    const auto height = [&](int v) { return mesh.points.row(v).dot(normal) - offset; };
    std::vector<Piece> pieces;
    std::map<EdgeName, std::vector<int>> at_edge;
    for (const int t : tree.crossed(normal, offset)) {
        Piece piece;
        int found = 0;
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.triangles(t, k), b = mesh.triangles(t, (k + 1) % 3);
            if ((height(a) > 0) != (height(b) > 0) && found < 2) piece.ends[found++] = std::minmax(a, b);
        }
        if (found < 2) continue;
        for (const EdgeName& end : piece.ends) at_edge[end].push_back(static_cast<int>(pieces.size()));
        pieces.push_back(piece);
    }
    std::vector<char> used(pieces.size(), 0);
    const auto next = [&](const EdgeName& edge) {
        for (const int p : at_edge[edge])
            if (!used[p]) return p;
        return -1;
    };
    const auto place = [&](const EdgeName& edge) -> Vector3d {
        const double a = height(edge.first), b = height(edge.second);
        return mesh.points.row(edge.first).transpose() + a / (a - b) * (mesh.points.row(edge.second) - mesh.points.row(edge.first)).transpose();
    };
    std::vector<SectionLine> lines;
    for (std::size_t first = 0; first < pieces.size(); ++first) {
        if (used[first]) continue;
        used[first] = 1;
        std::vector<EdgeName> chain{pieces[first].ends[0], pieces[first].ends[1]};
        bool closed = false;
        for (const bool forward : {true, false}) {
            for (int p = next(chain.back()); p >= 0 && !closed; p = next(chain.back())) {
                used[p] = 1;
                const auto& [a, b] = pieces[p].ends;
                const EdgeName end = a == chain.back() ? b : a;
                closed = end == chain.front();
                if (!closed) chain.push_back(end);
            }
            if (closed) break;
            if (forward) std::reverse(chain.begin(), chain.end());
        }
        SectionLine line;
        line.closed = closed;
        for (const EdgeName& edge : chain) line.points.push_back(place(edge));
        measure(line, normal);
        lines.push_back(std::move(line));
    }
    return lines;
}

int line_around(const std::vector<SectionLine>& lines, const Vector3d& normal, const Vector3d& p) {
    int around = -1, near = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int l = 0; l < static_cast<int>(lines.size()); ++l) {
        if (lines[l].closed && encloses(lines[l], normal, p) && (around < 0 || lines[l].area < lines[around].area)) around = l;
        if (const double distance = lines[l].nearest(p); distance < least) {
            least = distance;
            near = l;
        }
    }
    return around >= 0 ? around : near;
}

} // namespace lissom
