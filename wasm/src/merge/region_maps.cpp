#include "lissom/merge/region_maps.h"

#include "lissom/merge/hole_filling.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

namespace lissom {
namespace {

std::vector<char> painted(const TriangleMesh& mesh, std::span<const int> vertices) {
    std::vector<char> flags(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (const int v : vertices) flags[v] = 1;
    return flags;
}

bool inside(const TriangleMesh& mesh, int t, const std::vector<char>& flags) {
    return flags[mesh.triangles(t, 0)] && flags[mesh.triangles(t, 1)] && flags[mesh.triangles(t, 2)];
}

/// The triangles listed, as a mesh of their own.
TriangleMesh extract(const TriangleMesh& mesh, const std::vector<int>& triangles, std::vector<int>& vertices) {
    std::vector<int> place(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (const int t : triangles)
        for (int c = 0; c < 3; ++c) place[mesh.triangles(t, c)] = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (place[v] == 0) {
            place[v] = static_cast<int>(vertices.size());
            vertices.push_back(v);
        }
    TriangleMesh part{Points(std::ssize(vertices), 3), Triangles(std::ssize(triangles), 3)};
    for (std::size_t v = 0; v < vertices.size(); ++v) part.points.row(static_cast<Eigen::Index>(v)) = mesh.points.row(vertices[v]);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int c = 0; c < 3; ++c) part.triangles(static_cast<Eigen::Index>(t), c) = place[mesh.triangles(triangles[t], c)];
    return part;
}

bool is_simple(const TriangleMesh& mesh) {
    if (!non_manifold_vertices(mesh).empty()) return false;
    for (const Edge& e : edges(mesh))
        if (e.forward > 1 || e.backward > 1) return false;
    return components(vertex_rings(mesh)).count == 1;
}

} // namespace

PlanePoints Placement::operator()(const PlanePoints& points) const {
    const Eigen::Rotation2Dd rotation(turn * std::numbers::pi / 180);
    return ((scale * points) * rotation.toRotationMatrix().transpose()).rowwise() + shift.transpose();
}

RegionMaps map_regions(const TriangleMesh& source, std::span<const int> region, std::span<const int> feature, const TriangleMesh& target,
                       std::span<const int> target_region) {
    RegionMaps maps;
    const std::vector<char> in_region = painted(source, region), in_feature = painted(source, feature);
    std::vector<int> ring_triangles;
    int features = 0, outside = 0;
    for (int t = 0; t < source.triangle_count(); ++t) {
        const bool of_feature = inside(source, t, in_feature), of_region = inside(source, t, in_region);
        features += of_feature;
        outside += of_feature && !of_region;
        if (of_region && !of_feature) ring_triangles.push_back(t);
    }
    if (features == 0) throw InvalidInput("no-feature", "No feature is painted on the source. Paint what is to be carried over; it needs at least one whole face.");
    if (outside > 0)
        throw InvalidInput("feature-outside-region", "The feature reaches out of the source region, with " + std::to_string(outside) +
                                                         " faces. Paint the source region around it.");
    maps.ring = extract(source, ring_triangles, maps.ring_vertices);
    const std::vector<std::vector<int>> borders = boundary_loops(maps.ring);
    const char* not_a_ring = "Between the edge of the source region and the feature there must be one closed band without holes or handles. "
                             "Paint the region wider around the feature, and close gaps in both.";
    if (ring_triangles.empty()) throw InvalidInput("region-touches-feature", not_a_ring);
    std::set<int> feature_vertices;
    for (int t = 0; t < source.triangle_count(); ++t)
        if (inside(source, t, in_feature))
            for (int c = 0; c < 3; ++c) feature_vertices.insert(source.triangles(t, c));
    const auto at_feature = [&](const std::vector<int>& loop) {
        return std::count_if(loop.begin(), loop.end(), [&](int v) { return feature_vertices.contains(maps.ring_vertices[v]); });
    };
    for (const std::vector<int>& loop : borders)
        if (const auto touching = at_feature(loop); touching > 0 && touching < std::ssize(loop))
            throw InvalidInput("region-touches-feature", std::string("The feature touches the edge of the source region. ") + not_a_ring);
    if (!is_simple(maps.ring) || borders.size() != 2 || euler_characteristic(maps.ring) != 0 || (at_feature(borders[0]) > 0) == (at_feature(borders[1]) > 0))
        throw InvalidInput("region-not-a-ring", not_a_ring);
    const bool first_is_inner = at_feature(borders[0]) > 0;
    maps.outer = borders[first_is_inner ? 1 : 0];
    maps.inner = borders[first_is_inner ? 0 : 1];

    // Fu 3.4.1: the feature is replaced by a least-area filling of its border, so that neither its shape nor its
    // topology matters.
    TriangleMesh filled = maps.ring;
    const auto filling = least_area_filling(maps.ring.points, maps.inner);
    filled.triangles.conservativeResize(maps.ring.triangle_count() + std::ssize(filling), 3);
    for (std::size_t k = 0; k < filling.size(); ++k) // the loop has the ring to its left, the filling faces the other way
        for (int c = 0; c < 3; ++c) filled.triangles(maps.ring.triangle_count() + static_cast<Eigen::Index>(k), 2 - c) = maps.inner[filling[k][c]];
    maps.ring_map = conformal_map(filled, maps.outer);

    const std::vector<char> in_target = painted(target, target_region);
    for (int t = 0; t < target.triangle_count(); ++t)
        if (inside(target, t, in_target)) maps.disk_triangles.push_back(t);
    if (maps.disk_triangles.empty()) throw InvalidInput("no-target-region", "No region is painted on the target. Paint where the feature is to go.");
    maps.disk = extract(target, maps.disk_triangles, maps.disk_vertices);
    const auto disk_borders = boundary_loops(maps.disk);
    if (!is_simple(maps.disk) || disk_borders.size() != 1 || euler_characteristic(maps.disk) != 1)
        throw InvalidInput("target-region-not-a-disk", "The target region must be one patch without holes or handles. Fill its holes and join its pieces.");
    maps.border = disk_borders.front();
    maps.disk_map = conformal_map(maps.disk, maps.border);
    return maps;
}

} // namespace lissom
