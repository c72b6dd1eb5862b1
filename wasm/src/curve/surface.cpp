#include "lissom/curve/surface.h"

#include <utility>

namespace lissom {

CurveSurface::CurveSurface(std::shared_ptr<const WorkingMesh> working)
    : working_(std::move(working)), rings_(vertex_rings(working_->mesh)), tree_(working_->mesh) {}

CurveSurface::CurveSurface(const WorkingMesh& working) : CurveSurface(std::shared_ptr<const WorkingMesh>(std::shared_ptr<void>(), &working)) {}

std::vector<int> CurveSurface::source_vertices(const std::vector<int>& working_vertices) const {
    std::vector<char> chosen(static_cast<std::size_t>(mesh().vertex_count()), 0);
    for (const int v : working_vertices) chosen[v] = 1;
    std::vector<int> found;
    const std::vector<int>& of_source = working_->working_of_source;
    for (int s = 0; s < static_cast<int>(of_source.size()); ++s)
        if (of_source[s] >= 0 && chosen[of_source[s]]) found.push_back(s);
    return found;
}

} // namespace lissom
