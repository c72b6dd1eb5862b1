#include "lissom/mesh/grid.h"

#include <algorithm>

namespace lissom {

Cell cell_of(const Grid& grid, const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = grid.local(p);
    int low[3];
    double t[3];
    for (int d = 0; d < 3; ++d) {
        const double last = std::max(0, grid.size[d] - 2);
        low[d] = static_cast<int>(std::clamp(q[d], 0.0, last));
        t[d] = std::clamp(q[d] - low[d], 0.0, 1.0);
    }
    Cell cell;
    for (int k = 0; k < 8; ++k) {
        const int x = k & 1, y = (k >> 1) & 1, z = k >> 2;
        cell.nodes[k] = grid.node(std::min(low[0] + x, grid.size[0] - 1), std::min(low[1] + y, grid.size[1] - 1),
                                  std::min(low[2] + z, grid.size[2] - 1));
        cell.weights[k] = (x ? t[0] : 1 - t[0]) * (y ? t[1] : 1 - t[1]) * (z ? t[2] : 1 - t[2]);
    }
    return cell;
}

} // namespace lissom
