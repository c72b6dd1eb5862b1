#include "lissom/curve/encoding.h"

#include "lissom/curve/profile.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/smooth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int k_fine = (EncodedCurve::k_rows - 1) * EncodedCurve::k_finer + 1;
/// Of a rigid span: its joints would round its middle otherwise.
constexpr double k_rigid_kernel = 0.5;
/// Twist and scale fade out over so many radii towards a held end, but over no more than a quarter of the curve.
constexpr double k_fade = 2;

SplineOptions spline_options(const EncodedCurveOptions& options) {
    SplineOptions result;
    result.rigid = options.rigid;
    return result;
}

/// x ↦ C + F D Fᵀ (x − C)
Matrix34 about(const CurveFrame& frame, const Vector3d& factors) {
    Matrix34 result;
    result.leftCols<3>() = Matrix3d::Identity() + frame.axes * (factors.array() - 1).matrix().asDiagonal() * frame.axes.transpose();
    result.col(3) = frame.origin - result.leftCols<3>() * frame.origin;
    return result;
}

DualQuaternion motion(const CurveFrame& rest, const CurveFrame& posed) {
    const Matrix3d R = posed.axes * rest.axes.transpose();
    return {R, posed.origin - R * rest.origin};
}

void check_count(const char* code, const char* what, std::size_t given, int controls) {
    if (given != 0 && static_cast<int>(given) != controls)
        throw InvalidInput(code, "The curve has " + std::to_string(controls) + " control points, but " + std::to_string(given) + " " + what +
                                     "; give one for each control point, or none.");
}

} // namespace

EncodedCurve::EncodedCurve(const Points& rest, EncodedCurveOptions options) : options_(std::move(options)), curve_(rest, spline_options(options_)) {
    const int controls = curve_.control_count();
    if (!(curve_.length() > 0)) throw InvalidInput("curve-without-length", "All control points of a curve lie in one place. Draw it longer.");
    if (static_cast<int>(options_.radius.size()) != controls || !std::all_of(options_.radius.begin(), options_.radius.end(), [](double r) { return r > 0 && std::isfinite(r); }))
        throw InvalidInput("curve-radius", "A curve needs a positive radius at each of its " + std::to_string(controls) + " control points.");
    for (int i = 0; i < controls; ++i) control_lengths_.push_back(curve_.arc_length(static_cast<double>(i) / (controls - 1)));
    for (int j = 0; j < k_fine; ++j) {
        fine_lengths_.push_back(curve_.length() * j / (k_fine - 1));
        fine_t_.push_back(curve_.parameter(fine_lengths_.back()));
    }
    first_axes_ = axes_along(curve_.tangent(options_.anchor == CurveEnd::end ? 1.0 : 0.0));
    fine_ = rest_frames(fine_t_);
    for (int i = 0; i < k_rows; ++i) {
        const double t = fine_t_[i * k_finer];
        const Vector3d u = curve_.tangent(t), dd = curve_.second_derivative(t);
        const double speed2 = curve_.derivative(t).squaredNorm();
        const bool moves = speed2 > 1e-18 * curve_.length() * curve_.length();
        slopes_.push_back({fine_[i * k_finer].origin, u * ((k_rows - 1) / curve_.length()), moves ? Vector3d((dd - u * u.dot(dd)) / speed2) : Vector3d::Zero()});
    }
}

Vector3d EncodedCurve::row_gradient(double row, const Vector3d& x) const {
    if (!(row > 0 && row < k_rows - 1)) return Vector3d::Zero();
    const int i = static_cast<int>(row);
    const double share = row - i;
    const auto mixed = [&](Vector3d RowSlope::* what) -> Vector3d { return (1 - share) * slopes_[i].*what + share * slopes_[i + 1].*what; };
    return mixed(&RowSlope::along) / std::max(1 - mixed(&RowSlope::bend).dot(x - mixed(&RowSlope::origin)), 0.05);
}

std::vector<CurveFrame> EncodedCurve::rest_frames(std::span<const double> t) const {
    return frames_along(curve_, t, first_axes_, options_.anchor == CurveEnd::end);
}

const CurveFrame& EncodedCurve::frame_at(double row) const {
    return fine_[std::clamp(static_cast<int>(std::lround(row * k_finer)), 0, k_fine - 1)];
}

double EncodedCurve::radius_at(double row) const {
    const double s = row / (k_rows - 1) * curve_.length();
    const int last = curve_.control_count() - 1;
    const int i = std::clamp(static_cast<int>(std::upper_bound(control_lengths_.begin(), control_lengths_.end(), s) - control_lengths_.begin()) - 1, 0, last - 1);
    const double width = control_lengths_[i + 1] - control_lengths_[i], u = width > 0 ? std::clamp((s - control_lengths_[i]) / width, 0.0, 1.0) : 0;
    return (1 - u) * options_.radius[i] + u * options_.radius[i + 1];
}

SplineCurve EncodedCurve::posed_curve(const CurvePosture& posture) const {
    const int controls = curve_.control_count();
    if (posture.points.rows() != controls)
        throw InvalidInput("posed-points", "The curve has " + std::to_string(controls) + " control points, but " + std::to_string(posture.points.rows()) + " posed ones.");
    check_count("curve-twist", "twists", posture.twist.size(), controls);
    check_count("curve-scale", "scales", posture.scale.size(), controls);
    if (!posture.base.coeffs().allFinite() || !(posture.base.norm() > 0)) throw InvalidInput("non-finite-curve", "The base rotation of a curve is not one.");
    SplineOptions options = spline_options(options_);
    if (options_.held) {
        const bool end = options_.anchor == CurveEnd::end;
        (end ? options.end_direction : options.start_direction) = posture.base.normalized() * curve_.tangent(end ? 1.0 : 0.0);
    }
    return SplineCurve(posture.points, options);
}

std::vector<EncodedCurve::Across> EncodedCurve::across(const CurvePosture& posture, std::span<const double> lengths) const {
    std::vector<Across> result(lengths.size(), {0, 1, 1});
    const auto fill = [&](const std::vector<double>& values, double Across::* field) {
        const MonotoneProfile profile(control_lengths_, values);
        for (std::size_t j = 0; j < lengths.size(); ++j) result[j].*field = profile.at(lengths[j]);
    };
    if (!posture.twist.empty()) fill(posture.twist, &Across::twist);
    if (!posture.scale.empty()) {
        std::vector<double> v, w;
        for (const auto& [along_v, along_w] : posture.scale) {
            v.push_back(along_v);
            w.push_back(along_w);
        }
        fill(v, &Across::scale_v);
        fill(w, &Across::scale_w);
    }
    if (options_.held) {
        const bool end = options_.anchor == CurveEnd::end;
        const double width = std::min(k_fade * (end ? options_.radius.back() : options_.radius.front()), curve_.length() / 4);
        // What the held end itself was given is taken away there, so that a twist that begins at nothing is left alone.
        const auto at_end = [&](const auto& values) { return end ? values.back() : values.front(); };
        const double twist = posture.twist.empty() ? 0 : at_end(posture.twist);
        const std::array<double, 2> scale = posture.scale.empty() ? std::array<double, 2>{1, 1} : at_end(posture.scale);
        for (std::size_t j = 0; j < lengths.size(); ++j) {
            const double fading = 1 - smooth((end ? curve_.length() - lengths[j] : lengths[j]) / width);
            if (fading <= 0) continue;
            result[j].twist -= fading * twist;
            result[j].scale_v /= std::pow(scale[0], fading);
            result[j].scale_w /= std::pow(scale[1], fading);
        }
    }
    return result;
}

std::vector<CurveFrame> EncodedCurve::posed_frames(const SplineCurve& posed, const CurvePosture& posture, std::span<const double> t, std::span<const Across> turns) const {
    const bool from_end = options_.anchor == CurveEnd::end;
    const Matrix3d first = posed_axes(first_axes_, posed.tangent(from_end ? 1.0 : 0.0), posture.base.normalized());
    std::vector<CurveFrame> frames = frames_along(posed, t, first, from_end);
    for (std::size_t j = 0; j < frames.size(); ++j) {
        if (turns[j].twist == 0) continue;
        const double angle = turns[j].twist * std::numbers::pi / 180;
        const Vector3d v = frames[j].axes.col(1), w = frames[j].axes.col(2);
        frames[j].axes.col(1) = std::cos(angle) * v + std::sin(angle) * w;
        frames[j].axes.col(2) = std::cos(angle) * w - std::sin(angle) * v;
    }
    return frames;
}

CurveRows EncodedCurve::pose(const CurvePosture& posture, std::span<const RowSupport> supports, CurveGuard guard) const {
    const SplineCurve posed = posed_curve(posture);
    const std::vector<Across> across_fine = across(posture, fine_lengths_);
    CurveRows result;
    result.fine = posed_frames(posed, posture, fine_t_, across_fine);

    std::vector<DualQuaternion> motions(k_fine);
    std::vector<Vector3d> factors(k_fine);
    for (int j = 0; j < k_fine; ++j) {
        motions[j] = motion(fine_[j], result.fine[j]);
        const double rest_speed = curve_.derivative(fine_t_[j]).norm();
        const double stretch = rest_speed > 0 ? posed.derivative(fine_t_[j]).norm() / rest_speed : 1;
        factors[j] = {stretch, across_fine[j].scale_v, across_fine[j].scale_w};
    }

    result.rigid.resize(k_rows);
    std::vector<Vector3d> blended(k_rows);
    const double step = curve_.length() / (k_fine - 1);
    for (int i = 0; i < k_rows; ++i) {
        const int middle = i * k_finer;
        const double s = fine_lengths_[middle];
        const int span = curve_.span_count() == 0 ? 0 : std::min(static_cast<int>(fine_t_[middle] * curve_.span_count()), curve_.span_count() - 1);
        const bool rigid = std::find(options_.rigid.begin(), options_.rigid.end(), span) != options_.rigid.end();
        const double wide = options_.kernel * (rigid ? k_rigid_kernel : 1) * radius_at(i);
        const double half = std::min({wide, s, curve_.length() - s});
        const int reach = half > 0 ? std::min({static_cast<int>(half / step), middle, k_fine - 1 - middle}) : 0;
        DualQuaternion sum = motions[middle];
        Vector3d factor = factors[middle];
        double weights = 1;
        for (int away = 1; away <= reach; ++away) {
            const double x = away * step / half, weight = (1 - x * x) * (1 - x * x);
            for (const int j : {middle - away, middle + away}) {
                sum.add(weight, motions[j]);
                factor += weight * factors[j];
            }
            weights += 2 * weight;
        }
        const double norm = sum.real.norm();
        if (norm < 1e-6 * weights) sum = motions[middle]; // opposite turns within the kernel have no mean
        else {
            sum.real /= norm;
            sum.dual /= norm;
        }
        result.rigid[i] = sum;
        blended[i] = factor / weights;
    }
    blended.front()[0] = blended.back()[0] = 1;

    std::vector<CurvePlane> planes(k_rows);
    int tightest = 0;
    for (int i = 0; i < k_rows; ++i) {
        const Matrix34 map = result.rigid[i].matrix();
        const CurveFrame& frame = fine_[i * k_finer];
        planes[i] = {map.leftCols<3>() * frame.origin + map.col(3), map.leftCols<3>() * frame.axes};
        const double t = fine_t_[i * k_finer];
        const Vector3d u = posed.tangent(t), inside = posed.second_derivative(t) - u * u.dot(posed.second_derivative(t));
        const double across_scale = std::max(blended[i][1], blended[i][2]);
        const double reach = supports.empty() ? radius_at(i) : supports[i].towards(inside.dot(result.fine[i * k_finer].axes.col(1)), inside.dot(result.fine[i * k_finer].axes.col(2)));
        const double bend = posed.curvature(t) * reach * across_scale;
        if (bend > result.bend) {
            result.bend = bend;
            tightest = i;
        }
    }
    if (guard != CurveGuard::none && !supports.empty()) {
        std::vector<RowSupport> scaled(supports.begin(), supports.end());
        for (int i = 0; i < k_rows; ++i)
            for (double& reach : scaled[i].reach) reach *= std::max(blended[i][1], blended[i][2]);
        const GuardedPlanes guarded = guarded_planes(planes, scaled, guard, tightest, options_.anchor == CurveEnd::end ? k_rows - 1 : 0);
        result.tilt = guarded.tilt;
        for (int i = 0; i < k_rows; ++i) {
            if (guarded.turns[i].w() == 1) continue;
            const Matrix34 map = result.rigid[i].matrix();
            const Matrix3d Q = guarded.turns[i].toRotationMatrix();
            result.rigid[i] = DualQuaternion(Q * map.leftCols<3>(), Q * (map.col(3) - planes[i].origin) + planes[i].origin);
        }
    }
    for (int i = 1; i < k_rows; ++i) // neighbours on one hemisphere, so that what lies between may be interpolated
        if (result.rigid[i].real.dot(result.rigid[i - 1].real) < 0) {
            result.rigid[i].real *= -1;
            result.rigid[i].dual *= -1;
        }
    for (int i = 0; i < k_rows; ++i) {
        result.before.push_back(about(fine_[i * k_finer], blended[i]));
        result.affine.push_back(composed(result.rigid[i].matrix(), result.before[i]));
    }
    return result;
}

Matrix34 EncodedCurve::motion_at(const CurveRows& rows, const CurvePosture& posture, double t, const Vector3d& root) const {
    const int j = std::clamp(static_cast<int>(std::lround(row_of(t) * k_finer)), 0, k_fine - 1);
    const CurveFrame& rest = fine_[j];
    const CurveFrame& posed = rows.fine[j];
    const double s = fine_lengths_[j];
    const Across here = across(posture, {&s, 1}).front();
    const Matrix3d R = posed.axes * rest.axes.transpose();
    const Vector3d lands = posed.origin + posed.axes * Vector3d(1, here.scale_v, here.scale_w).asDiagonal() * (rest.axes.transpose() * (root - rest.origin));
    Matrix34 result;
    result.leftCols<3>() = R;
    result.col(3) = lands - R * root;
    return result;
}

} // namespace lissom
