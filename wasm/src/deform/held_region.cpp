#include "lissom/deform/held_region.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <set>

namespace lissom {
namespace {

/// A cloud of points this thin (relative variance) says nothing reliable about the direction across it.
constexpr double k_flat = 1e-4;

/// The triangles that touch a free vertex or a neighbour of one: every ring and every Laplacian row that
/// the solve reads is complete in them.
void cut_out(const WorkingMesh& working, const Roles& roles, HeldRegion& region) {
    const Triangles& T = working.mesh.triangles;
    const auto n = static_cast<std::size_t>(working.mesh.vertex_count());
    std::vector<char> near(n, 0), kept(n, 0);
    for (int f = 0; f < T.rows(); ++f)
        for (int k = 0; k < 3; ++k)
            if (roles.role[T(f, k)] == Role::free) {
                for (int c = 0; c < 3; ++c) near[T(f, c)] = 1;
                break;
            }
    std::vector<int> triangles;
    for (int f = 0; f < T.rows(); ++f)
        if (near[T(f, 0)] || near[T(f, 1)] || near[T(f, 2)]) {
            triangles.push_back(f);
            for (int c = 0; c < 3; ++c) kept[T(f, c)] = 1;
        }

    std::vector<int> local(n, -1);
    for (std::size_t v = 0; v < n; ++v)
        if (kept[v]) {
            local[v] = static_cast<int>(region.working.size());
            region.working.push_back(static_cast<int>(v));
            region.role.push_back(roles.role[v]);
            region.handle.push_back(roles.handle[v]);
        }
    region.mesh.points.resize(static_cast<Eigen::Index>(region.working.size()), 3);
    for (std::size_t v = 0; v < region.working.size(); ++v) region.mesh.points.row(v) = working.mesh.points.row(region.working[v]);
    region.mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int c = 0; c < 3; ++c) region.mesh.triangles(t, c) = local[T(triangles[t], c)];
    region.rings = vertex_rings(region.mesh);
}

bool moves_by_solve(Role role) {
    return role == Role::free || role == Role::point;
}

void find_pieces(HeldRegion& region) {
    const int n = region.mesh.vertex_count();
    region.piece.assign(static_cast<std::size_t>(n), -1);
    std::vector<int> front;
    for (int first = 0; first < n; ++first) {
        if (region.role[first] != Role::free || region.piece[first] >= 0) continue;
        const int number = static_cast<int>(region.pieces.size());
        HeldPiece piece;
        std::set<std::pair<int, int>> rim; // (handle, vertex)
        std::set<int> points;
        region.piece[first] = number;
        front.assign(1, first);
        while (!front.empty()) {
            const int i = front.back();
            front.pop_back();
            if (region.role[i] == Role::free) ++piece.free_count;
            else points.insert(region.handle[i]);
            for (const int j : region.rings[i]) {
                if (moves_by_solve(region.role[j])) {
                    if (region.piece[j] >= 0) continue;
                    region.piece[j] = number;
                    front.push_back(j);
                } else if (region.role[j] == Role::region) {
                    rim.emplace(region.handle[j], j);
                } else {
                    piece.touches_fixed = true;
                }
            }
        }
        for (const auto& [h, v] : rim) {
            if (piece.region_handles.empty() || piece.region_handles.back() != h) {
                piece.region_handles.push_back(h);
                piece.rim_sizes.push_back(0);
            }
            ++piece.rim_sizes.back();
        }
        piece.point_handles.assign(points.begin(), points.end());
        region.pieces.push_back(std::move(piece));
    }
}

/// True where the point handles of a piece leave an affine map open: fewer than four, or all in one plane.
bool orientation_is_open(const HeldRegion& region, int number) {
    Points held(0, 3);
    for (int v = 0; v < region.mesh.vertex_count(); ++v)
        if (region.piece[v] == number && region.role[v] == Role::point) {
            held.conservativeResize(held.rows() + 1, 3);
            held.row(held.rows() - 1) = region.mesh.points.row(v);
        }
    if (held.rows() < 4) return true;
    held.rowwise() -= held.colwise().mean().eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(Eigen::Matrix3d(held.transpose() * held), Eigen::EigenvaluesOnly);
    return spread.eigenvalues()[0] < k_flat * spread.eigenvalues()[2];
}

void put_to_rest(const WorkingMesh& working, HeldRegion& region, std::vector<Finding>& warnings) {
    Finding loose{"component-without-handle", 0, {}, true};
    std::vector<char> named(region.pieces.size(), 0);
    for (std::size_t v = 0; v < region.role.size(); ++v) {
        const int p = region.piece[v];
        if (p < 0) continue;
        const HeldPiece& piece = region.pieces[p];
        if (piece.has_frame() || !piece.point_handles.empty()) continue;
        region.role[v] = Role::fixed;
        region.piece[v] = -1;
        if (named[p]) continue;
        named[p] = 1;
        ++loose.count;
        if (loose.examples.size() < 8) loose.examples.push_back(working.source_of_working[region.working[v]]);
    }
    if (loose.count > 0) warnings.push_back(std::move(loose));
}

/// Fu 2.5: a boundary of three vertices cannot steer a complex region. A region of n vertices that is as
/// wide as it is long has a rim of about √n; an eighth of that is worth a word.
void warn_of_tiny_rims(const HeldRegion& region, std::vector<Finding>& warnings) {
    Finding tiny{"tiny-boundary", 0, {}, false};
    std::set<int> handles;
    for (const HeldPiece& piece : region.pieces)
        for (std::size_t k = 0; k < piece.region_handles.size(); ++k)
            if (piece.rim_sizes[k] < std::sqrt(piece.free_count) / 8) handles.insert(piece.region_handles[k]);
    for (const int h : handles) {
        ++tiny.count;
        if (tiny.examples.size() < 8) tiny.examples.push_back(h);
    }
    if (tiny.count > 0) warnings.push_back(std::move(tiny));
}

} // namespace

HeldRegion hold_region(const WorkingMesh& working, const Roles& roles, int handle_count, std::vector<Finding>& warnings) {
    HeldRegion region;
    region.handle_count = handle_count;
    cut_out(working, roles, region);
    find_pieces(region);
    put_to_rest(working, region, warnings);

    const int n = region.mesh.vertex_count();
    region.slot.assign(static_cast<std::size_t>(n), -1);
    for (const bool handled : {false, true}) {
        for (int v = 0; v < n; ++v)
            if (handled ? region.handle[v] >= 0 : region.role[v] == Role::free) {
                region.slot[v] = region.slots();
                region.vertex_of_slot.push_back(v);
            }
        if (!handled) region.unknowns = region.slots();
    }
    for (int p = 0; p < static_cast<int>(region.pieces.size()); ++p) {
        HeldPiece& piece = region.pieces[p];
        if (piece.has_frame() || piece.point_handles.empty() || !orientation_is_open(region, p)) continue;
        piece.pose = static_cast<int>(region.poses.size());
        region.poses.push_back(p);
    }
    if (region.unknowns == 0) warnings.push_back({"nothing-free", 1, {}, false});
    else warn_of_tiny_rims(region, warnings);
    return region;
}

} // namespace lissom
