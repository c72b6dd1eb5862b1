#include "lissom/deform/held_region.h"
#include "lissom/mesh/errors.h"

#include <string>

namespace lissom {
namespace {

std::string name(int h) {
    return "handle " + std::to_string(h + 1);
}

void check_vertex(int v, int count, const std::string& where) {
    if (v < 0 || v >= count)
        throw InvalidInput("vertex-out-of-range", "The " + where + " names vertex " + std::to_string(v) + ", but the model's vertices run from 0 to " +
                                                      std::to_string(count - 1) + ". Choose it again on this model.");
}

} // namespace

Roles assign_roles(const WorkingMesh& working, std::span<const int> roi, std::span<const DeformHandle> handles) {
    const int sources = static_cast<int>(working.working_of_source.size());
    Roles roles;
    roles.role.assign(static_cast<std::size_t>(working.mesh.vertex_count()), Role::fixed);
    roles.handle.assign(roles.role.size(), -1);

    for (const int v : roi) {
        check_vertex(v, sources, "region");
        if (const int w = working.working_of_source[v]; w >= 0) roles.role[w] = Role::free;
    }
    if (handles.empty()) throw InvalidInput("no-handle", "Nothing holds the region. Paint a handle or click a point to drag.");
    std::vector<int> owner(static_cast<std::size_t>(sources), -1);
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        const DeformHandle& handle = handles[h];
        if (handle.vertices.empty()) throw InvalidInput("empty-handle", "There is no vertex in " + name(h) + ". Paint it on the model or delete it.");
        if (handle.is_point && handle.vertices.size() != 1)
            throw InvalidInput("point-handle-size", "A point handle is one vertex, but " + name(h) + " has " +
                                                        std::to_string(handle.vertices.size()) + ". Make it a region handle or keep one vertex.");
        for (const int v : handle.vertices) {
            check_vertex(v, sources, name(h));
            const int w = working.working_of_source[v];
            const int other = w >= 0 ? roles.handle[w] : owner[v];
            if (other >= 0 && other != h)
                throw InvalidInput("handle-overlap", "Vertex " + std::to_string(v) + " belongs to " + name(other) + " and " + name(h) +
                                                         (owner[v] == other ? "" : ", for it lies where a vertex of the first one lies") +
                                                         ". Take it out of one of them.");
            owner[v] = h;
            if (w < 0) continue;
            roles.handle[w] = h;
            roles.role[w] = handle.is_point ? Role::point : Role::region;
        }
    }
    return roles;
}

} // namespace lissom
