#include "session.h"
#include "lissom/hair/hair_session.h"
#include "lissom/mesh/stopwatch.h"

#include <emscripten/bind.h>

#include <array>
#include <memory>

using namespace emscripten;
using namespace bindings;

namespace {

/// A session together with the model whose vertices its arguments count.
struct HeldHair {
    std::shared_ptr<lissom::WorkingMesh> working;
    lissom::HairSession session;
};

/// Strands under way.
struct HeldGrowth {
    lissom::HairSession::Growth growth;
    Eigen::Vector3d origin;
    double seconds = 0;
};

lissom::TriangleMesh source_mesh(const lissom::WorkingMesh& working) {
    lissom::TriangleMesh mesh = working.mesh;
    mesh.points = (mesh.points * working.scale).rowwise() + working.centre.transpose();
    return mesh;
}

std::vector<int> working_vertices(const lissom::WorkingMesh& working, const std::vector<int>& source) {
    std::vector<int> out;
    for (const int v : source) {
        if (v < 0 || v >= static_cast<int>(working.working_of_source.size()))
            throw lissom::InvalidInput("scalp-vertex", "The scalp names a vertex that the head does not have.");
        if (working.working_of_source[static_cast<std::size_t>(v)] >= 0)
            out.push_back(working.working_of_source[static_cast<std::size_t>(v)]);
    }
    return out;
}

// new HairSession(model, scalp: Uint32Array, resolution, up: 'y' | 'z')
HeldHair* open_session(const std::shared_ptr<lissom::WorkingMesh>& working, const val& scalp, int resolution, const std::string& up) {
    return guarded([&] {
        const lissom::UpAxis axis = up == "z" ? lissom::UpAxis::z : lissom::UpAxis::y;
        return new HeldHair{working, lissom::HairSession(source_mesh(*working), working_vertices(*working, indices(scalp)),
                                                         resolution, axis)};
    });
}

val three(const Eigen::Vector3d& p) {
    val result = val::array();
    for (int d = 0; d < 3; ++d) result.set(d, p[d]);
    return result;
}

// describe() → OpenedHair of web/kernel/contract.ts, without its id
val describe(const HeldHair& held) {
    return guarded([&] {
        const lissom::HairVolume& volume = held.session.volume();
        const Eigen::Vector3d low = volume.field.origin + held.session.origin();
        val seconds = val::object();
        seconds.set("prepare", held.session.prepare_seconds());
        val result = val::object();
        result.set("grid", three(volume.field.size.cast<double>()));
        result.set("low", three(low));
        result.set("high", three(low + volume.field.step * (volume.field.size.array() - 1).cast<double>().matrix()));
        result.set("headHeight", volume.head_height);
        result.set("seconds", seconds);
        return result;
    });
}

// style(HairStyleSpec) → StyledHair of web/kernel/contract.ts
val style(HeldHair& held, const val& given) {
    return guarded([&] {
        lissom::HairStyle wanted;
        for (const val& stream : vecFromJSArray<val>(given["streams"]))
            wanted.streams.push_back({polyline(stream["points"]), stream["fade"].as<bool>()});
        for (const val& parting : vecFromJSArray<val>(given["partings"])) {
            lissom::DividingCurve curve;
            curve.points = polyline(parting["points"]);
            for (int end = 0; end < 2; ++end) curve.tilt[end] = parting["tilt"][end].as<double>();
            curve.sigma = parting["sigma"].as<double>();
            curve.height = parting["height"].as<double>();
            wanted.partings.push_back(curve);
        }
        for (const val& ponytail : vecFromJSArray<val>(given["ponytails"])) {
            lissom::Ponytail tail;
            tail.spine = polyline(ponytail["spine"]);
            tail.section = polyline(ponytail["section"]);
            const std::vector<val> profiles = vecFromJSArray<val>(ponytail["profiles"]);
            for (std::size_t i = 0; i < std::min<std::size_t>(2, profiles.size()); ++i) tail.profiles[i] = polyline(profiles[i]);
            tail.tightness = ponytail["tightness"].as<double>();
            wanted.ponytails.push_back(tail);
        }
        held.session.set_style(wanted);
        val seconds = val::object();
        seconds.set("update", held.session.update_seconds());
        seconds.set("field", held.session.field_seconds());
        val result = val::object();
        result.set("constraints", held.session.constraints().size());
        result.set("warnings", findings(held.session.warnings()));
        result.set("seconds", seconds);
        return result;
    });
}

/// FieldVectors of web/kernel/contract.ts under construction: arrows of one grid.
struct Arrows {
    const HeldHair& held;
    double unit; ///< length of a vector of length 1, head units
    std::vector<float> places, vectors;

    void add(int node, const Eigen::Vector3d& vector) {
        const Eigen::Vector3d p = held.session.volume().field.position(node) + held.session.origin();
        for (int d = 0; d < 3; ++d) {
            places.push_back(static_cast<float>(p[d]));
            vectors.push_back(static_cast<float>(vector[d] * unit));
        }
    }
    [[nodiscard]] val take() const {
        val result = val::object();
        result.set("places", typed_array(places.data(), places.size()));
        result.set("vectors", typed_array(vectors.data(), vectors.size()));
        return result;
    }
};

// field(stride) → FieldVectors: every stride-th node per axis
val field(const HeldHair& held, int stride) {
    return guarded([&] {
        if (stride < 1) throw lissom::InvalidInput("bad-option", "The stride of a field's picture is 1 or more.");
        const lissom::VectorField& t = held.session.field();
        Arrows arrows{held, t.grid.step * stride, {}, {}};
        for (int node = 0; node < t.grid.count(); ++node) {
            const Eigen::Vector3i cell = t.grid.cell(node);
            if (cell.x() % stride || cell.y() % stride || cell.z() % stride) continue;
            arrows.add(node, t.vectors.row(node).transpose());
        }
        return arrows.take();
    });
}

// constraints() → FieldVectors: what the field was asked for, one grid step long
val constraints(const HeldHair& held) {
    return guarded([&] {
        Arrows arrows{held, held.session.volume().field.step, {}, {}};
        for (const lissom::FieldConstraint& c : held.session.constraints()) arrows.add(c.node, c.vector);
        return arrows.take();
    });
}

template <typename T>
void read(const val& options, const char* name, std::optional<T>& field) {
    if (const val given = options[name]; !given.isUndefined()) field = given.as<T>();
}

// new HairGrowth(session, from, count, GrowthOptions of web/kernel/contract.ts)
HeldGrowth* grow(const HeldHair& held, double from, double count, const val& given) {
    return guarded([&] {
        lissom::GrowthOptions growth;
        double seed = 1;
        bindings::read(given, "seed", seed);
        growth.seed = static_cast<std::uint64_t>(seed);
        bindings::read(given, "step", growth.step);
        read(given, "length", growth.length);
        bindings::read(given, "lengthVariation", growth.length_variation);
        read(given, "volume", growth.volume);
        if (const val map = given["lengthMap"]; !map.isUndefined()) {
            const auto source = convertJSArrayToNumberVector<float>(map);
            if (source.size() != held.working->working_of_source.size())
                throw lissom::InvalidInput("bad-option", "The painted length needs one number for each vertex of the head.");
            for (const int v : held.working->source_of_working) growth.length_map.push_back(source[static_cast<std::size_t>(v)]);
        }
        lissom::DetailOptions detail;
        bindings::read(given, "clump", detail.clump);
        bindings::read(given, "curl", detail.curl);
        read(given, "curlLength", detail.curl_length);
        bindings::read(given, "frizz", detail.frizz);
        bindings::read(given, "flyaways", detail.flyaways);
        constexpr double most = 2e9; // an int; what is too much is said in the session's own words
        return new HeldGrowth{held.session.grow(static_cast<int>(std::min(from, most)), static_cast<int>(std::min(count, most)),
                                                growth, detail),
                              held.session.origin()};
    });
}

bool grow_on(HeldGrowth& held) {
    return guarded([&] {
        lissom::Stopwatch watch;
        const bool more = held.growth.step();
        held.seconds += watch.lap();
        return more;
    });
}
double grown(const HeldGrowth& held) { return held.growth.fraction(); }

// take() → GrownHair of web/kernel/contract.ts, once
val take(HeldGrowth& held) {
    return guarded([&] {
        const lissom::HairFigures& figures = held.growth.figures();
        val seconds = val::object();
        seconds.set("grow", held.seconds);
        val result = val::object();
        result.set("insideHead", figures.inside_head);
        result.set("shortStrands", figures.short_strands);
        result.set("reached", val::array(figures.reached));
        result.set("gathered", val::array(figures.gathered));
        result.set("seconds", seconds);
        result.set("origin", typed_array(held.origin.data(), 3));
        const lissom::Strands strands = held.growth.take();
        result.set("offsets", typed_array(strands.offsets.data(), strands.offsets.size()));
        result.set("points", typed_array(strands.points.data(), strands.points.size()));
        result.set("rootUvs", typed_array(strands.root_uvs.data(), strands.root_uvs.size()));
        result.set("groups", typed_array(strands.clumps.data(), strands.clumps.size()));
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(hair) {
    class_<HeldHair>("HairSession")
        .constructor(&open_session, allow_raw_pointers())
        .function("step", &bindings::step<HeldHair>)
        .function("fraction", &bindings::fraction<HeldHair>)
        .function("describe", &describe)
        .function("style", &style)
        .function("field", &field)
        .function("constraints", &constraints);
    class_<HeldGrowth>("HairGrowth")
        .constructor(&grow, allow_raw_pointers())
        .function("step", &grow_on)
        .function("fraction", &grown)
        .function("take", &take);
}
