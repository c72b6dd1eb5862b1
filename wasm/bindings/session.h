#pragma once

// What the bindings of sessions that are prepared step by step have in common. `Held` keeps one as `session`.

#include "convert.h"

namespace bindings {

/// One piece of the preparation. @return whether there is more
template <class Held>
bool step(Held& held) {
    return guarded([&] { return held.session.step(); });
}

/// How much of it is done, 0..1.
template <class Held>
double fraction(const Held& held) {
    return held.session.fraction();
}

/// What PreparedDeform and PreparedMerge of web/kernel/contract.ts both say of a factorized system.
template <class Session>
val prepared_figures(const Session& session, double assemble_seconds) {
    val seconds = val::object();
    seconds.set("assemble", assemble_seconds);
    seconds.set("factor", session.factor_seconds());
    val result = val::object();
    result.set("free", session.free_vertices());
    result.set("degenerate", session.degenerate_vertices());
    result.set("warnings", findings(session.warnings()));
    result.set("seconds", seconds);
    return result;
}

} // namespace bindings
