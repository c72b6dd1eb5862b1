#include "session.h"
#include "lissom/merge/merge_session.h"

#include <emscripten/bind.h>

#include <cmath>
#include <memory>
#include <optional>

using namespace emscripten;
using namespace bindings;

namespace {

using lissom::WorkingMesh;

/// A session together with the models it refers to, so that any may be released first.
struct HeldMerge {
    std::shared_ptr<WorkingMesh> source, target;
    lissom::MergeSession session;
};

// column-major 4×4, as THREE.Matrix4.elements
Eigen::Affine3d affine_map(const val& matrix, const char* what) {
    const auto flat = convertJSArrayToNumberVector<double>(matrix);
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    if (flat.size() == 16) map.matrix() = Eigen::Map<const Eigen::Matrix4d>(flat.data());
    if (flat.size() != 16 || !map.matrix().allFinite() || map.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
        throw lissom::InvalidInput("not-affine", std::string("The ") + what + " is not made of a move, a turn and a scale. Reset it.");
    return map;
}

lissom::MergeOptions merge_options(const val& given) {
    lissom::MergeOptions options;
    if (const val mode = given["mode"]; !mode.isUndefined())
        options.mode = mode.as<std::string>() == "dependent" ? lissom::MergeMode::dependent : lissom::MergeMode::independent;
    read(given, "smoothing", options.smoothing);
    read(given, "coherenceRing", options.coherence_ring);
    if (const val given_transition = given["transition"]; !given_transition.isUndefined()) {
        lissom::Transition transition{given_transition["sourceWidth"].as<double>(), given_transition["targetWidth"].as<double>()};
        read(given_transition, "weight", transition.weight);
        options.transition = transition;
    }
    if (const val pose = given["pose"]; !pose.isUndefined()) options.placement = affine_map(pose, "placement of the source");
    return options;
}

// new MergeSession(source, target, boundaries: MergeBoundarySpec[], roi: Uint32Array, handles, options)
HeldMerge* prepare(const std::shared_ptr<WorkingMesh>& source, const std::shared_ptr<WorkingMesh>& target, const val& boundaries,
                   const val& roi, const val& handles, const val& options) {
    return guarded([&] {
        std::vector<lissom::MergeBoundary> pairs;
        for (const val& pair : vecFromJSArray<val>(boundaries))
            pairs.push_back({{indices(pair["source"]), indices(pair["sourceKeep"])}, {indices(pair["target"]), indices(pair["targetKeep"])}});
        std::vector<lissom::MergeHandle> held;
        for (const val& handle : vecFromJSArray<val>(handles))
            held.push_back({indices(handle["vertices"]), affine_map(handle["matrix"], "transformation of a handle")});
        return new HeldMerge{source, target, lissom::MergeSession(*source, *target, pairs, merge_options(options), indices(roi), held)};
    });
}

// { shift: [x, y], turn, scale }
std::optional<lissom::Placement> placement_of(const val& given) {
    if (given.isUndefined()) return std::nullopt;
    const auto shift = convertJSArrayToNumberVector<double>(given["shift"]);
    lissom::Placement placement{Eigen::Vector2d(shift.at(0), shift.at(1)), given["turn"].as<double>(), given["scale"].as<double>()};
    if (!placement.shift.allFinite() || !std::isfinite(placement.turn) || !(placement.scale > 0) || !std::isfinite(placement.scale))
        throw lissom::InvalidInput("bad-placement", "The placement of the source's map has a scale that is not positive, or a number that is not finite. Reset it.");
    return placement;
}

val placed(const lissom::Placement& placement) {
    val shift = val::array(), result = val::object();
    shift.call<void>("push", placement.shift.x());
    shift.call<void>("push", placement.shift.y());
    result.set("shift", shift);
    result.set("turn", placement.turn);
    result.set("scale", placement.scale);
    return result;
}

// mergeAlongOptimalBoundary(source, target, regions: PaintedRegions, options)
HeldMerge* prepare_optimal(const std::shared_ptr<WorkingMesh>& source, const std::shared_ptr<WorkingMesh>& target, const val& regions,
                           const val& options) {
    return guarded([&] {
        lissom::PaintedRegions painted{indices(regions["sourceRegion"]), indices(regions["feature"]), indices(regions["targetRegion"]),
                                       placement_of(regions["placement"])};
        read(regions, "rounds", painted.rounds);
        return new HeldMerge{source, target, lissom::MergeSession(*source, *target, painted, merge_options(options))};
    });
}

// figures() → what PreparedMerge of web/kernel/contract.ts says of a prepared session
val figures(const HeldMerge& held) {
    return guarded([&] {
        val result = bindings::prepared_figures(held.session, held.session.prepare_seconds());
        const std::vector<double>& energies = held.session.energies();
        result.set("energies", typed_array(energies.data(), energies.size()));
        if (held.session.placement()) result.set("placement", placed(*held.session.placement()));
        return result;
    });
}

val uint32_array(const std::vector<int>& numbers) { return bindings::uint32_array(numbers.data(), numbers.size()); }

val flags(const std::vector<char>& given) {
    return typed_array(reinterpret_cast<const unsigned char*>(given.data()), given.size());
}

val origins(const std::vector<lissom::Origin>& list) {
    std::vector<int> vertices;
    std::vector<double> weights;
    for (const lissom::Origin& origin : list)
        for (int k = 0; k < 3; ++k) {
            vertices.push_back(origin.vertex[k]);
            weights.push_back(origin.weight[k]);
        }
    val result = val::object();
    result.set("vertices", uint32_array(vertices));
    result.set("weights", typed_array(weights.data(), weights.size()));
    return result;
}

val plane_map(const lissom::WorkingMesh& working, const std::vector<int>& vertices, const lissom::TriangleMesh& mesh,
              const lissom::PlanePoints& map) {
    std::vector<int> files;
    for (const int v : vertices) files.push_back(working.source_of_working[v]);
    val result = val::object();
    result.set("vertices", uint32_array(files));
    result.set("triangles", bindings::uint32_array(mesh.triangles.data(), static_cast<std::size_t>(mesh.triangles.size())));
    result.set("points", typed_array(map.data(), static_cast<std::size_t>(vertices.size() * 2)));
    return result;
}

// mapRegions(source, target, regions: PaintedRegions) → RegionMaps of web/kernel/contract.ts
val map_regions(const WorkingMesh& source, const WorkingMesh& target, const val& regions) {
    return guarded([&] {
        const auto local = [](const WorkingMesh& working, const val& given) {
            std::vector<int> list;
            for (const int v : indices(given))
                if (v >= 0 && v < std::ssize(working.working_of_source) && working.working_of_source[v] >= 0) list.push_back(working.working_of_source[v]);
            return list;
        };
        const lissom::RegionMaps maps = lissom::map_regions(source.mesh, local(source, regions["sourceRegion"]), local(source, regions["feature"]),
                                                            target.mesh, local(target, regions["targetRegion"]));
        val result = val::object();
        result.set("source", plane_map(source, maps.ring_vertices, maps.ring, maps.ring_map));
        result.set("target", plane_map(target, maps.disk_vertices, maps.disk, maps.disk_map));
        result.set("placement", placed(lissom::best_placement(maps)));
        return result;
    });
}

val contribution(const lissom::Contribution& part) {
    val result = val::object();
    result.set("resultOfVertex", int32_array(part.result_of_vertex));
    result.set("faces", uint32_array(part.faces));
    result.set("turned", flags(part.turned));
    return result;
}

val seam_of(const lissom::SeamFigures& figures) {
    val result = val::object();
    result.set("vertices", figures.vertices);
    result.set("medianDihedral", figures.median_dihedral);
    result.set("highDihedral", figures.high_dihedral);
    result.set("maxDihedral", figures.max_dihedral);
    result.set("ownHighDihedral", figures.own_high_dihedral);
    result.set("leastAngle", figures.least_angle);
    return result;
}

// merge(keys: Uint32Array[] of source, target, source, target …, settle) → Merged of web/kernel/contract.ts
val merge(const HeldMerge& held, const val& keys, bool settle) {
    return guarded([&] {
        std::vector<lissom::MergeKeys> pairs;
        for (const val& flat : vecFromJSArray<val>(keys)) {
            const std::vector<int> numbers = indices(flat);
            auto& list = pairs.emplace_back();
            for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) list.emplace_back(numbers[k], numbers[k + 1]);
        }
        const lissom::MergeResult merged = held.session.merge(pairs, settle);
        const lissom::MergedModel& model = merged.model;
        val seconds = val::object();
        seconds.set("solve", merged.solve_seconds);
        seconds.set("stitch", merged.stitch_seconds);
        val seams = val::array(), used = val::array();
        for (const std::vector<int>& seam : model.seams) seams.call<void>("push", uint32_array(seam));
        for (const lissom::MergeKeys& list : merged.keys) {
            std::vector<int> flat;
            for (const auto& [s, t] : list) {
                flat.push_back(s);
                flat.push_back(t);
            }
            used.call<void>("push", uint32_array(flat));
        }
        val result = val::object();
        result.set("positions", float64_array(model.positions));
        result.set("target", contribution(model.target));
        result.set("source", contribution(model.source));
        result.set("newFromSource", flags(model.new_from_source));
        result.set("newOrigins", origins(model.new_origin));
        result.set("cutVertices", uint32_array(model.cut_vertices));
        result.set("cutFromSource", flags(model.cut_from_source));
        result.set("cutFaces", uint32_array(model.cut_face));
        result.set("cutOrigins", origins(model.cut_corners));
        result.set("seams", seams);
        result.set("keys", used);
        result.set("eulerCharacteristic", model.euler_characteristic);
        result.set("seam", seam_of(merged.seam));
        result.set("sourceTurned", merged.source_turned);
        result.set("warnings", findings(merged.warnings));
        result.set("seconds", seconds);
        return result;
    });
}

// loopsAround(model, vertices: Uint32Array) → Uint32Array[]
val loops_around(const WorkingMesh& working, const val& vertices) {
    return guarded([&] {
        std::vector<int> region;
        for (const int v : indices(vertices))
            if (v >= 0 && v < std::ssize(working.working_of_source) && working.working_of_source[v] >= 0) region.push_back(working.working_of_source[v]);
        val result = val::array();
        for (std::vector<int>& loop : lissom::loops_around(working.mesh, region)) {
            for (int& v : loop) v = working.source_of_working[v];
            result.call<void>("push", uint32_array(loop));
        }
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(merge) {
    class_<HeldMerge>("MergeSession")
        .constructor(&prepare, allow_raw_pointers())
        .function("step", &bindings::step<HeldMerge>)
        .function("fraction", &bindings::fraction<HeldMerge>)
        .function("figures", &figures)
        .function("merge", &merge);
    function("mergeAlongOptimalBoundary", &prepare_optimal, allow_raw_pointers());
    function("mapRegions", &map_regions);
    function("loopsAround", &loops_around);
}
