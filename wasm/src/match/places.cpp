#include "lissom/match/places.h"

#include "lissom/match/distances.h"
#include "lissom/match/fit_surface.h"
#include "lissom/match/marker_alignment.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/surface_places.h"

#include <limits>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_anywhere = std::numeric_limits<double>::infinity();
constexpr double k_alike = 0.3; // cosine, as correspondences are found by

Points at_unit_size(const WorkingMesh& model, const SurfaceSize& size, const Points& places) {
    Points inside(places.rows(), 3);
    for (Eigen::Index i = 0; i < places.rows(); ++i) inside.row(i) = (model.to_working(Vector3d(places.row(i))).transpose() - size.middle) / size.size;
    return inside;
}

TriangleMesh at_unit_size(const WorkingMesh& model, const SurfaceSize& size) {
    if (!(size.size > 0)) throw InvalidInput("flat-model", "A model has no area to find a place on. Choose another model.");
    return {(model.mesh.points.rowwise() - size.middle) / size.size, model.mesh.triangles};
}

} // namespace

Points carried_places(const TriangleMesh& from, const Points& to, const Points& places) {
    if (to.rows() != from.points.rows()) throw InvalidInput("wrong-size", "The two skins have different numbers of vertices.");
    if (from.triangles.size() > 0 && (from.triangles.minCoeff() < 0 || from.triangles.maxCoeff() >= to.rows()))
        throw InvalidInput("index-out-of-range", "A triangle of the skins names a vertex that is not there.");
    const SurfacePlaces nearest = places_on(from, places);
    Points carried = nearest.on({to, from.triangles});
    for (int i = 0; i < nearest.size(); ++i)
        if (nearest.triangle[i] < 0) carried.row(i) = places.row(i);
    return carried;
}

Points guessed_place(const WorkingMesh& from, const WorkingMesh& to, const Points& from_markers, const Points& to_markers, const Vector3d& place) {
    const SurfaceSize from_size = surface_size(from.mesh), to_size = surface_size(to.mesh);
    const FitSurface source(at_unit_size(from, from_size), {false, from.oriented}), target(at_unit_size(to, to_size), {false, to.oriented});
    const MarkerAlignment alignment = align_markers(at_unit_size(from, from_size, from_markers), at_unit_size(to, to_size, to_markers));

    const Vector3d there = at_unit_size(from, from_size, place.transpose()).row(0);
    const auto origin = source.nearest(there, Vector3d::Zero(), -1, k_anywhere);
    if (origin.triangle < 0) return place.transpose();
    const Vector3d laid = alignment(origin.point);
    const Vector3d ahead = alignment.similarity.rotation * Vector3d(source.normals().row(origin.triangle));
    auto found = target.nearest(laid, ahead, k_alike, k_anywhere);
    if (found.triangle < 0) found = target.nearest(laid, Vector3d::Zero(), -1, k_anywhere);
    return to.to_source((to_size.size * (found.triangle < 0 ? laid : found.point) + to_size.middle.transpose())).transpose();
}

} // namespace lissom
