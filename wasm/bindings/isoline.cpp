#include "handles.h"
#include "session.h"
#include "lissom/isoline/isoline_session.h"

#include <emscripten/bind.h>

#include <memory>
#include <string>

using namespace emscripten;
using namespace bindings;

namespace {

/// A prepared surface together with the model it was made of, so that either may be released first.
struct HeldModel {
    std::shared_ptr<lissom::WorkingMesh> working;
    lissom::IsolineModel session; ///< the name that bindings::step and ::fraction know
};

/// A session together with the surface it refers to.
struct HeldIsolines {
    std::shared_ptr<HeldModel> model;
    lissom::IsolineSession session;
    lissom::IsolineOptions options;
};

lissom::IsolineOptions isoline_options(const val& given) {
    using lissom::BasisKind, lissom::LocalStep;
    lissom::IsolineOptions options;
    if (const val basis = given["basis"]; !basis.isUndefined())
        options.basis = named<BasisKind>(basis, "basis", {{"quadratic", BasisKind::quadratic}, {"hats", BasisKind::hats}});
    if (const val local = given["local"]; !local.isUndefined())
        options.local = named<LocalStep>(local, "local step", {{"patches", LocalStep::patches}, {"isolines", LocalStep::isolines}, {"positions", LocalStep::positions}});
    read(given, "controls", options.controls);
    read(given, "sampledTriangles", options.sampled_triangles);
    read(given, "scaleDetails", options.scale_details);
    read(given, "settlePasses", options.settle_passes);
    return options;
}

// estimateIsolines(model, handles, options) → IsolineMemory of web/kernel/contract/isoline.ts
val estimate(const std::shared_ptr<lissom::WorkingMesh>& working, int handles, const val& given) {
    const lissom::IsolineMemory memory = lissom::estimate_isoline_memory(working->mesh.vertex_count(), working->mesh.triangle_count(), handles,
                                                                         isoline_options(given).controls);
    val result = val::object();
    result.set("model", memory.model);
    result.set("session", memory.session);
    result.set("settle", memory.settle);
    return result;
}

// new IsolineModel(model)
std::shared_ptr<HeldModel> open(const std::shared_ptr<lissom::WorkingMesh>& working) {
    return guarded([&] { return std::make_shared<HeldModel>(HeldModel{working, lissom::IsolineModel(*working)}); });
}

// figures() → what PreparedIsolineModel says of it
val model_figures(const HeldModel& held) {
    val seconds = val::object();
    seconds.set("surface", held.session.seconds());
    val result = val::object();
    result.set("vertices", held.session.surface().mesh.vertex_count());
    result.set("proxy", held.session.is_proxy());
    result.set("smoothed", held.session.smoothed());
    result.set("seconds", seconds);
    return result;
}

// new IsolineSession(isolineModel, roi: Uint32Array, handles: { kind, vertices: Uint32Array }[], options)
HeldIsolines* prepare(const std::shared_ptr<HeldModel>& model, const val& roi, const val& handles, const val& given) {
    return guarded([&] {
        const lissom::IsolineOptions options = isoline_options(given);
        return new HeldIsolines{model, lissom::IsolineSession(model->session, indices(roi), handle_groups(handles), options), options};
    });
}

// figures() → what PreparedIsolines says of it
val figures(const HeldIsolines& held) {
    return guarded([&] {
        val seconds = val::object();
        seconds.set("fields", held.session.seconds().fields);
        seconds.set("reduce", held.session.seconds().reduce);
        val result = val::object();
        result.set("unknowns", held.session.unknowns());
        result.set("freeHandles", held.session.free_handle_count());
        result.set("settlesFully", held.session.settles_fully());
        result.set("sets", held.session.sets().sets());
        result.set("single", held.session.sets().mirrored());
        result.set("basis", std::string(held.options.basis == lissom::BasisKind::hats ? "hats" : "quadratic"));
        result.set("controls", held.session.sets().basis.controls());
        result.set("warnings", findings(held.session.warnings()));
        result.set("seconds", seconds);
        return result;
    });
}

// drag(targets: Float64Array, solves, afresh) → IsolineFrame
val drag(HeldIsolines& held, const val& targets, int solves, bool afresh) {
    return guarded([&] {
        const lissom::IsolineFrame frame = held.session.drag(affine_maps(targets), solves, afresh);
        const std::vector<double> offsets = held.session.control_offsets();
        val seconds = val::object();
        seconds.set("perIteration", frame.solves > 0 ? (frame.local_seconds + frame.global_seconds) / frame.solves : 0);
        val result = val::object();
        result.set("offsets", typed_array(offsets.data(), offsets.size()));
        result.set("iterations", frame.solves);
        result.set("change", frame.change);
        result.set("warnings", findings(frame.warnings));
        result.set("seconds", seconds);
        return result;
    });
}

val positions(const HeldIsolines& held) {
    return guarded([&] { return float64_array(held.session.positions()); });
}

bool settle_step(HeldIsolines& held) {
    return guarded([&] { return held.session.settle_step(); });
}

val settled(const HeldIsolines& held) {
    return guarded([&] { return float64_array(held.session.settled()); });
}

// fields() → IsolineFields
val fields(const HeldIsolines& held) {
    return guarded([&] {
        val result = val::object();
        const auto put = [&](const char* name, const auto& numbers) { result.set(name, typed_array(numbers.data(), numbers.size())); };
        put("fields", held.session.set_fields());
        put("gradients", held.session.set_gradients());
        put("still", held.session.still_vertices());
        return result;
    });
}

void check_field(const HeldIsolines& held, int f, int least) {
    if (f < least || f >= held.session.field_count())
        throw lissom::InvalidInput("handle-count", "There is no field of handle " + std::to_string(f + 1) + "; there are " +
                                                       std::to_string(held.session.field_count()) + ".");
}

// field(handle, what) → Float32Array, one number per source vertex
val field(const HeldIsolines& held, int handle, const std::string& what) {
    return guarded([&] {
        const bool rigidity = what == "rigidity";
        check_field(held, handle, rigidity ? -1 : 0);
        const Eigen::VectorXf values = rigidity ? held.session.rigidity(handle) : held.session.field(handle);
        return typed_array(values.data(), static_cast<std::size_t>(values.size()));
    });
}

// curves(handle, count) → { points, offsets }: every loop and chain of every isoline as points one after the other
val curves(const HeldIsolines& held, int handle, int count) {
    return guarded([&] {
        check_field(held, handle, 0);
        std::vector<double> points;
        std::vector<unsigned> offsets{0};
        const auto add = [&](const Eigen::Vector3d& p) { points.insert(points.end(), {p[0], p[1], p[2]}); };
        for (const lissom::Isoline& line : held.session.isolines(handle, count))
            for (const std::vector<int>& loop : line.loops) {
                add(line.segments[loop.front()].from);
                for (const int s : loop) add(line.segments[s].to);
                offsets.push_back(static_cast<unsigned>(points.size() / 3));
            }
        val result = val::object();
        result.set("points", typed_array(points.data(), points.size()));
        result.set("offsets", typed_array(offsets.data(), offsets.size()));
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(isoline) {
    function("estimateIsolines", &estimate);
    class_<HeldModel>("IsolineModel")
        .smart_ptr_constructor("IsolineModel", &open)
        .function("step", &bindings::step<HeldModel>)
        .function("fraction", &bindings::fraction<HeldModel>)
        .function("figures", &model_figures);
    class_<HeldIsolines>("IsolineSession")
        .constructor(&prepare, allow_raw_pointers())
        .function("step", &bindings::step<HeldIsolines>)
        .function("fraction", &bindings::fraction<HeldIsolines>)
        .function("figures", &figures)
        .function("drag", &drag)
        .function("positions", &positions)
        .function("settleStep", &settle_step)
        .function("settled", &settled)
        .function("fields", &fields)
        .function("field", &field)
        .function("curves", &curves);
}
