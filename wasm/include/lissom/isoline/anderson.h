#pragma once

#include <Eigen/Core>

#include <vector>

namespace lissom {

/// Anderson acceleration of a fixed-point iteration x ← G(x): the next x is that combination of the last few images whose
/// residuals cancel best.
///
/// Source: Walker and Ni, "Anderson acceleration for fixed-point iterations", SIAM J. Numer. Anal. 49(4), 2011.
/// Cost: O(memory² · size) a step.
class Anderson {
public:
    /// @param memory  differences kept, ≥ 0; 0 is the plain iteration
    explicit Anderson(int memory = 5) : memory_(memory) {}

    /// @param x      where the map was taken; @param image  G(x); both of one size
    /// @returns      where to take it next. Starts afresh where the residual has doubled.
    [[nodiscard]] Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);

    /// Forgets what it has seen: for another map.
    void restart();

private:
    int memory_;
    Eigen::VectorXd last_image_, last_residual_;
    std::vector<Eigen::VectorXd> images_, residuals_; ///< differences, oldest first
    double last_size_ = 0;
};

} // namespace lissom
