#pragma once

// The whole traffic between JS values and C++: copies only, so no view outlives a growth of the memory.

#include "lissom/mesh/errors.h"
#include "lissom/mesh/polyline.h"
#include "lissom/mesh/working_mesh.h"

#include <emscripten/val.h>

#include <initializer_list>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bindings {

using emscripten::val;

/// Uint32Array → indices; what does not fit an int becomes negative, hence out of range.
inline std::vector<int> indices(const val& uint32) {
    return emscripten::convertJSArrayToNumberVector<int>(uint32);
}

/// Float64Array of 3n → n×3.
inline lissom::Points points(const val& float64) {
    const auto length = float64["length"].as<std::size_t>();
    if (length % 3 != 0)
        throw lissom::InvalidInput("wrong-size", "Positions come in threes, but there are " + std::to_string(length) +
                                                     " numbers.");
    lissom::Points result(static_cast<Eigen::Index>(length / 3), 3);
    val(emscripten::typed_memory_view(length, result.data())).call<void>("set", float64);
    return result;
}

/// Uint32Array of 3m → m×3.
inline lissom::Triangles triangles(const val& uint32) {
    const std::vector<int> corners = indices(uint32);
    if (corners.size() % 3 != 0) throw lissom::InvalidInput("wrong-size", "Triangles have three corners each, but there are " + std::to_string(corners.size()) + " numbers.");
    return Eigen::Map<const lissom::Triangles>(corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
}

/// Float64Array of 3n → a line of n places.
inline lissom::Polyline polyline(const val& float64) {
    const lissom::Points rows = points(float64);
    lissom::Polyline line;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) line.push_back(rows.row(i).transpose());
    return line;
}

/// One of some kinds by its name. @param what  they are called, for who asks for another one
template <class Kind>
Kind named(const val& name, const char* what, std::initializer_list<std::pair<const char*, Kind>> kinds) {
    const auto given = name.as<std::string>();
    std::string known;
    for (const auto& [called, kind] : kinds) {
        if (given == called) return kind;
        const bool is_last = called == (kinds.end() - 1)->first;
        known += std::string(known.empty() ? "" : is_last ? " or " : ", ") + called;
    }
    throw lissom::InvalidInput("bad-option", std::string("There is no ") + what + " called '" + given + "'. Choose " + known + ".");
}

/// A fresh typed array that JS owns and may transfer; its element type is that of `numbers`.
template <typename Number>
val typed_array(const Number* numbers, std::size_t length) {
    return val(emscripten::typed_memory_view(length, numbers)).call<val>("slice");
}

inline val float64_array(const lissom::Points& points) {
    return typed_array(points.data(), static_cast<std::size_t>(points.size()));
}

inline val int32_array(const std::vector<int>& numbers) { return typed_array(numbers.data(), numbers.size()); }

/// For indices that are never negative.
inline val uint32_array(const int* numbers, std::size_t length) {
    return typed_array(reinterpret_cast<const unsigned*>(numbers), length);
}

/// As `Finding` of web/core/errors.ts.
inline val finding(const lissom::Finding& found) {
    val examples = val::array();
    for (const int index : found.examples) examples.call<void>("push", index);
    val one = val::object();
    one.set("code", found.code);
    one.set("count", found.count);
    one.set("examples", examples);
    one.set("repaired", found.repaired);
    return one;
}

/// Import findings and step warnings.
inline val findings(const std::vector<lissom::Finding>& list) {
    val result = val::array();
    for (const lissom::Finding& each : list) result.call<void>("push", finding(each));
    return result;
}

/// Reads options[name] into `field`; an absent one keeps the C++ default, the only place defaults live.
template <typename T>
void read(const val& options, const char* name, T& field) {
    if (const val given = options[name]; !given.isUndefined()) field = given.as<T>();
}

[[noreturn]] inline void throw_js(const std::string& code, const std::string& message, const char* fault) {
    val error = val::global("Error").new_(message);
    error.set("code", code);
    error.set("fault", std::string(fault));
    error.throw_();
}

/// Runs `body`; a C++ exception leaves it as a JS Error with `code` and `fault` (web/core/errors.ts).
template <typename Body>
auto guarded(Body&& body) -> decltype(body()) {
    try {
        return body();
    } catch (const lissom::InvalidInput& e) {
        throw_js(e.code(), e.what(), "input");
    } catch (const lissom::SolverFailure& e) {
        throw_js("solver-failure", e.what(), "solver");
    } catch (const std::bad_alloc&) {
        throw_js("out-of-memory", "", "memory");
    } catch (const std::length_error&) {
        throw_js("out-of-memory", "", "memory");
    } catch (const std::exception& e) {
        throw_js("kernel-crash", e.what(), "crash");
    }
}

} // namespace bindings
