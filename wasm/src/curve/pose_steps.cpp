// How a session comes to be, step by step.

#include "pose_state.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lissom {

using Eigen::Vector3d;

namespace {

void check_options(const CurveOptions& options) {
    const auto share = [](double x, double most) { return std::isfinite(x) && x >= 0 && x <= most; };
    if (!share(options.kernel, 10) || !share(options.blend, 10) || !(options.kappa > 0) || !share(options.kappa, 100))
        throw InvalidInput("bad-option", "Widths of curves are numbers from 0 to 10 radii, reaches from above 0 to 100.");
}

} // namespace

CurveSession::CurveSession(std::shared_ptr<const WorkingMesh> model, std::vector<CurveSpec> curves, std::vector<CurveLink> links, CurveOptions options)
    : state_(std::make_unique<State>()) {
    state_->model = std::move(model);
    state_->specs = std::move(curves);
    state_->links = std::move(links);
    state_->options = options;
    state_->begin();
}

CurveSession::CurveSession(const Points& cloud, std::vector<CurveSpec> curves, std::vector<CurveLink> links, CurveOptions options)
    : state_(std::make_unique<State>()) {
    state_->source = cloud;
    state_->specs = std::move(curves);
    state_->links = std::move(links);
    state_->options = options;
    state_->begin();
}

CurveSession::~CurveSession() = default;
CurveSession::CurveSession(CurveSession&&) noexcept = default;

void CurveSession::State::begin() {
    const int count = static_cast<int>(specs.size());
    if (count == 0) throw InvalidInput("no-curve", "There is no curve to pose. Draw one.");
    check_options(options);
    order = link_order(count, links);
    order.linked.assign(count, false); // a contour on a limb makes no skeleton
    for (const CurveLink& link : links)
        if (!is_contour(link.child) && !is_contour(link.parent)) order.linked[link.child] = order.linked[link.parent] = true;
    for (const CurveSpec& spec : specs) {
        (void)rest_spline(spec.rest, spec.rigid); // refuses what is none
        for (const Points& still : spec.held) (void)rest_spline(still, {});
        if (!(spec.reach >= 0) || !std::isfinite(spec.reach))
            throw InvalidInput("line-radius", "A line's reach must be 0 or more; it is " + std::to_string(spec.reach) + ".");
        if (!spec.region) continue;
        for (const int v : *spec.region)
            if (v < 0 || v >= given().rows())
                throw InvalidInput("vertex-out-of-range", "The region of a curve names vertex " + std::to_string(v) + "; the model has " + std::to_string(given().rows()) + ".");
    }
    if (model) centre = model->centre;
    else {
        Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
        for (int v = 0; v < source.rows(); ++v)
            if (source.row(v).allFinite()) {
                low = low.cwiseMin(source.row(v).transpose());
                high = high.cwiseMax(source.row(v).transpose());
            }
        if (low.x() <= high.x()) centre = (low + high) / 2;
    }
    rest = less(given(), centre);
    regions.resize(count);
    fields.resize(count);
    radii.resize(count);
}

bool CurveSession::step() {
    State& s = *state_;
    const int count = static_cast<int>(s.specs.size());
    Stopwatch watch;
    if (s.phase == 0) {
        if (s.model) s.surface = std::make_unique<CurveSurface>(s.model);
        s.seconds.regions += watch.lap();
    } else if (s.phase <= count) {
        if (s.is_contour(s.phase - 1)) s.find_pull(s.phase - 1);
        else s.find_region(s.phase - 1);
        s.seconds.regions += watch.lap();
    } else if (s.phase == count + 1) {
        s.assign();
        s.seconds.encode += watch.lap();
    }
    ++s.phase;
    return s.phase <= count + 1;
}

double CurveSession::fraction() const { return std::min(1.0, static_cast<double>(state_->phase) / static_cast<double>(state_->specs.size() + 2)); }

} // namespace lissom
