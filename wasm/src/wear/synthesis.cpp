#include "lissom/wear/synthesis.h"

#include "lissom/mesh/errors.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace lissom {

namespace {

constexpr int k_most = 50;
constexpr double k_regular = 1e-6;

/// Misses of the wanted measures as shares of them, and how they answer to the weights.
struct Answer {
    Eigen::VectorXd misses;
    Eigen::MatrixXd slopes;
};

Answer answer(const Measurer& measurer, std::span<const Points> bodies, std::span<const Measure> measures, const Eigen::VectorXd& weights, bool with_slopes) {
    const Points shape = blended(bodies, weights);
    std::vector<Measured> found;
    std::vector<double> wanted;
    for (std::size_t m = 0; m < measures.size(); ++m)
        if (measures[m].wanted) {
            found.push_back(measurer.measure(shape, measures[m], static_cast<int>(m)));
            wanted.push_back(*measures[m].wanted);
        }
    Answer a{Eigen::VectorXd(std::ssize(found)), {}};
    if (with_slopes) a.slopes = Eigen::MatrixXd::Zero(std::ssize(found), weights.size());
    for (std::size_t m = 0; m < found.size(); ++m) {
        const auto row = static_cast<Eigen::Index>(m);
        a.misses[row] = (found[m].value - wanted[m]) / wanted[m];
        if (with_slopes)
            for (Eigen::Index k = 0; k < weights.size(); ++k)
                for (const auto& [v, slope] : found[m].slope) a.slopes(row, k) += slope.dot(bodies[static_cast<std::size_t>(k)].row(v)) / wanted[m];
    }
    return a;
}

} // namespace

Points blended(std::span<const Points> bodies, const Eigen::VectorXd& weights) {
    Points sum = Points::Zero(bodies.front().rows(), 3);
    for (std::size_t k = 0; k < bodies.size(); ++k)
        if (const double w = weights[static_cast<Eigen::Index>(k)]; w != 0) sum += w * bodies[k];
    return sum;
}

Synthesis synthesised(const Measurer& measurer, std::span<const Points> bodies, std::span<const Measure> measures, const Eigen::VectorXd& given) {
    const Eigen::Index n = given.size();
    const double whole = given.sum();
    const Eigen::VectorXd start = std::abs(whole) > 1e-9 ? Eigen::VectorXd(given / whole) : Eigen::VectorXd(Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n)));
    Synthesis s{start, {}, 0};
    // What keeps the sum: all directions square to (1, …, 1).
    const Eigen::MatrixXd open = Eigen::MatrixXd::Identity(n, n) - Eigen::MatrixXd::Constant(n, n, 1.0 / static_cast<double>(n));
    Answer now = answer(measurer, bodies, measures, s.weights, true);
    const double mu = k_regular * (now.slopes * open).squaredNorm() / static_cast<double>(std::max<Eigen::Index>(n - 1, 1)) + 1e-14;
    const auto cost = [&](const Answer& a, const Eigen::VectorXd& w) { return a.misses.squaredNorm() + mu * (w - start).squaredNorm(); };
    double best = cost(now, s.weights);
    for (; s.iterations < k_most; ++s.iterations) {
        const Eigen::MatrixXd J = now.slopes * open;
        Eigen::MatrixXd H = J.transpose() * J;
        H.diagonal().array() += mu;
        Eigen::VectorXd step = open * H.ldlt().solve(-J.transpose() * now.misses - mu * (s.weights - start));
        bool helped = false;
        for (int half = 0; half < 12 && !helped; ++half, step /= 2) {
            const Eigen::VectorXd tried = s.weights + step;
            try {
                Answer there = answer(measurer, bodies, measures, tried, true);
                const double found = cost(there, tried);
                if (!(found < best)) continue;
                s.weights = tried, now = std::move(there), best = found, helped = true;
            } catch (const InvalidInput&) {
                // So far out a section is no longer closed: nearer.
            }
        }
        if (!helped || step.lpNorm<Eigen::Infinity>() < 1e-12) break;
    }
    const Points shape = blended(bodies, s.weights);
    for (std::size_t m = 0; m < measures.size(); ++m) s.reached.push_back(measurer.measure(shape, measures[m], static_cast<int>(m)).value);
    return s;
}

} // namespace lissom
