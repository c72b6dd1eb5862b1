#include "skin_checks.h"

#include "lissom/mesh/errors.h"

#include <string>

namespace lissom {

void check_skins(const Triangles& triangles, const Points& from, const Points& to) {
    if (from.rows() != to.rows())
        throw InvalidInput("wrong-size", "The skins have " + std::to_string(from.rows()) + " and " + std::to_string(to.rows()) + " vertices; they must be of one connectivity.");
    if (triangles.size() > 0 && (triangles.minCoeff() < 0 || triangles.maxCoeff() >= from.rows()))
        throw InvalidInput("vertex-out-of-range", "A triangle of the skins names a vertex that they do not have.");
    if (!from.allFinite() || !to.allFinite()) throw InvalidInput("non-finite-position", "A vertex of a skin has no finite position.");
}

} // namespace lissom
