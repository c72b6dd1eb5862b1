#include "session.h"
#include "lissom/curve/ik.h"
#include "lissom/curve/pose.h"
#include "lissom/mesh/self_intersections.h"

#include <emscripten/bind.h>

#include <algorithm>
#include <memory>
#include <string>

using namespace emscripten;
using namespace bindings;

namespace {

struct HeldCurves {
    lissom::CurveSession session; ///< holds its model
};

lissom::CurveEnd end_named(const val& name) {
    return named<lissom::CurveEnd>(name, "end of a curve", {{"start", lissom::CurveEnd::start}, {"end", lissom::CurveEnd::end}});
}

// CurveSpec of web/kernel/contract/curve.ts
std::vector<lissom::CurveSpec> specs(const val& list) {
    std::vector<lissom::CurveSpec> result;
    for (const val& given : vecFromJSArray<val>(list)) {
        lissom::CurveSpec spec{.rest = points(given["rest"])};
        spec.role = named<lissom::CurveRole>(given["role"], "role of a curve", {{"limb", lissom::CurveRole::limb}, {"contour", lissom::CurveRole::contour}});
        spec.rigid = indices(given["rigid"]);
        if (!given["region"].isNull()) spec.region = indices(given["region"]);
        if (!given["anchor"].isNull()) spec.anchor = end_named(given["anchor"]);
        spec.reach = given["reach"].as<double>();
        for (const val& still : vecFromJSArray<val>(given["held"])) spec.held.push_back(points(still));
        result.push_back(std::move(spec));
    }
    return result;
}

std::vector<lissom::CurveLink> curve_links(const val& list) {
    std::vector<lissom::CurveLink> result;
    for (const val& given : vecFromJSArray<val>(list)) result.push_back({given["child"].as<int>(), given["parent"].as<int>(), given["at"].as<double>()});
    return result;
}

lissom::CurveOptions curve_options(const val& given) {
    using lissom::CurveBlending, lissom::CurveEncoding, lissom::CurveGuard;
    lissom::CurveOptions options;
    options.blending = named<CurveBlending>(given["blending"], "blending of curves", {{"ownership", CurveBlending::ownership}, {"geodesic", CurveBlending::geodesic}, {"gaussian", CurveBlending::gaussian}});
    options.encoding = named<CurveEncoding>(given["encoding"], "encoding of curves", {{"kernel", CurveEncoding::kernel}, {"slabs", CurveEncoding::slabs}});
    options.guard = named<CurveGuard>(given["guard"], "guard of curves", {{"symmetric", CurveGuard::symmetric}, {"thesis", CurveGuard::thesis}, {"none", CurveGuard::none}});
    return options;
}

// CurvePosture[]
std::vector<lissom::CurvePosture> postures(const val& list) {
    std::vector<lissom::CurvePosture> result;
    for (const val& given : vecFromJSArray<val>(list)) {
        lissom::CurvePosture posture;
        posture.points = points(given["points"]);
        if (const auto base = convertJSArrayToNumberVector<double>(given["base"]); base.size() == 4) posture.base = Eigen::Quaterniond(base[3], base[0], base[1], base[2]);
        posture.twist = convertJSArrayToNumberVector<double>(given["twist"]);
        const auto scale = convertJSArrayToNumberVector<double>(given["scale"]);
        for (std::size_t k = 0; k + 1 < scale.size(); k += 2) posture.scale.push_back({scale[k], scale[k + 1]});
        result.push_back(std::move(posture));
    }
    return result;
}

// new CurveSession(model, curves, links, options)
HeldCurves* prepare(const std::shared_ptr<lissom::WorkingMesh>& model, const val& curves, const val& links, const val& options) {
    return guarded([&] { return new HeldCurves{lissom::CurveSession(model, specs(curves), curve_links(links), curve_options(options))}; });
}

// figures() → what PreparedCurves says of it
val figures(const HeldCurves& held) {
    return guarded([&] {
        val curves = val::array();
        for (int c = 0; c < held.session.curve_count(); ++c) {
            const std::vector<int> region = held.session.region(c);
            const std::vector<double> radii = held.session.radii(c);
            val one = val::object();
            one.set("region", uint32_array(region.data(), region.size()));
            one.set("anchor", std::string(held.session.anchor(c) == lissom::CurveEnd::start ? "start" : "end"));
            one.set("radii", typed_array(radii.data(), radii.size()));
            curves.call<void>("push", one);
        }
        val seconds = val::object();
        seconds.set("regions", held.session.seconds().regions);
        seconds.set("encode", held.session.seconds().encode);
        val result = val::object();
        result.set("curves", curves);
        result.set("warnings", findings(held.session.warnings()));
        result.set("seconds", seconds);
        return result;
    });
}

void put_strain(val& result, const lissom::CurveStrain& strain) {
    result.set("bend", strain.bend);
    result.set("tilt", strain.tilt);
}

// pose(postures) → PosedCurves
val pose(const HeldCurves& held, const val& list) {
    return guarded([&] {
        const std::vector<lissom::CurvePosture> given = postures(list);
        const lissom::PosedPoints posed = held.session.posed(given);
        val result = val::object();
        result.set("positions", float64_array(posed.positions));
        put_strain(result, posed.strain);
        return result;
    });
}

// attributes() → CurveAttributes
val attributes(const HeldCurves& held) {
    return guarded([&] {
        const lissom::CurveAttributes found = held.session.attributes();
        val centre = val::array();
        for (const double x : found.centre) centre.call<void>("push", x);
        val result = val::object();
        result.set("curves", typed_array(found.curves.data(), found.curves.size()));
        result.set("rows", typed_array(found.rows.data(), found.rows.size()));
        result.set("weights", typed_array(found.weights.data(), found.weights.size()));
        result.set("centre", centre);
        result.set("frames", typed_array(found.frames.data(), found.frames.size()));
        result.set("slopes", typed_array(found.slopes.data(), found.slopes.size()));
        return result;
    });
}

// table(postures) → CurveTable
val table(const HeldCurves& held, const val& list) {
    return guarded([&] {
        const lissom::CurveTable found = held.session.table(postures(list));
        val result = val::object();
        result.set("texels", typed_array(found.texels.data(), found.texels.size()));
        put_strain(result, found.strain);
        return result;
    });
}

val normals(const HeldCurves& held, const val& list, const val& rest) {
    return guarded([&] { return float64_array(held.session.normals(postures(list), points(rest))); });
}

double drag_limit(const HeldCurves& held, const val& from, const val& to) {
    return guarded([&] { return held.session.drag_limit(postures(from), postures(to)); });
}

// parents(postures) → column-major 4×4 matrices, end to end
val parents(const HeldCurves& held, const val& list) {
    return guarded([&] {
        std::vector<double> flat;
        for (const Eigen::Affine3d& map : held.session.parent_motions(postures(list))) flat.insert(flat.end(), map.matrix().data(), map.matrix().data() + 16);
        return typed_array(flat.data(), flat.size());
    });
}

// reachCurve(points, end, target, held) → { points, reached }
val reach(const val& given, int end, const val& target, const val& held) {
    return guarded([&] {
        const std::vector<int> still = indices(held);
        const lissom::Reached found = lissom::reached(points(given), end, {target[0].as<double>(), target[1].as<double>(), target[2].as<double>()}, still);
        val result = val::object();
        result.set("points", float64_array(found.points));
        result.set("reached", found.reached);
        return result;
    });
}

// selfIntersections(model, positions) → { pairs, faces }
val crossings(const std::shared_ptr<lissom::WorkingMesh>& model, const val& positions) {
    return guarded([&] {
        const lissom::Points moved = points(positions);
        if (moved.rows() != model->source.rows())
            throw lissom::InvalidInput("wrong-size", "There are positions for " + std::to_string(moved.rows()) + " vertices; the model has " + std::to_string(model->source.rows()) + ".");
        lissom::TriangleMesh mesh{lissom::Points(model->mesh.points.rows(), 3), model->mesh.triangles};
        for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) mesh.points.row(v) = model->to_working(moved.row(model->source_of_working[v]).transpose()).transpose();
        const lissom::SelfIntersections found = lissom::self_intersections(mesh);
        std::vector<int> faces;
        for (const int t : found.triangles) faces.push_back(model->polygon_of_triangle[t]);
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        val result = val::object();
        result.set("pairs", found.pairs);
        result.set("faces", uint32_array(faces.data(), faces.size()));
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(curve) {
    function("reachCurve", &reach);
    function("selfIntersections", &crossings);
    class_<HeldCurves>("CurveSession")
        .constructor(&prepare, allow_raw_pointers())
        .function("step", &bindings::step<HeldCurves>)
        .function("fraction", &bindings::fraction<HeldCurves>)
        .function("figures", &figures)
        .function("pose", &pose)
        .function("attributes", &attributes)
        .function("table", &table)
        .function("normals", &normals)
        .function("dragLimit", &drag_limit)
        .function("parents", &parents);
}
