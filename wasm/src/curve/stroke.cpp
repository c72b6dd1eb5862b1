#include "lissom/curve/stroke.h"

#include "lissom/curve/spline.h"
#include "lissom/mesh/errors.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace lissom {

namespace {

/// Pixels, origin and direction of each sample side by side: what is done to one is done to all.
using Samples = Eigen::Matrix<double, Eigen::Dynamic, 8, Eigen::RowMajor>;

Samples side_by_side(const Stroke& stroke) {
    Samples all(stroke.size(), 8);
    all << stroke.pixels, stroke.origins, stroke.directions;
    return all;
}

Stroke taken_apart(const Samples& all) { return {all.leftCols<2>(), all.middleCols<3>(2), all.rightCols<3>()}; }

Samples resampled(const Samples& line, double step) {
    std::vector<double> along{0};
    for (Eigen::Index i = 1; i < line.rows(); ++i) along.push_back(along.back() + (line.row(i) - line.row(i - 1)).head<2>().norm());
    const int pieces = std::max(2, static_cast<int>(std::lround(along.back() / step)));
    Samples out(pieces + 1, 8);
    Eigen::Index i = 0;
    for (int k = 0; k <= pieces; ++k) {
        const double at = along.back() * k / pieces;
        while (i + 2 < line.rows() && along[i + 1] < at) ++i;
        const double length = along[i + 1] - along[i];
        const double u = length > 0 ? std::clamp((at - along[i]) / length, 0.0, 1.0) : 0;
        out.row(k) = (1 - u) * line.row(i) + u * line.row(i + 1);
    }
    return out;
}

} // namespace

double Stroke::length() const {
    double sum = 0;
    for (int i = 1; i < size(); ++i) sum += (pixels.row(i) - pixels.row(i - 1)).norm();
    return sum;
}

Stroke filtered(const Stroke& stroke, const StrokeFilter& filter) {
    if (stroke.origins.rows() != stroke.size() || stroke.directions.rows() != stroke.size())
        throw InvalidInput("bad-stroke", "The stroke has " + std::to_string(stroke.size()) + " places on the screen but " + std::to_string(stroke.origins.rows()) + " and " +
                                             std::to_string(stroke.directions.rows()) + " ends of rays. Give one ray a place.");
    if (!stroke.pixels.allFinite() || !stroke.origins.allFinite() || !stroke.directions.allFinite())
        throw InvalidInput("bad-stroke", "The stroke has numbers that are not finite. Draw it again.");
    if (stroke.size() < 2 || stroke.length() < filter.shortest)
        throw InvalidInput("stroke-too-short", "The stroke is too short to be a curve. Draw along the part you want to bend.");
    Samples line = resampled(side_by_side(stroke), filter.step);
    for (int sweep = 0; sweep < filter.sweeps; ++sweep) {
        const Samples before = line;
        for (Eigen::Index i = 1; i + 1 < line.rows(); ++i) line.row(i) = (before.row(i - 1) + 2 * before.row(i) + before.row(i + 1)) / 4;
    }
    return taken_apart(resampled(line, filter.step));
}

Stroke part_of(const Stroke& stroke, int first, int last) {
    const int count = last - first + 1;
    return {stroke.pixels.middleRows(first, count), stroke.origins.middleRows(first, count), stroke.directions.middleRows(first, count)};
}

std::vector<double> control_samples(const Stroke& line, double error, int least, int most) {
    const int last = line.size() - 1;
    std::vector<double> at;
    for (int count = std::min(least, last + 1); count <= std::min(most, last + 1); ++count) {
        at.clear();
        Points controls = Points::Zero(count, 3);
        for (int c = 0; c < count; ++c) {
            at.push_back(static_cast<double>(last) * c / (count - 1));
            const int i = std::min(static_cast<int>(at.back()), last - 1);
            const double u = at.back() - i;
            controls.row(c).head<2>() = (1 - u) * line.pixels.row(i) + u * line.pixels.row(i + 1);
        }
        const SplineCurve curve(controls);
        double worst = 0;
        for (int i = 0; i <= last; ++i) worst = std::max(worst, curve.nearest({line.pixels(i, 0), line.pixels(i, 1), 0}).distance);
        if (worst <= error) break;
    }
    return at;
}

} // namespace lissom
