#include "field_handles.h"

#include "lissom/deform/held_region.h"
#include "lissom/isoline/free_handles.h"
#include "lissom/mesh/errors.h"

#include <algorithm>
#include <set>
#include <string>

namespace lissom {
namespace {

/// A point alone drags along less of the surface the finer its mesh is; a disc of this radius (D = 1) drags the same.
constexpr double k_point_radius = 0.01;
/// Fewer surface vertices than a triangle's say no orientation.
constexpr int k_least_vertices = 3;

/// Corners of the surface's triangles on which working vertex w lies, or the surface vertex that it is.
std::vector<int> below(const IsolineModel& model, const std::vector<int>& surface_of_working, int w) {
    if (surface_of_working[w] >= 0) return {surface_of_working[w]};
    std::vector<int> corners;
    if (model.is_proxy())
        if (const int t = model.binding().triangle[static_cast<std::size_t>(w)]; t >= 0)
            for (int k = 0; k < 3; ++k) corners.push_back(model.surface().mesh.triangles(t, k));
    return corners;
}

void find_touching(const TriangleMesh& mesh, FieldHandles& found) {
    std::set<std::pair<int, int>> seen;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int v = mesh.triangles(t, k), w = mesh.triangles(t, (k + 1) % 3);
            const int a = found.of_working[v], b = found.of_working[w];
            if (a >= 0 && b > a && b < found.user && seen.emplace(a, b).second) found.touching.push_back({a, b, v, w});
            if (b >= 0 && a > b && a < found.user && seen.emplace(b, a).second) found.touching.push_back({b, a, w, v});
        }
}

} // namespace

FieldHandles field_handles(const IsolineModel& model, std::span<const int> roi, std::span<const DeformHandle> handles) {
    const WorkingMesh& working = model.working();
    const Roles roles = assign_roles(working, roi, handles);
    FieldHandles found;
    found.user = static_cast<int>(handles.size());
    found.of_working = roles.handle;
    for (std::size_t w = 0; w < roles.role.size(); ++w)
        if (roles.role[w] == Role::fixed) {
            found.of_working[w] = found.user;
            found.rest = true;
        }
    const Proxy& surface = model.surface();
    std::vector<int> surface_of_working(roles.role.size(), -1);
    for (std::size_t v = 0; v < surface.fine.size(); ++v) surface_of_working[surface.fine[v]] = static_cast<int>(v);

    std::vector<int> counts(static_cast<std::size_t>(found.user) + 1, 0);
    found.of_surface.assign(surface.fine.size(), -1);
    for (std::size_t v = 0; v < surface.fine.size(); ++v) {
        const int h = found.of_working[surface.fine[v]];
        if (h < 0) continue;
        found.of_surface[v] = h;
        ++counts[h];
    }
    for (int h = 0; h < found.user; ++h) {
        const DeformHandle& handle = handles[static_cast<std::size_t>(h)];
        HandleEnd end{handle.is_point ? HandleEnd::Kind::point : HandleEnd::Kind::region};
        const int first = working.working_of_source[handle.vertices.front()];
        if (handle.is_point && first >= 0) end.at = working.mesh.points.row(first);
        found.ends.push_back(end);
        if (!handle.is_point && counts[h] >= k_least_vertices) continue;
        std::vector<int> seeds;
        bool used = false;
        for (const int v : handle.vertices)
            if (const int w = working.working_of_source[v]; w >= 0) {
                used = true;
                for (const int s : below(model, surface_of_working, w))
                    if ((found.of_surface[s] < 0 || found.of_surface[s] == h) && std::find(seeds.begin(), seeds.end(), s) == seeds.end()) seeds.push_back(s);
            }
        if (handle.is_point && !seeds.empty())
            seeds = disc_around(surface.mesh, model.rings(), end.at, seeds, k_point_radius, [&](int s) { return found.of_surface[s] < 0; });
        if (used && seeds.empty())
            throw InvalidInput("handle-too-small", "Handle " + std::to_string(h + 1) + " is smaller than the simplified surface can tell from its neighbours. "
                                                   "Make it larger, or choose the method that solves for every vertex.");
        for (const int s : seeds) found.of_surface[s] = h;
    }
    if (found.rest) found.ends.push_back({HandleEnd::Kind::region});
    find_touching(working.mesh, found);
    return found;
}

} // namespace lissom
