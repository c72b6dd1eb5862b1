#include "lissom/wear/blend_session.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/stopwatch.h"
#include "lissom/wear/synthesis.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>

namespace lissom {

namespace {

constexpr double k_missed = 0.01;
constexpr double k_far = 0.5;

} // namespace

struct BlendSession::State {
    std::vector<Points> skins;
    Measurer measurer;
    std::deque<TriangleMesh> shapes; ///< of parts: they refer to them
    std::vector<PartPaste> parts;
    std::size_t done = 0;
    BlendSeconds seconds;
};

BlendSession::BlendSession(const Triangles& triangles, std::vector<Points> skins, const std::vector<PartSpec>& parts) {
    if (skins.empty()) throw InvalidInput("no-skins", "There is no skin to blend.");
    const Eigen::Index n = skins.front().rows();
    for (const Points& skin : skins) {
        if (skin.rows() != n) throw InvalidInput("wrong-size", "Skins of " + std::to_string(n) + " and " + std::to_string(skin.rows()) + " vertices are not of one connectivity.");
        if (!skin.allFinite()) throw InvalidInput("non-finite-position", "A vertex of a skin has no finite position.");
    }
    if (triangles.size() > 0 && (triangles.minCoeff() < 0 || triangles.maxCoeff() >= n))
        throw InvalidInput("vertex-out-of-range", "A triangle of the skins names a vertex that they do not have.");
    state_.reset(new State{std::move(skins), Measurer(triangles, static_cast<int>(n)), {}, {}, 0, {}});
    State& s = *state_;
    for (const PartSpec& part : parts) {
        if (part.from < 0 || part.from >= std::ssize(s.skins)) throw InvalidInput("unknown-skin", "A part is to be taken from skin " + std::to_string(part.from) + ", which is not there.");
        s.shapes.push_back({s.skins[static_cast<std::size_t>(part.from)], triangles});
        s.parts.emplace_back(s.shapes.back(), part);
    }
}

BlendSession::~BlendSession() = default;
BlendSession::BlendSession(BlendSession&&) noexcept = default;

bool BlendSession::step() {
    State& s = *state_;
    Stopwatch watch;
    if (s.done < s.parts.size() && !s.parts[s.done].step()) ++s.done;
    s.seconds.factor += watch.lap();
    return s.done < s.parts.size();
}

double BlendSession::fraction() const {
    return state_->parts.empty() ? 1 : static_cast<double>(state_->done) / static_cast<double>(state_->parts.size());
}

Blended BlendSession::blend(const Eigen::VectorXd& weights, std::span<const Measure> measures) {
    State& s = *state_;
    if (weights.size() != std::ssize(s.skins))
        throw InvalidInput("wrong-size", "There are " + std::to_string(weights.size()) + " weights for " + std::to_string(s.skins.size()) + " skins.");
    bool is_wanted = false;
    for (std::size_t m = 0; m < measures.size(); ++m) {
        s.measurer.check(measures[m], static_cast<int>(m));
        is_wanted = is_wanted || measures[m].wanted;
    }
    if (!weights.allFinite() || (!is_wanted && weights.isZero(0))) throw InvalidInput("no-weights", "All weights are 0, or one is no number. Give at least one model a weight.");

    Stopwatch watch;
    Blended result{{}, weights, {}, 0, {}};
    if (is_wanted) {
        const Synthesis found = synthesised(s.measurer, s.skins, measures, weights);
        result.weights = found.weights, result.iterations = found.iterations;
    }
    s.seconds.measure = watch.lap();
    result.positions = blended(s.skins, result.weights);
    for (const PartPaste& part : s.parts) part.apply(result.positions);
    s.seconds.blend = watch.lap();
    for (std::size_t m = 0; m < measures.size(); ++m) result.reached.push_back(s.measurer.measure(result.positions, measures[m], static_cast<int>(m)).value);
    s.seconds.measure += watch.lap();

    const auto warn = [&](const char* code, const std::vector<int>& which) {
        if (!which.empty())
            result.warnings.push_back({.code = code, .count = static_cast<int>(which.size()), .examples = {which.begin(), which.begin() + std::min<std::ptrdiff_t>(8, std::ssize(which))}, .repaired = false});
    };
    std::vector<int> missed, far;
    for (std::size_t m = 0; m < measures.size(); ++m)
        if (measures[m].wanted && std::abs(result.reached[m] / *measures[m].wanted - 1) > k_missed) missed.push_back(static_cast<int>(m));
    for (Eigen::Index k = 0; k < weights.size(); ++k)
        if (is_wanted && std::abs(result.weights[k] - 0.5) > 0.5 + k_far) far.push_back(static_cast<int>(k));
    warn("measure-missed", missed);
    warn("weights-far", far);
    return result;
}

const BlendSeconds& BlendSession::seconds() const { return state_->seconds; }

} // namespace lissom
