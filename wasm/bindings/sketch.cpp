#include "convert.h"
#include "lissom/curve/extract.h"
#include "lissom/curve/line_weights.h"
#include "lissom/curve/propose.h"
#include "lissom/curve/region.h"
#include "lissom/mesh/stopwatch.h"

#include <emscripten/bind.h>

#include <algorithm>
#include <memory>
#include <string>

using namespace emscripten;
using namespace bindings;

namespace {

/// What curves ask of a model; shares the model, so that either may be released first.
struct HeldSurface {
    lissom::CurveSurface surface;
    double seconds;
};

HeldSurface* prepare(const std::shared_ptr<lissom::WorkingMesh>& working) {
    return guarded([&] {
        lissom::Stopwatch clock;
        lissom::CurveSurface surface(working);
        return new HeldSurface{std::move(surface), clock.lap()};
    });
}

// figures() → what PreparedSketch says of it
val figures(const HeldSurface& held) {
    val seconds = val::object();
    seconds.set("surface", held.seconds);
    val result = val::object();
    result.set("seconds", seconds);
    return result;
}

val doubles(const std::vector<double>& numbers) { return typed_array(numbers.data(), numbers.size()); }
val vertex_list(const std::vector<int>& vertices) { return uint32_array(vertices.data(), vertices.size()); }

// sketch(pixels: Float64Array 2n, origins: Float64Array 3n, directions: Float64Array 3n, options) → SketchedCurve
val sketch(const HeldSurface& held, const val& pixels, const val& origins, const val& directions, const val& given) {
    return guarded([&] {
        const auto flat = convertJSArrayToNumberVector<double>(pixels);
        lissom::Stroke stroke;
        stroke.pixels = Eigen::Map<const decltype(stroke.pixels)>(flat.data(), static_cast<Eigen::Index>(flat.size() / 2), 2);
        stroke.origins = points(origins);
        stroke.directions = points(directions);
        lissom::ExtractOptions options;
        using Kind = lissom::ExtractOptions::Kind;
        if (const val kind = given["kind"]; !kind.isUndefined()) options.kind = named<Kind>(kind, "kind of curve", {{"automatic", Kind::automatic}, {"skeleton", Kind::skeleton}, {"surface", Kind::surface}});
        read(given, "fit", options.fit);
        lissom::Stopwatch clock;
        const lissom::ExtractedCurve curve = lissom::extract_curve(held.surface, stroke, options);
        val result = val::object();
        result.set("kind", std::string(curve.kind == lissom::CurveKind::skeleton ? "skeleton" : "surface"));
        result.set("points", float64_array(curve.controls));
        result.set("radius", doubles(curve.radius));
        result.set("hits", vertex_list(curve.hits));
        result.set("warnings", findings(curve.warnings));
        result.set("seconds", clock.lap());
        return result;
    });
}

// region(points: Float64Array 3n, options) → CurveRegion
val region(const HeldSurface& held, const val& controls, const val& given) {
    return guarded([&] {
        lissom::RegionOptions options;
        read(given, "kappa", options.kappa);
        using Method = lissom::RegionMethod;
        if (const val method = given["method"]; !method.isUndefined()) options.method = named<Method>(method, "way to find a region", {{"local", Method::local}, {"planes", Method::planes}});
        if (const val hits = given["hits"]; !hits.isUndefined()) options.hits = indices(hits);
        const int count = held.surface.mesh().triangle_count();
        if (std::any_of(options.hits.begin(), options.hits.end(), [&](int t) { return t < 0 || t >= count; }))
            throw lissom::InvalidInput("curve-hits", "The stroke met triangles that this model does not have. Draw it again.");
        std::vector<double> radius;
        if (const val given_radius = given["radius"]; !given_radius.isUndefined()) radius = convertJSArrayToNumberVector<double>(given_radius);
        const lissom::SplineCurve curve(points(controls));
        lissom::Stopwatch clock;
        if (radius.empty()) radius = lissom::curve_radius(held.surface, curve);
        const lissom::CurveRegion found = lissom::curve_region(held.surface, curve, radius, options);
        val result = val::object();
        result.set("vertices", vertex_list(found.vertices));
        result.set("startSide", vertex_list(found.startSide));
        result.set("endSide", vertex_list(found.endSide));
        result.set("between", vertex_list(found.between));
        result.set("radius", doubles(radius));
        result.set("seconds", clock.lap());
        return result;
    });
}

// propose() → { curves: { points, radius }[], links: { child, parent, at }[] }
val propose(const HeldSurface& held) {
    return guarded([&] {
        const lissom::ProposedSkeleton found = lissom::propose_curves(held.surface);
        val curves = val::array(), links = val::array();
        for (const lissom::ProposedCurve& curve : found.curves) {
            val one = val::object();
            one.set("points", float64_array(curve.controls));
            one.set("radius", doubles(curve.radius));
            curves.call<void>("push", one);
        }
        for (const lissom::ProposedLink& link : found.links) {
            val one = val::object();
            one.set("child", link.child);
            one.set("parent", link.parent);
            one.set("at", link.at);
            links.call<void>("push", one);
        }
        val result = val::object();
        result.set("curves", curves);
        result.set("links", links);
        return result;
    });
}

// weights(line: Float64Array, others: Float64Array[], options) → LineWeights
val weights(const HeldSurface& held, const val& line, const val& others, const val& given) {
    return guarded([&] {
        lissom::LineWeightsOptions options;
        read(given, "radius", options.radius);
        std::vector<lissom::Polyline> blocking;
        for (const val& other : vecFromJSArray<val>(others)) blocking.push_back(polyline(other));
        const lissom::LineWeights found = lissom::line_weights(held.surface, polyline(line), blocking, options);
        val result = val::object();
        result.set("vertices", vertex_list(found.vertices));
        result.set("weights", doubles(found.weights));
        result.set("along", doubles(found.along));
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(sketch) {
    class_<HeldSurface>("CurveSurface")
        .constructor(&prepare, allow_raw_pointers())
        .function("figures", &figures)
        .function("sketch", &sketch)
        .function("region", &region)
        .function("propose", &propose)
        .function("weights", &weights);
}
