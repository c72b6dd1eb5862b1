#include "placed_model.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

namespace {

TriangleMesh at_unit_size(const TriangleMesh& mesh, const SurfaceSize& size) {
    return {(mesh.points.rowwise() - size.middle) / size.size, mesh.triangles};
}

SurfaceSize size_of(const WorkingMesh& model, const std::string& which) {
    SurfaceSize size = surface_size(model.mesh);
    if (!(size.size > 0)) throw InvalidInput("flat-model", "The " + which + " has no area to put a skin on. Choose another model.");
    return size;
}

} // namespace

bool is_points(const WorkingMesh& model) {
    return std::any_of(model.findings.begin(), model.findings.end(), [](const Finding& finding) { return finding.code == "points-only"; });
}

PlacedModel::PlacedModel(const WorkingMesh& model, const std::string& which, std::optional<OuterSurface> seen)
    : working(model), outer(std::move(seen)), size(size_of(model, which)),
      // Where something is hidden the rims are mostly creases.
      surface(at_unit_size(outer ? outer->seen() : model.mesh, size), {!outer && !is_soup(model.mesh), model.oriented}) {}


bool PlacedModel::is_loose() const { return is_points() || outer || is_soup(working.mesh); }

void PlacedModel::ignore(const std::vector<int>& source_vertices, const std::string& which) {
    if (source_vertices.empty()) return;
    std::vector<char> flags(static_cast<std::size_t>(working.mesh.vertex_count()), 0);
    for (const int v : source_vertices) {
        if (v < 0 || v >= std::ssize(working.working_of_source)) throw InvalidInput("bad-mask", "The mask of the " + which + " has vertex " + std::to_string(v) + ", which is not there. Paint the mask again.");
        if (const int at = working.working_of_source[v]; at >= 0) flags[at] = 1;
    }
    surface.ignore(outer ? outer->carried(flags) : std::move(flags));
    for (int t = 0; t < mesh().triangle_count(); ++t)
        if (!surface.ignores(t)) return;
    throw InvalidInput("bad-mask", "The mask of the " + which + " covers all of it. Leave some of it free.");
}

Points PlacedModel::inwards(const Points& places) const {
    Points inside(places.rows(), 3);
    for (Eigen::Index i = 0; i < places.rows(); ++i) inside.row(i) = (working.to_working(Vector3d(places.row(i))).transpose() - size.middle) / size.size;
    return inside;
}

Points PlacedModel::outwards(const Points& places) const {
    Points outside(places.rows(), 3);
    for (Eigen::Index i = 0; i < places.rows(); ++i) outside.row(i) = working.to_source((size.size * places.row(i) + size.middle).transpose()).transpose();
    return outside;
}

} // namespace lissom
