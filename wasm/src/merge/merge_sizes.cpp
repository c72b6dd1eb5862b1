// Whether boundaries can be told from points: beside their models, and where the source is placed.

#include "merge_state.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace lissom {
namespace {

/// Of a model's diagonal: what is nearer together becomes one vertex (WorkingMesh).
constexpr double k_least_edge = 1e-6;
/// Of the distance from the origin: six digits of sixteen are left for an edge this long.
constexpr double k_least_digits = 1e-10;
/// A vertex so many times farther from the middle than half of the vertices has nothing to do with them.
constexpr double k_stray = 1e3;

/// Half of a loop's edges are no longer than this.
double median_edge(const Points& points, const std::vector<int>& loop) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < loop.size(); ++i) lengths.push_back((points.row(loop[(i + 1) % loop.size()]) - points.row(loop[i])).norm());
    const auto middle = lengths.begin() + std::ssize(lengths) / 2;
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

/// The vertex farthest from where most of them are.
struct Stray {
    int vertex = -1; ///< of the file; −1: none is far away
    double distance = 0;
};

Stray stray_vertex(const WorkingMesh& model) {
    const Points& points = model.mesh.points;
    const auto median = [](std::vector<double> values) {
        const auto middle = values.begin() + std::ssize(values) / 2;
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    Eigen::RowVector3d middle;
    for (int d = 0; d < 3; ++d) middle[d] = median({points.col(d).begin(), points.col(d).end()});
    const Eigen::VectorXd distances = (points.rowwise() - middle).rowwise().norm();
    Eigen::Index farthest = 0;
    const double most = distances.maxCoeff(&farthest);
    if (most <= k_stray * median({distances.begin(), distances.end()})) return {};
    return {model.source_of_working[static_cast<std::size_t>(farthest)], most * model.scale};
}

void check_loops(const Part& part, const WorkingMesh& model, const std::string& name) {
    for (std::size_t k = 0; k < part.loops.size(); ++k) {
        if (median_edge(part.mesh.points, part.loops[k]) > k_least_edge) continue;
        const Stray stray = stray_vertex(model);
        std::ostringstream message;
        message << "The " << name << " boundary";
        if (part.loops.size() > 1) message << ' ' << k + 1;
        message << " is too small beside its model: half of its edges are shorter than a millionth of the model's size, " << model.scale << ". ";
        if (stray.vertex >= 0) message << "That is because vertex " << stray.vertex << " lies " << stray.distance << " away from the others: move it to them, or delete it.";
        else message << "Choose a larger boundary, or a smaller model.";
        throw InvalidInput("boundary-too-small", message.str());
    }
}

} // namespace

void MergeSession::State::check_sizes() const {
    check_loops(source_part, source, "source");
    check_loops(target_part, target, "target");
}

void MergeSession::State::check_placed() const {
    const Points& points = source_part.mesh.points;
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<int>& loop : source_part.loops) least = std::min(least, median_edge(points, loop));
    const double farthest = points.cwiseAbs().maxCoeff();
    if (least > k_least_digits * farthest && farthest < 1e100) return;
    std::ostringstream message;
    message << "Where it is placed, the source reaches " << farthest * target.scale << " from the middle of the target, and half of the edges of its boundary are shorter than "
            << least * target.scale << ": numbers do not tell its vertices apart there. Place it nearer, or larger.";
    throw InvalidInput("placed-too-far", message.str());
}

} // namespace lissom
