#include "lissom/isoline/anderson.h"

#include <Eigen/QR>


namespace lissom {
namespace {

/// Directions this faint beside the strongest are rounding, and what they say is left out.
constexpr double k_rank = 1e-8;
/// A residual that has grown this much says that the combination led astray.
constexpr double k_astray = 2;

} // namespace

void Anderson::restart() {
    images_.clear();
    residuals_.clear();
    last_image_.resize(0);
    last_residual_.resize(0);
}

Eigen::VectorXd Anderson::next(const Eigen::VectorXd& x, const Eigen::VectorXd& image) {
    const Eigen::VectorXd residual = image - x;
    const double size = residual.norm();
    if (last_image_.size() > 0 && size > k_astray * last_size_) restart();
    const bool first = last_image_.size() == 0;
    last_size_ = size;
    if (!first && memory_ > 0) {
        images_.push_back(image - last_image_);
        residuals_.push_back(residual - last_residual_);
        if (static_cast<int>(images_.size()) > memory_) {
            images_.erase(images_.begin());
            residuals_.erase(residuals_.begin());
        }
    }
    last_image_ = image;
    last_residual_ = residual;
    if (images_.empty()) return image;

    Eigen::MatrixXd F(residual.size(), static_cast<Eigen::Index>(residuals_.size()));
    for (std::size_t k = 0; k < residuals_.size(); ++k) F.col(static_cast<Eigen::Index>(k)) = residuals_[k];
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(F.rows(), F.cols());
    qr.setThreshold(k_rank);
    qr.compute(F);
    const Eigen::VectorXd gamma = qr.solve(residual);
    Eigen::VectorXd mixed = image;
    for (std::size_t k = 0; k < images_.size(); ++k) mixed -= gamma[static_cast<Eigen::Index>(k)] * images_[k];
    return mixed;
}

} // namespace lissom
