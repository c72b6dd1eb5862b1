#include "session.h"
#include "lissom/isoline/pose_transfer.h"
#include "lissom/mesh/stopwatch.h"

#include <emscripten/bind.h>

#include <memory>

using namespace emscripten;
using namespace bindings;

namespace {

/// A session together with the models it refers to, so that any may be released first.
struct HeldTransfer {
    std::shared_ptr<lissom::WorkingMesh> source, target;
    lissom::PoseTransfer session;
};

std::vector<std::vector<int>> vertex_lists(const val& lists) {
    std::vector<std::vector<int>> groups;
    for (const val& list : vecFromJSArray<val>(lists)) groups.push_back(indices(list));
    return groups;
}

// new TransferSession(source, sourceHandles: Uint32Array[], target, targetHandles: Uint32Array[])
HeldTransfer* prepare(const std::shared_ptr<lissom::WorkingMesh>& source, const val& source_handles, const std::shared_ptr<lissom::WorkingMesh>& target,
                      const val& target_handles) {
    return guarded([&] {
        return new HeldTransfer{source, target, lissom::PoseTransfer(*source, vertex_lists(source_handles), *target, vertex_lists(target_handles))};
    });
}

// figures() → what PreparedTransfer of web/kernel/contract/transfer.ts says of it
val figures(const HeldTransfer& held) {
    return guarded([&] {
        val seconds = val::object();
        seconds.set("fields", held.session.seconds().fields);
        seconds.set("reduce", held.session.seconds().reduce);
        val result = val::object();
        result.set("unknowns", held.session.unknowns());
        result.set("warnings", findings(held.session.warnings()));
        result.set("seconds", seconds);
        return result;
    });
}

// transfer(pose: Float64Array, strength, keepStretch) → Transferred
val transfer(const HeldTransfer& held, const val& pose, double strength, bool keep_stretch) {
    return guarded([&] {
        lissom::Stopwatch watch;
        const lissom::Points posed = points(pose);
        const lissom::Points moved = held.session.transfer({&posed, 1}, {strength, keep_stretch}).front();
        const double spent = watch.lap();
        val seconds = val::object();
        seconds.set("perIteration", spent);
        seconds.set("solve", spent);
        val result = val::object();
        result.set("positions", float64_array(moved));
        result.set("iterations", 1);
        result.set("warnings", val::array());
        result.set("seconds", seconds);
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(transfer) {
    class_<HeldTransfer>("TransferSession")
        .constructor(&prepare, allow_raw_pointers())
        .function("step", &bindings::step<HeldTransfer>)
        .function("fraction", &bindings::fraction<HeldTransfer>)
        .function("figures", &figures)
        .function("transfer", &transfer);
}
