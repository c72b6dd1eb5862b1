#include "lissom/match/marker_alignment.h"

#include "lissom/mesh/errors.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr int k_fewest_to_bend = 5;     // four are met by a linear map, whatever it shears
constexpr int k_fewest_to_judge = 6;    // leaving one out must leave enough to bend
constexpr double k_mirrored = 1.2;      // posed bodies with left and right changed: 0.55 against 0.43
constexpr double k_no_misfit = 1e-3;    // flat markers fit a mirror as well: what is left is rounding
constexpr double k_surprise_floor = 0.02;
constexpr double k_better_swapped = 0.5; // of the sum of squares: what a pose explains does not halve
constexpr std::size_t k_most_suspects = 40;

double flatness_of(const Points& markers) {
    if (markers.rows() < 4) return 0;
    const Vector3d spread = Eigen::JacobiSVD<Eigen::MatrixXd>(markers.rowwise() - markers.colwise().mean()).singularValues();
    return spread[0] > 0 ? spread[2] / spread[0] : 0;
}

Points without(const Points& markers, Eigen::Index i) {
    Points rest(markers.rows() - 1, 3);
    rest << markers.topRows(i), markers.bottomRows(markers.rows() - 1 - i);
    return rest;
}

Similarity similarity_of(const Points& from, const Points& to) {
    if (from.rows() >= 3) return fit_similarity(from, to);
    Similarity map;
    if (from.rows() > 0) map.translation = (to.colwise().mean() - from.colwise().mean()).transpose();
    return map;
}

/// How far from where it is the others would place each marker.
class Judge {
public:
    Judge(const Points& from, bool bend, double size) : from_(from), size_(size) {
        if (bend) G_ = RadialMap::leave_one_out(from);
    }
    [[nodiscard]] std::vector<double> surprises(const Points& to) const {
        std::vector<double> found;
        Points left;
        if (G_) left = *G_ * to;
        for (Eigen::Index i = 0; i < to.rows(); ++i) {
            if (G_) {
                found.push_back(left.row(i).norm() / std::abs((*G_)(i, i)) / size_);
                continue;
            }
            const Eigen::Affine3d map = fit_similarity(without(from_, i), without(to, i)).affine();
            found.push_back((map * Vector3d(from_.row(i)) - to.row(i).transpose()).norm() / size_);
        }
        return found;
    }

private:
    const Points& from_;
    double size_;
    std::optional<Eigen::MatrixXd> G_;
};

double sum_of_squares(const std::vector<double>& values) { return std::inner_product(values.begin(), values.end(), values.begin(), 0.0); }

std::optional<std::pair<int, int>> swapped_pair(const Judge& judge, const Points& to, const std::vector<double>& surprises) {
    std::vector<int> suspects(surprises.size());
    std::iota(suspects.begin(), suspects.end(), 0);
    std::stable_sort(suspects.begin(), suspects.end(), [&](int i, int j) { return surprises[i] > surprises[j]; });
    suspects.resize(std::min<std::size_t>(suspects.size(), k_most_suspects));
    std::optional<std::pair<int, int>> found;
    const double now = sum_of_squares(surprises);
    double least = k_better_swapped * now;
    for (std::size_t a = 0; a < suspects.size(); ++a)
        for (std::size_t b = a + 1; b < suspects.size(); ++b) {
            const auto [i, j] = std::minmax(suspects[a], suspects[b]);
            if (std::max(surprises[i], surprises[j]) < k_surprise_floor) continue;
            Points exchanged = to;
            exchanged.row(i).swap(exchanged.row(j));
            if (const double then = sum_of_squares(judge.surprises(exchanged)); then < least) {
                least = then;
                found = {i, j};
            }
        }
    return found;
}

} // namespace

Vector3d MarkerAlignment::operator()(const Vector3d& x) const { return radial ? (*radial)(x) : similarity.affine() * x; }

Points MarkerAlignment::operator()(const Points& points) const {
    if (radial) return (*radial)(points);
    return (similarity.scale * points * similarity.rotation.transpose()).rowwise() + similarity.translation.transpose();
}

MarkerAlignment align_markers(const Points& from, const Points& to, MatchStart start) {
    if (from.rows() != to.rows())
        throw InvalidInput("marker-count", "The source has " + std::to_string(from.rows()) + " markers and the target " + std::to_string(to.rows()) +
                                               ". Give each marker a place on both.");
    for (Eigen::Index i = 0; i < from.rows(); ++i)
        if (!from.row(i).allFinite() || !to.row(i).allFinite())
            throw InvalidInput("non-finite-marker", "Marker " + std::to_string(i + 1) + " has a coordinate that is not a finite number. Set it again.");

    MarkerAlignment found;
    const Eigen::Index n = from.rows();
    found.similarity = similarity_of(from, to);
    found.flatness = std::min(flatness_of(from), flatness_of(to));
    const bool bend = n >= k_fewest_to_bend && found.flatness >= k_flat_markers;
    if (start == MatchStart::radial || (start == MatchStart::automatic && bend)) found.radial = RadialMap::between(from, to);
    if (n < 4) return found;

    found.misfit = misfit(found.similarity, from, to);
    Points mirror = from;
    mirror.col(0) *= -1;
    found.mirrored_misfit = misfit(fit_similarity(mirror, to), mirror, to);
    found.mirrored = found.misfit > std::max(k_mirrored * found.mirrored_misfit, k_no_misfit);
    const double size = std::sqrt(12 * (to.rowwise() - to.colwise().mean()).rowwise().squaredNorm().mean());
    if (n < k_fewest_to_judge || !(size > 0)) return found;
    const Judge judge(from, bend, size);
    found.surprises = judge.surprises(to);
    found.swapped = swapped_pair(judge, to, found.surprises);
    return found;
}

} // namespace lissom
