#include "demand.h"
#include "hair_state.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::Vector3d;

namespace {

void move(Polyline& line, const Vector3d& by) {
    for (Vector3d& p : line) p += by;
}

class Findings {
public:
    void add(const char* code, int example) {
        auto at = std::find_if(list.begin(), list.end(), [&](const Finding& f) { return f.code == code; });
        if (at == list.end()) at = list.insert(list.end(), Finding{code, 0, {}, false});
        ++at->count;
        if (at->examples.size() < 8) at->examples.push_back(example);
    }
    std::vector<Finding> list;
};

} // namespace

HairStyle moved(HairStyle style, const Vector3d& by) {
    for (StreamCurve& curve : style.streams) move(curve.points, by);
    for (DividingCurve& curve : style.partings) move(curve.points, by);
    for (Ponytail& tail : style.ponytails)
        for (Polyline* line : {&tail.spine, &tail.section, &tail.profiles[0], &tail.profiles[1]}) move(*line, by);
    return style;
}

std::vector<Finding> check_style(const HairStyle& style, const HeadShape& head) {
    Findings found;
    const Grid& grid = head.volume.field;
    const auto finite = [](const Polyline& line) {
        for (const Vector3d& p : line)
            if (!p.allFinite()) throw InvalidInput("non-finite-stroke", "A stroke has a point that is not a place. Draw it again.");
    };
    const auto stroke = [&](const Polyline& line, int number) {
        finite(line);
        if (resampled(line, grid.step).empty()) found.add("stroke-too-short", number);
        else if (std::none_of(line.begin(), line.end(), [&](const Vector3d& p) { return grid.contains(p); }))
            found.add("stroke-outside", number);
    };
    // Primitives are numbered through: streams, then partings, then ponytails, as a recipe lists them.
    int number = 0;
    for (const StreamCurve& curve : style.streams) stroke(curve.points, number++);
    for (const DividingCurve& curve : style.partings) {
        demand(curve.sigma > 0 && curve.sigma <= 10 && curve.height >= 0 && curve.height <= 10,
               "The sigma of a parting is above 0 and its height from 0 on, both at most 10 grid steps.");
        demand(std::isfinite(curve.tilt[0]) && std::isfinite(curve.tilt[1]), "The tilt of a parting is two numbers.");
        stroke(curve.points, number++);
    }
    for (const Ponytail& tail : style.ponytails) {
        demand(tail.tightness >= 0 && tail.tightness <= 1, "The tightness of a ponytail is 0 to 1.");
        for (const Polyline* line : {&tail.spine, &tail.section, &tail.profiles[0], &tail.profiles[1]}) finite(*line);
        const std::vector<TailSection> sections = tail_sections(tail, grid.step);
        if (sections.empty()) found.add("ponytail-incomplete", number);
        else if (head.distance->at(sections.front().centre) < -0.5 * sections.front().radius)
            found.add("ponytail-inside-head", number);
        ++number;
    }
    return found.list;
}

} // namespace lissom
