#include "lissom/wear/push_out.h"

#include "lissom/mesh/smooth.h"
#include "lissom/mesh/topology.h"

#include <cmath>
#include <utility>
#include <vector>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

/// By how much a push grows from round to round.
constexpr double k_farther = 1.4;

const Body* containing(const Vector3d& p, std::span<const Body* const> bodies) {
    for (const Body* body : bodies)
        if (body->contains(p)) return body;
    return nullptr;
}

Vector3d face_centre(const TriangleMesh& mesh, int t) {
    return (mesh.points.row(mesh.triangles(t, 0)) + mesh.points.row(mesh.triangles(t, 1)) + mesh.points.row(mesh.triangles(t, 2))).transpose() / 3;
}

/// The moves that bring what is inside out, by vertex; zero elsewhere.
Points demands(const TriangleMesh& mesh, std::span<const Body* const> bodies, double margin, Inside& found) {
    Points moves = Points::Zero(mesh.vertex_count(), 3);
    found = {};
    const auto out = [&](const Vector3d& p, const Body& body) -> RowVector3d {
        const Body::Place at = body.nearest(p);
        return (at.point + margin * at.normal - p).transpose();
    };
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Vector3d p = mesh.points.row(v);
        if (const Body* body = containing(p, bodies)) moves.row(v) = out(p, *body), ++found.vertices;
    }
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vector3d p = face_centre(mesh, t);
        const Body* body = containing(p, bodies);
        if (!body) continue;
        ++found.face_centres;
        const RowVector3d move = out(p, *body);
        for (int k = 0; k < 3; ++k)
            if (auto row = moves.row(mesh.triangles(t, k)); move.squaredNorm() > row.squaredNorm()) row = move;
    }
    return moves;
}

/// What was pushed out in vain (from one toe into the next) goes farther, the way that all around it goes.
void insist(Points& moves, const VertexRings& around, double farther) {
    const Points alone = moves;
    for (int v = 0; v < moves.rows(); ++v) {
        if (alone.row(v).isZero(0)) continue;
        RowVector3d sum = alone.row(v);
        for (const int j : around[v]) sum += alone.row(j);
        moves.row(v) = farther * alone.row(v).norm() * sum.stableNormalized();
    }
}

/// Each ring around what moves takes the mean of those before it that touch it, by ever less.
void spread(Points& moves, const VertexRings& around, int rings) {
    std::vector<int> ring(static_cast<std::size_t>(moves.rows()), -1), front, next;
    for (int v = 0; v < moves.rows(); ++v)
        if (!moves.row(v).isZero(0)) ring[v] = 0, front.push_back(v);
    Points whole = moves;
    for (int r = 1; r <= rings && !front.empty(); ++r, std::swap(front, next)) {
        next.clear();
        for (const int v : front)
            for (const int j : around[v])
                if (ring[j] < 0) ring[j] = r, next.push_back(j);
        for (const int v : next) {
            RowVector3d sum = RowVector3d::Zero();
            int count = 0;
            for (const int j : around[v])
                if (ring[j] == r - 1) sum += whole.row(j), ++count;
            whole.row(v) = sum / count;
            moves.row(v) = smooth(1 - static_cast<double>(r) / (rings + 1)) * whole.row(v);
        }
    }
}

} // namespace

Inside inside(const TriangleMesh& garment, std::span<const Body* const> bodies) {
    Inside found;
    for (int v = 0; v < garment.vertex_count(); ++v) found.vertices += containing(garment.points.row(v), bodies) != nullptr;
    for (int t = 0; t < garment.triangle_count(); ++t) found.face_centres += containing(face_centre(garment, t), bodies) != nullptr;
    return found;
}

PushedOut push_out(TriangleMesh& garment, std::span<const Body* const> bodies, double margin, int rings, int rounds) {
    const VertexRings around = vertex_rings(garment);
    PushedOut pushed;
    for (; pushed.rounds < rounds; ++pushed.rounds) {
        Points moves = demands(garment, bodies, margin, pushed.after);
        if (pushed.rounds == 0) pushed.before = pushed.after;
        if (pushed.after.none()) return pushed;
        if (pushed.rounds > 0) insist(moves, around, std::pow(k_farther, pushed.rounds));
        spread(moves, around, rings);
        garment.points += moves;
    }
    pushed.after = inside(garment, bodies);
    if (rounds <= 0) pushed.before = pushed.after;
    return pushed;
}

} // namespace lissom
