#include "lissom/mesh/similarity.h"

#include "lissom/mesh/polar.h"

#include <cmath>

namespace lissom {

Eigen::Affine3d Similarity::affine() const {
    Eigen::Affine3d map;
    map.linear() = scale * rotation;
    map.translation() = translation;
    return map;
}

Similarity fit_similarity(const Points& from, const Points& to) {
    const Eigen::RowVector3d a = from.colwise().mean(), b = to.colwise().mean();
    const Points f = from.rowwise() - a, t = to.rowwise() - b;
    const double spread = f.squaredNorm();
    Similarity map;
    if (spread > 0) {
        const Eigen::Matrix3d C = t.transpose() * f;
        map.rotation = nearest_rotation(C); // the same rotation maximises tr(Rᵀ C)
        map.scale = map.rotation.cwiseProduct(C).sum() / spread;
        if (!(map.scale > 0)) map.scale = std::sqrt(t.squaredNorm() / spread); // no shape in common: at least the size
        if (!(map.scale > 0)) map.scale = 1;
    }
    map.translation = b.transpose() - map.scale * map.rotation * a.transpose();
    return map;
}

double misfit(const Similarity& map, const Points& from, const Points& to) {
    const Points image = (map.scale * from * map.rotation.transpose()).rowwise() + map.translation.transpose();
    const double spread = (to.rowwise() - to.colwise().mean()).squaredNorm();
    return spread > 0 ? std::sqrt((image - to).squaredNorm() / spread) : 0;
}

} // namespace lissom
