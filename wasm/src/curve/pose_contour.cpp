// A line of the drawing: what it pulls, and how.

#include "pose_state.h"

#include "lissom/curve/line_weights.h"

#include <algorithm>

namespace lissom {

using Eigen::Vector3d;

void CurveSession::State::find_pull(int c) {
    constexpr int samples = 200;
    const auto line_of = [](const Points& controls, const std::vector<int>& rigid) {
        const SplineCurve drawn = rest_spline(controls, rigid);
        Polyline line;
        for (int k = 0; k < samples; ++k) line.push_back(drawn.point(drawn.parameter(drawn.length() * k / (samples - 1))));
        return line;
    };
    CurveField& field = fields[c];
    field.side.assign(place_count(), CurveSide::none);
    field.row.assign(place_count(), 0);
    field.distance.assign(place_count(), 0); // of a contour: the weight
    std::vector<Polyline> others;
    for (int other = 0; other < static_cast<int>(specs.size()); ++other)
        if (other != c && is_contour(other)) others.push_back(line_of(specs[other].rest, specs[other].rigid));
    for (const Points& still : specs[c].held) others.push_back(line_of(still, {}));
    LineWeightsOptions how;
    how.radius = specs[c].reach;
    const LineWeights found = line_weights(*surface, line_of(specs[c].rest, specs[c].rigid), others, how);
    std::vector<bool> named(static_cast<std::size_t>(rest.rows()), !specs[c].region);
    if (specs[c].region)
        for (const int v : *specs[c].region) named[v] = true;
    for (std::size_t k = 0; k < found.vertices.size(); ++k) {
        const int v = found.vertices[k], p = model->working_of_source[v];
        if (p < 0 || !named[v]) continue;
        field.side[p] = CurveSide::inside;
        field.row[p] = static_cast<float>(found.along[k] * k_last);
        field.distance[p] = static_cast<float>(found.weights[k]);
        regions[c].push_back(v);
    }
    EncodedCurveOptions encoding;
    encoding.rigid = specs[c].rigid;
    encoding.anchor = specs[c].anchor.value_or(CurveEnd::start);
    const SplineCurve drawn = rest_spline(specs[c].rest, specs[c].rigid);
    encoding.radius.assign(specs[c].rest.rows(), drawn.length() / 10); // read by nothing: a line has no width
    radii[c] = encoding.radius;
    curves.emplace_back(less(specs[c].rest, centre), encoding);
}

CurveRows CurveSession::State::pull(int c, const CurvePosture& posture, const Matrix34& from_parent) const {
    CurveRows rows;
    const SplineCurve moved = curves[c].posed_curve(posture);
    const SplineCurve& drawn = curves[c].curve();
    Matrix34 identity = Matrix34::Zero();
    identity.leftCols<3>().setIdentity();
    const int fine = (EncodedCurve::k_rows - 1) * EncodedCurve::k_finer + 1;
    for (int j = 0; j < fine; ++j) { // where links are fixed to the line
        const double t = drawn.parameter(drawn.length() * j / (fine - 1));
        rows.fine.push_back({moved.point(t), from_parent.leftCols<3>() * curves[c].frame_at(static_cast<double>(j) / EncodedCurve::k_finer).axes});
        if (j % EncodedCurve::k_finer != 0) continue;
        const Vector3d place = drawn.point(t);
        rows.rigid.emplace_back(from_parent.leftCols<3>(), moved.point(t) - from_parent.leftCols<3>() * place);
        rows.before.push_back(identity);
        rows.affine.push_back(rows.rigid.back().matrix());
    }
    return rows;
}

} // namespace lissom
