#include "handles.h"
#include "session.h"
#include "lissom/deform/deform_session.h"

#include <emscripten/bind.h>

#include <memory>

using namespace emscripten;
using namespace bindings;

namespace {

/// A session together with the model it refers to, so that either may be released first.
struct HeldSession {
    std::shared_ptr<lissom::WorkingMesh> working;
    lissom::DeformSession session;
};

lissom::DeformOptions deform_options(const val& given) {
    using Method = lissom::DeformMethod;
    lissom::DeformOptions options;
    if (const val method = given["method"]; !method.isUndefined())
        options.method = named<Method>(method, "deformation method", {{"implicit", Method::implicit}, {"iterative", Method::iterative}, {"naive", Method::naive}});
    read(given, "removeShear", options.remove_shear);
    read(given, "scaleDetails", options.scale_details);
    read(given, "iterations", options.iterations);
    read(given, "coherenceRing", options.coherence_ring);
    return options;
}

// new DeformSession(model, roi: Uint32Array, handles: { kind, vertices: Uint32Array }[], options)
HeldSession* prepare(const std::shared_ptr<lissom::WorkingMesh>& working, const val& roi, const val& handles,
                     const val& options) {
    return guarded([&] {
        return new HeldSession{working,
                               lissom::DeformSession(*working, indices(roi), handle_groups(handles), deform_options(options))};
    });
}

// figures() → what PreparedDeform of web/kernel/contract.ts says of a prepared session
val figures(const HeldSession& held) {
    return guarded([&] { return bindings::prepared_figures(held.session, held.session.assemble_seconds()); });
}

// deform(targets: Float64Array, settle) → Deformed of web/kernel/contract.ts
val deform(const HeldSession& held, const val& targets, bool settle) {
    return guarded([&] {
        const lissom::DeformResult moved = held.session.deform(affine_maps(targets), settle);
        val seconds = val::object();
        seconds.set("solve", moved.solve_seconds);
        seconds.set("rotate", moved.rotate_seconds);
        seconds.set("reconstruct", moved.reconstruct_seconds);
        val result = val::object();
        result.set("positions", float64_array(moved.positions));
        result.set("iterations", moved.iterations);
        result.set("warnings", findings(moved.warnings));
        result.set("seconds", seconds);
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(deform) {
    class_<HeldSession>("DeformSession")
        .constructor(&prepare, allow_raw_pointers())
        .function("step", &bindings::step<HeldSession>)
        .function("fraction", &bindings::fraction<HeldSession>)
        .function("figures", &figures)
        .function("deform", &deform);
}
