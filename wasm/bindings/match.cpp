#include "convert.h"
#include "session.h"
#include "lissom/match/marker_alignment.h"
#include "lissom/match/match_session.h"
#include "lissom/match/pairwise_match.h"
#include "lissom/match/places.h"
#include "lissom/match/sharp_curves.h"

#include <emscripten/bind.h>

#include <memory>
#include <string>
#include <variant>

using namespace emscripten;
using namespace bindings;

namespace {

/// A session together with the models it refers to, so that any may be released first.
struct HeldMatch {
    std::vector<std::shared_ptr<lissom::WorkingMesh>> models;
    std::variant<lissom::MatchSession, lissom::PairwiseMatch> session;
    int iterations = 0; ///< of carrying, fitting and changing edges

    [[nodiscard]] double fraction() const {
        return std::visit([](const auto& match) { return match.fraction(); }, session);
    }
};

lissom::MatchOptions match_options(const val& given, const lissom::WorkingMesh& source) {
    lissom::MatchOptions options;
    if (const val start = given["start"]; !start.isUndefined())
        options.start = named<lissom::MatchStart>(start, "start", {{"automatic", lissom::MatchStart::automatic}, {"similarity", lissom::MatchStart::similarity}, {"radial", lissom::MatchStart::radial}});
    if (const val first = given["first"]; !first.isUndefined())
        options.first = named<lissom::FirstSkin>(first, "first skin", {{"copy", lissom::FirstSkin::copy}, {"remesh", lissom::FirstSkin::remesh}, {"wrap", lissom::FirstSkin::wrap},
                                                                        {"box", lissom::FirstSkin::box}, {"sphere", lissom::FirstSkin::sphere}, {"torus", lissom::FirstSkin::torus}});
    read(given, "genus", options.genus);
    if (const val method = given["method"]; !method.isUndefined())
        options.method = named<lissom::MatchMethod>(method, "method", {{"graph", lissom::MatchMethod::graph}, {"paper", lissom::MatchMethod::paper}});
    read(given, "adapt", options.adapt);
    read(given, "sharpAngle", options.sharp_angle);
    read(given, "edgeLength", options.edge_length);
    options.edge_length /= source.scale * lissom::surface_size(source.mesh).size;
    return options;
}

std::vector<lissom::MatchModel> match_models(const std::vector<std::shared_ptr<lissom::WorkingMesh>>& models, const val& marked) {
    std::vector<lissom::MatchModel> all;
    for (std::size_t k = 0; k < models.size(); ++k) {
        const val one = marked[k];
        lissom::MatchModel model{models[k].get(), points(one["markers"])};
        model.ignored = indices(one["ignored"]);
        for (const val& curve : vecFromJSArray<val>(one["curves"])) model.curves.push_back(points(curve));
        for (const val& chain : vecFromJSArray<val>(one["sharp"])) model.sharp.push_back(indices(chain));
        all.push_back(std::move(model));
    }
    return all;
}

// new MatchSession(models: WorkingMesh[], marked: { markers, … }[], options)
HeldMatch* prepare(const val& list, const val& marked, const val& options) {
    return guarded([&] {
        std::vector<std::shared_ptr<lissom::WorkingMesh>> models;
        for (const val& one : vecFromJSArray<val>(list)) models.push_back(one.as<std::shared_ptr<lissom::WorkingMesh>>());
        if (models.empty()) throw lissom::InvalidInput("model-count", "There is no model to match.");
        const std::vector<lissom::MatchModel> given = match_models(models, marked);
        const lissom::MatchOptions chosen = match_options(options, *models.front());
        bool together = true;
        read(options, "together", together);
        if (together) return new HeldMatch{models, lissom::MatchSession(given, chosen)};
        return new HeldMatch{models, lissom::PairwiseMatch(given, chosen)};
    });
}

// step() → whether there is more
bool advance(HeldMatch& held) {
    return guarded([&] {
        ++held.iterations;
        return std::visit([](auto& match) { return match.step(); }, held.session);
    });
}

// look() → GrowingSkins, or undefined before there are any
val look(const HeldMatch& held) {
    return guarded([&] {
        const lissom::Triangles& triangles = std::visit([](const auto& match) -> const lissom::Triangles& { return match.triangles(); }, held.session);
        if (triangles.rows() == 0) return val::undefined();
        val positions = val::array();
        for (std::size_t k = 0; k < held.models.size(); ++k)
            positions.call<void>("push", float64_array(std::visit([&](const auto& match) { return match.positions(static_cast<int>(k)); }, held.session)));
        val result = val::object();
        result.set("triangles", uint32_array(triangles.data(), static_cast<std::size_t>(triangles.size())));
        result.set("positions", positions);
        return result;
    });
}

// What SkinFigures of web/kernel/contract/match.ts says of one skin.
val skin_figures(const lissom::SkinReport& skin) {
    val distance = val::object();
    distance.set("mean", skin.distances.mean_there);
    distance.set("back", skin.distances.mean_back);
    distance.set("p99", skin.distances.most);
    val result = val::object();
    result.set("distance", distance);
    result.set("flipped", skin.flipped);
    result.set("folds", skin.folds);
    result.set("selfIntersections", skin.crossings);
    if (skin.sharp_curves > 0) {
        val sharp = val::object();
        sharp.set("curves", skin.sharp_curves);
        sharp.set("failed", skin.sharp_failed);
        sharp.set("error", skin.sharp_error);
        result.set("sharp", sharp);
    }
    return result;
}

val match_warnings(const std::vector<lissom::MatchWarning>& warnings) {
    val result = val::array();
    for (const lissom::MatchWarning& warning : warnings) {
        val one = finding({warning.code, warning.count, warning.examples, false});
        one.set("model", warning.model);
        result.call<void>("push", one);
    }
    return result;
}

// result() → what Matched of web/kernel/contract/match.ts says, but for the memory
val result(const HeldMatch& held) {
    return guarded([&] {
        const lissom::MatchResult found = std::visit([](const auto& match) { return match.result(); }, held.session);
        const lissom::MatchReport& report = found.report;
        val positions = val::array(), figures = val::array(), residuals = val::array(), poorest = val::array();
        for (const lissom::Points& skin : found.skins.points) positions.call<void>("push", float64_array(skin));
        for (const lissom::SkinReport& skin : report.skins) {
            figures.call<void>("push", skin_figures(skin));
            residuals.call<void>("push", typed_array(skin.residuals.data(), skin.residuals.size()));
            poorest.call<void>("push", uint32_array(skin.worst.data(), skin.worst.size()));
        }
        val seconds = val::object();
        seconds.set("start", report.seconds.start);
        seconds.set("carry", report.seconds.carry);
        seconds.set("fine", report.seconds.fine);
        seconds.set("connectivity", report.seconds.connectivity);
        seconds.set("sharp", report.seconds.sharp);
        seconds.set("report", report.seconds.report);
        const lissom::Triangles& triangles = found.skins.triangles;
        val answer = val::object();
        answer.set("triangles", uint32_array(triangles.data(), static_cast<std::size_t>(triangles.size())));
        answer.set("positions", positions);
        answer.set("figures", figures);
        answer.set("residuals", residuals);
        answer.set("poorest", poorest);
        answer.set("markerVertices", uint32_array(found.marker_vertices.data(), found.marker_vertices.size()));
        answer.set("markerError", report.marker_error);
        answer.set("iterations", held.iterations);
        answer.set("warnings", match_warnings(report.warnings));
        answer.set("seconds", seconds);
        return answer;
    });
}

// carryPlaces(from, to, triangles, places) → Float64Array
val carry_places(const val& from, const val& to, const val& corners, const val& places) {
    return guarded([&] { return float64_array(lissom::carried_places({points(from), bindings::triangles(corners)}, points(to), points(places))); });
}

// guessPlace(from, to, fromMarkers, toMarkers, place) → Float64Array of 3
val guess_place(const std::shared_ptr<lissom::WorkingMesh>& from, const std::shared_ptr<lissom::WorkingMesh>& to, const val& from_markers, const val& to_markers, const val& place) {
    return guarded([&] {
        const lissom::Points one = points(place);
        if (one.rows() != 1) throw lissom::InvalidInput("wrong-size", "One place is guessed at a time, by three numbers.");
        return float64_array(lissom::guessed_place(*from, *to, points(from_markers), points(to_markers), one.row(0)));
    });
}

// sharpEdges(model, angle) → rows of source vertices; of a closed one the first stands last again
val sharp_edges(const std::shared_ptr<lissom::WorkingMesh>& model, double angle) {
    return guarded([&] {
        val rows = val::array();
        if (model->mesh.triangles.rows() == 0 || !(angle > 0)) return rows;
        for (const lissom::EdgeCurve& curve : lissom::sharp_curves(model->mesh, {.angle = angle})) {
            std::vector<int> row;
            for (const int v : curve.vertices) row.push_back(model->source_of_working[v]);
            if (curve.closed) row.push_back(row.front());
            rows.call<void>("push", uint32_array(row.data(), row.size()));
        }
        return rows;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(match) {
    function("carryPlaces", &carry_places);
    function("guessPlace", &guess_place);
    function("sharpEdges", &sharp_edges);
    class_<HeldMatch>("MatchSession")
        .constructor(&prepare, allow_raw_pointers())
        .function("step", &advance)
        .function("fraction", &HeldMatch::fraction)
        .function("look", &look)
        .function("result", &result);
}
