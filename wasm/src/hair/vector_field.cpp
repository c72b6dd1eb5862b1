#include "lissom/hair/vector_field.h"

#include <algorithm>

namespace lissom {

using Eigen::Vector3d;

Vector3d VectorField::at(const Vector3d& p) const {
    const Vector3d q = grid.local(p).array().max(0.0).min((grid.size.array() - 1).cast<double>());
    const int x = std::min(static_cast<int>(q.x()), grid.size.x() - 2), y = std::min(static_cast<int>(q.y()), grid.size.y() - 2),
              z = std::min(static_cast<int>(q.z()), grid.size.z() - 2);
    const double u = q.x() - x, v = q.y() - y, w = q.z() - z;
    const Eigen::Index row = grid.size.x(), slab = row * grid.size.y();
    const double* t = vectors.data() + 3 * static_cast<Eigen::Index>(grid.node(x, y, z));
    const auto read = [&](Eigen::Index by) { return Eigen::Map<const Vector3d>(t + 3 * by); };
    const auto edge = [&](Eigen::Index by) -> Vector3d { return (1 - u) * read(by) + u * read(by + 1); };
    return (1 - w) * ((1 - v) * edge(0) + v * edge(row)) + w * ((1 - v) * edge(slab) + v * edge(slab + row));
}

} // namespace lissom
