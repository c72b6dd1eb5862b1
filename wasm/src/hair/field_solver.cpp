#include "lissom/hair/field_solver.h"

#include "lissom/mesh/errors.h"

#include <string>

namespace lissom {

ConstraintChange constraint_change(std::span<const FieldConstraint> held, std::span<const FieldConstraint> wanted,
                                   int node_count) {
    enum : char { absent = 0, is_held = 1, is_wanted = 2 };
    std::vector<char> state(static_cast<std::size_t>(node_count), absent);
    for (const FieldConstraint& c : held) state[static_cast<std::size_t>(c.node)] = is_held;
    ConstraintChange change;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const FieldConstraint& c = wanted[i];
        const bool inside = c.node >= 0 && c.node < node_count;
        if (!inside || !c.vector.allFinite() || (state[static_cast<std::size_t>(c.node)] & is_wanted))
            throw InvalidInput("constraint-node", "constraint " + std::to_string(i) + " names node " +
                                                      std::to_string(c.node) + (inside ? " twice or with a vector that is not finite"
                                                                                       : ", which the grid does not have"));
        char& s = state[static_cast<std::size_t>(c.node)];
        if (s == absent) change.added.push_back(static_cast<int>(i));
        s = static_cast<char>(s | is_wanted);
    }
    for (std::size_t i = 0; i < held.size(); ++i)
        if (!(state[static_cast<std::size_t>(held[i].node)] & is_wanted)) change.removed.push_back(static_cast<int>(i));
    return change;
}

} // namespace lissom
