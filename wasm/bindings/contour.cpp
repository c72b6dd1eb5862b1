#include "convert.h"
#include "session.h"
#include "lissom/contour/contour_session.h"
#include "lissom/mesh/stopwatch.h"

#include <emscripten/bind.h>

#include <memory>
#include <string>

using namespace emscripten;
using namespace bindings;

namespace {

struct HeldContours {
    lissom::ContourSession session;
    int ticket = 0; ///< of the view under way: a newer one makes older ones void
    double seconds = 0;
};

// new ContourSession(model, sweeps)
HeldContours* prepare(const std::shared_ptr<lissom::WorkingMesh>& working, int sweeps) {
    return guarded([&] { return new HeldContours{lissom::ContourSession(working, sweeps)}; });
}

// figures() → what PreparedContours says of it
val figures(const HeldContours& held) {
    val seconds = val::object();
    seconds.set("curvature", held.session.seconds());
    val result = val::object();
    result.set("seconds", seconds);
    return result;
}

// look({ perspective, eye: [x, y, z] }, options) → the ticket of this view
int look(HeldContours& held, const val& view, const val& given) {
    return guarded([&] {
        const auto eye = convertJSArrayToNumberVector<double>(view["eye"]);
        if (eye.size() != 3) throw lissom::InvalidInput("bad-view", "An eye is a place of three numbers.");
        lissom::LineOptions options;
        read(given, "suggestive", options.suggestive);
        read(given, "strength", options.strength);
        read(given, "shortest", options.shortest);
        read(given, "corner", options.corner);
        held.session.look({view["perspective"].as<bool>(), {eye[0], eye[1], eye[2]}}, options);
        held.seconds = 0;
        return ++held.ticket;
    });
}

bool look_step(HeldContours& held, int ticket) {
    return guarded([&] {
        if (ticket != held.ticket) return false;
        lissom::Stopwatch clock;
        const bool more = held.session.look_step();
        held.seconds += clock.lap();
        return more;
    });
}

double look_fraction(const HeldContours& held) { return held.session.look_fraction(); }

// lines(ticket) → ContourLines
val lines(const HeldContours& held, int ticket) {
    return guarded([&] {
        if (ticket != held.ticket) throw lissom::InvalidInput("view-replaced", "A newer view has taken the place of this one.");
        std::vector<double> points, strengths;
        std::vector<unsigned> offsets{0}, corners;
        std::vector<float> weights;
        std::vector<unsigned char> suggestive, closed;
        for (const lissom::ContourLine& line : held.session.lines()) {
            for (const Eigen::Vector3d& p : line.points) points.insert(points.end(), {p[0], p[1], p[2]});
            for (const lissom::SurfacePlace& place : line.places)
                for (int k = 0; k < 3; ++k) {
                    corners.push_back(static_cast<unsigned>(place.corners[k]));
                    weights.push_back(static_cast<float>(place.weights[k]));
                }
            offsets.push_back(static_cast<unsigned>(points.size() / 3));
            suggestive.push_back(line.kind == lissom::ContourLine::Kind::suggestive);
            closed.push_back(line.closed);
            strengths.push_back(line.strength);
        }
        val result = val::object();
        result.set("points", typed_array(points.data(), points.size()));
        result.set("corners", typed_array(corners.data(), corners.size()));
        result.set("weights", typed_array(weights.data(), weights.size()));
        result.set("offsets", typed_array(offsets.data(), offsets.size()));
        result.set("suggestive", typed_array(suggestive.data(), suggestive.size()));
        result.set("closed", typed_array(closed.data(), closed.size()));
        result.set("strength", typed_array(strengths.data(), strengths.size()));
        result.set("seconds", held.seconds);
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(contour) {
    class_<HeldContours>("ContourSession")
        .constructor(&prepare, allow_raw_pointers())
        .function("step", &bindings::step<HeldContours>)
        .function("fraction", &bindings::fraction<HeldContours>)
        .function("figures", &figures)
        .function("look", &look)
        .function("lookStep", &look_step)
        .function("lookFraction", &look_fraction)
        .function("lines", &lines);
}
