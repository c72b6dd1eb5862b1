#include "posing.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/self_intersections.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace posing {

using Eigen::Vector3d;

CurveSession session(const TriangleMesh& mesh, std::vector<CurveSpec> curves, std::vector<lissom::CurveLink> links, CurveOptions options) {
    CurveSession made(std::make_shared<lissom::WorkingMesh>(shapes::working(mesh)), std::move(curves), std::move(links), options);
    while (made.step()) {}
    return made;
}

Points line(const Vector3d& from, const Vector3d& to, int count) {
    Points points(count, 3);
    for (int i = 0; i < count; ++i) points.row(i) = (from + (to - from) * i / (count - 1)).transpose();
    return points;
}

Points row_list(const std::vector<Vector3d>& list) {
    Points points(static_cast<int>(list.size()), 3);
    for (std::size_t i = 0; i < list.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = list[i].transpose();
    return points;
}

Points mapped(const Points& points, const Eigen::Affine3d& map) {
    Points result = points;
    for (Eigen::Index i = 0; i < points.rows(); ++i) result.row(i) = (map * Vector3d(points.row(i).transpose())).transpose();
    return result;
}

TriangleMesh bar(int cells) { return shapes::box(cells, 10 * cells, cells, {1, 10, 1}); }
Points axis(int count) { return line({0, 0, 0}, {0, 10, 0}, count); }

Points arc(double degrees, int count) {
    const double angle = degrees * std::numbers::pi / 180, radius = 10 / angle;
    Points points(count, 3);
    for (int i = 0; i < count; ++i) {
        const double a = angle * i / (count - 1);
        points.row(i) = Vector3d(radius * (1 - std::cos(a)), radius * std::sin(a), 0).transpose();
    }
    return points;
}

double gap(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

std::vector<double> dihedral_changes(const TriangleMesh& mesh, const Points& moved) {
    std::map<std::pair<int, int>, std::vector<int>> faces;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.triangles(t, k), b = mesh.triangles(t, (k + 1) % 3);
            faces[{std::min(a, b), std::max(a, b)}].push_back(t);
        }
    const auto angle = [&](const Points& points, const std::pair<int, int>& edge, int s, int t) {
        const auto normal = [&](int f) {
            const Vector3d a = points.row(mesh.triangles(f, 0)), b = points.row(mesh.triangles(f, 1)), c = points.row(mesh.triangles(f, 2));
            return Vector3d((b - a).cross(c - a).normalized());
        };
        const Vector3d m = normal(s), n = normal(t), e = (points.row(edge.second) - points.row(edge.first)).transpose().normalized();
        return std::atan2(m.cross(n).dot(e), m.dot(n)) * 180 / std::numbers::pi;
    };
    std::vector<double> changes;
    for (const auto& [edge, of] : faces) {
        if (of.size() != 2) continue;
        const double change = std::abs(angle(moved, edge, of[0], of[1]) - angle(mesh.points, edge, of[0], of[1]));
        changes.push_back(std::min(change, 360 - change));
    }
    std::sort(changes.begin(), changes.end());
    return changes;
}

double percentile(const std::vector<double>& ascending, double share) {
    return ascending.empty() ? 0 : ascending[std::min(ascending.size() - 1, static_cast<std::size_t>(share * static_cast<double>(ascending.size())))];
}

double edge_stretch(const TriangleMesh& mesh, const Points& moved) {
    double most = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.triangles(t, k), b = mesh.triangles(t, (k + 1) % 3);
            const double rest = (mesh.points.row(a) - mesh.points.row(b)).norm();
            if (rest > 0) most = std::max(most, (moved.row(a) - moved.row(b)).norm() / rest);
        }
    return most;
}

int flipped(const TriangleMesh& mesh, const Points& moved, const Points& expected) {
    int count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vector3d a = moved.row(mesh.triangles(t, 0)), b = moved.row(mesh.triangles(t, 1)), c = moved.row(mesh.triangles(t, 2));
        count += (b - a).cross(c - a).dot(Vector3d(expected.row(t))) < 0;
    }
    return count;
}

int crossings(const TriangleMesh& mesh, const Points& moved) { return lissom::self_intersections({moved, mesh.triangles}).pairs; }

namespace {

using Texel = Eigen::Vector4f;
using Eigen::Vector3f;

/// The shader, line by line: `point` or a direction, which no translation moves.
Vector3f shaded(const lissom::CurveAttributes& attributes, const lissom::CurveTable& table, std::size_t v, const Vector3f& x, bool direction) {
    constexpr std::size_t rows = lissom::EncodedCurve::k_rows;
    Texel real = Texel::Zero(), dual = Texel::Zero();
    Vector3f sum = Vector3f::Zero();
    float left = 1;
    const auto add = [&](float weight, const Texel& r, const Texel& d) {
        const float sided = real.dot(r) < 0 ? -weight : weight;
        real += sided * r;
        dual += sided * d;
    };
    const auto moved = [&](Texel r, Texel d, const Vector3f& y) -> Vector3f {
        const float norm = 1 / r.norm();
        r *= norm;
        d *= norm;
        const Vector3f a = r.head<3>(), b = d.head<3>();
        const Vector3f turned = y + 2 * a.cross(a.cross(y) + r[3] * y);
        return direction ? turned : Vector3f(turned + 2 * (r[3] * b - d[3] * a + a.cross(b)));
    };
    for (std::size_t k = 0; k < 4; ++k) {
        const float place = attributes.rows[4 * v + k], weight = attributes.weights[4 * v + k];
        if (weight == 0) continue;
        const std::size_t row = std::min(static_cast<std::size_t>(place), rows - 2), line = attributes.curves[4 * v + k] * rows + row;
        const float share = place - static_cast<float>(row);
        const auto texel = [&](std::size_t next, int t) -> Texel {
            return Eigen::Map<const Texel>(table.texels.data() + 4 * ((line + next) * lissom::CurveTable::k_texels + static_cast<std::size_t>(t)));
        };
        const auto mixed = [&](int t) -> Texel { return (1 - share) * texel(0, t) + share * texel(1, t); };
        const auto before = [&](const auto& of) -> Vector3f {
            Vector3f y = x;
            if (!direction)
                for (int axis = 0; axis < 3; ++axis) y[axis] = of(2 + axis).template head<3>().dot(x) + of(2 + axis)[3];
            return y;
        };
        if (weight == 1) {
            const auto by = [&](std::size_t next) {
                return moved(texel(next, 0), texel(next, 1), before([&](int t) { return texel(next, t); }));
            };
            return (1 - share) * by(0) + share * by(1);
        }
        add(weight, mixed(0), mixed(1));
        sum += weight * before(mixed);
        left -= weight;
    }
    add(left, Texel(0, 0, 0, 1), Texel::Zero());
    sum += left * x;
    return moved(real, dual, sum);
}

} // namespace

Points drawn(const CurveSession& session, std::span<const CurvePosture> postures, const Points& rest) {
    const auto attributes = session.attributes();
    const auto table = session.table(postures);
    Points result = rest;
    for (Eigen::Index v = 0; v < rest.rows(); ++v) {
        const Vector3d x = rest.row(v).transpose() - attributes.centre;
        result.row(v) = (shaded(attributes, table, static_cast<std::size_t>(v), x.cast<float>(), false).cast<double>() + attributes.centre).transpose();
    }
    return result;
}

Points turned(const CurveSession& session, std::span<const CurvePosture> postures, const Points& normals) {
    const auto attributes = session.attributes();
    const auto table = session.table(postures);
    Points result = normals;
    for (Eigen::Index v = 0; v < normals.rows(); ++v)
        result.row(v) = shaded(attributes, table, static_cast<std::size_t>(v), Vector3d(normals.row(v).transpose()).cast<float>(), true).cast<double>().transpose();
    return result;
}

} // namespace posing
