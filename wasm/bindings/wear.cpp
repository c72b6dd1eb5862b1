#include "session.h"
#include "lissom/wear/blend_session.h"
#include "lissom/wear/dress_session.h"
#include "lissom/wear/skin_pose.h"
#include "lissom/mesh/surface_places.h"

#include <emscripten/bind.h>

#include <memory>
#include <string>

using namespace emscripten;
using namespace bindings;

namespace {

struct HeldBlend {
    lissom::BlendSession session;
};

/// A session together with the garment it refers to, so that either may be released first.
struct HeldDress {
    std::shared_ptr<lissom::WorkingMesh> garment;
    lissom::DressSession session;
};

Eigen::Vector3d vector3(const val& numbers) { return {numbers[0].as<double>(), numbers[1].as<double>(), numbers[2].as<double>()}; }

// new BlendSession(triangles: Uint32Array, positions: Float64Array[], parts: PartSpec[])
HeldBlend* prepare_blend(const val& corners, const val& positions, const val& given) {
    return guarded([&] {
        std::vector<lissom::Points> skins;
        for (const val& one : vecFromJSArray<val>(positions)) skins.push_back(points(one));
        std::vector<lissom::PartSpec> parts;
        for (const val& part : vecFromJSArray<val>(given)) {
            parts.push_back({.from = part["from"].as<int>(),
                             .vertices = indices(part["vertices"]),
                             .how = named<lissom::PartHow>(part["how"], "way to take a part over", {{"paste", lissom::PartHow::paste}, {"low-pass", lissom::PartHow::low_pass}})});
            read(part, "feather", parts.back().feather);
        }
        return new HeldBlend{lissom::BlendSession(triangles(corners), std::move(skins), parts)};
    });
}

// figures() → what PreparedBlend of web/kernel/contract/wear.ts says of it
val blend_figures(const HeldBlend& held) {
    return guarded([&] {
        val seconds = val::object();
        seconds.set("factor", held.session.seconds().factor);
        val result = val::object();
        result.set("warnings", val::array());
        result.set("seconds", seconds);
        return result;
    });
}

lissom::Measure measure_of(const val& given) {
    using Kind = lissom::Measure::Kind;
    lissom::Measure measure;
    measure.kind = named<Kind>(given["kind"], "measure", {{"height", Kind::height}, {"section", Kind::section}, {"loop", Kind::loop}, {"path", Kind::path}});
    if (measure.kind == Kind::height) measure.direction = vector3(given["up"]);
    if (measure.kind == Kind::section) {
        measure.direction = vector3(given["normal"]);
        measure.vertex = given["vertex"].as<int>();
    }
    if (measure.kind == Kind::loop || measure.kind == Kind::path) measure.vertices = indices(given["vertices"]);
    read(given, "hull", measure.hull);
    if (const val wanted = given["value"]; !wanted.isUndefined()) measure.wanted = wanted.as<double>();
    return measure;
}

// blend(weights: Float64Array, measures: MeasureSpec[]) → Blended
val blend(HeldBlend& held, const val& given, const val& asked) {
    return guarded([&] {
        const std::vector<double> numbers = convertJSArrayToNumberVector<double>(given);
        std::vector<lissom::Measure> measures;
        for (const val& one : vecFromJSArray<val>(asked)) measures.push_back(measure_of(one));
        const lissom::Blended found = held.session.blend(Eigen::Map<const Eigen::VectorXd>(numbers.data(), std::ssize(numbers)), measures);
        val seconds = val::object();
        seconds.set("measure", held.session.seconds().measure);
        seconds.set("blend", held.session.seconds().blend);
        val result = val::object();
        result.set("positions", float64_array(found.positions));
        result.set("weights", typed_array(found.weights.data(), static_cast<std::size_t>(found.weights.size())));
        result.set("reached", typed_array(found.reached.data(), found.reached.size()));
        result.set("iterations", found.iterations);
        result.set("warnings", findings(found.warnings));
        result.set("seconds", seconds);
        return result;
    });
}

// new DressSession(garment, triangles: Uint32Array, from: Float64Array, to: Float64Array, model: WorkingMesh | null)
HeldDress* prepare_dress(const std::shared_ptr<lissom::WorkingMesh>& garment, const val& corners, const val& from, const val& to, const std::shared_ptr<lissom::WorkingMesh>& model) {
    return guarded([&] { return new HeldDress{garment, lissom::DressSession(*garment, triangles(corners), points(from), points(to), model.get())}; });
}

// figures() → what PreparedDress of web/kernel/contract/wear.ts says of it
val dress_figures(const HeldDress& held) {
    return guarded([&] {
        val seconds = val::object();
        seconds.set("prepare", held.session.seconds().prepare);
        val result = val::object();
        result.set("seconds", seconds);
        return result;
    });
}

val inside_count(const lissom::Inside& inside) {
    val result = val::object();
    result.set("vertices", inside.vertices);
    result.set("faceCentres", inside.face_centres);
    return result;
}

// dress(offset) → Dressed
val dress(HeldDress& held, double offset) {
    return guarded([&] {
        const lissom::Dressed found = held.session.dress(offset);
        val seconds = val::object();
        seconds.set("dress", held.session.seconds().dress);
        val result = val::object();
        result.set("positions", float64_array(found.positions));
        result.set("before", inside_count(found.before));
        result.set("after", inside_count(found.after));
        result.set("rounds", found.rounds);
        result.set("warnings", findings(found.warnings));
        result.set("seconds", seconds);
        return result;
    });
}

// new SkinPose(source, target, triangles: Uint32Array, from: Float64Array, to: Float64Array)
lissom::SkinPose* prepare_through(const std::shared_ptr<lissom::WorkingMesh>& source, const std::shared_ptr<lissom::WorkingMesh>& target, const val& corners, const val& from, const val& to) {
    return guarded([&] { return new lissom::SkinPose(*source, *target, triangles(corners), points(from), points(to)); });
}

// figures() → what PreparedThrough of web/kernel/contract/wear.ts says of it
val through_figures(const lissom::SkinPose& session) {
    return guarded([&] {
        val seconds = val::object();
        seconds.set("prepare", session.seconds().prepare);
        val result = val::object();
        result.set("unknowns", session.unknowns());
        result.set("seconds", seconds);
        return result;
    });
}

bool through_step(lissom::SkinPose& session) {
    return guarded([&] { return session.step(); });
}
double through_fraction(const lissom::SkinPose& session) { return session.fraction(); }

// give(pose: Float64Array, strength, keepStretch) → TransferredThrough
val give_through(lissom::SkinPose& session, const val& pose, double strength, bool keep_stretch) {
    return guarded([&] {
        const lissom::Points given = session.give(points(pose), {.strength = strength, .keep_stretch = keep_stretch});
        val seconds = val::object();
        seconds.set("solve", session.seconds().solve);
        val result = val::object();
        result.set("positions", float64_array(given));
        result.set("iterations", session.rounds());
        result.set("seconds", seconds);
        return result;
    });
}

// placesOn(model, points: Float64Array) → SurfacePlaces
val places_on(const std::shared_ptr<lissom::WorkingMesh>& model, const val& given) {
    return guarded([&] {
        const lissom::SurfacePlaces places = lissom::places_on({model->source, model->display}, points(given));
        val result = val::object();
        result.set("triangles", int32_array(places.triangle));
        result.set("weights", float64_array(places.weights));
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(wear) {
    function("placesOn", &places_on);
    class_<HeldBlend>("BlendSession")
        .constructor(&prepare_blend, allow_raw_pointers())
        .function("step", &bindings::step<HeldBlend>)
        .function("fraction", &bindings::fraction<HeldBlend>)
        .function("figures", &blend_figures)
        .function("blend", &blend);
    class_<HeldDress>("DressSession")
        .constructor(&prepare_dress, allow_raw_pointers())
        .function("step", &bindings::step<HeldDress>)
        .function("fraction", &bindings::fraction<HeldDress>)
        .function("figures", &dress_figures)
        .function("dress", &dress);
    class_<lissom::SkinPose>("SkinPose")
        .constructor(&prepare_through, allow_raw_pointers())
        .function("step", &through_step)
        .function("fraction", &through_fraction)
        .function("figures", &through_figures)
        .function("give", &give_through);
}
