#include "lissom/hair/style.h"
#include "node_vectors.h"

namespace lissom {

std::vector<FieldConstraint> style_constraints(const HairStyle& style, const HeadDistance& head, const Grid& grid) {
    NodeVectors streams(grid), partings(grid), tails(grid);
    for (const StreamCurve& curve : style.streams) add_stream(streams, curve);
    for (const DividingCurve& curve : style.partings) add_parting(partings, curve, head);
    for (const Ponytail& tail : style.ponytails) add_ponytail(tails, tail);

    std::map<int, Eigen::Vector3d> wanted;
    for (const NodeVectors* kind : {&streams, &partings, &tails}) kind->write(wanted);

    std::vector<FieldConstraint> out;
    out.reserve(wanted.size());
    for (const auto& [node, vector] : wanted) out.push_back({node, vector});
    return out;
}

} // namespace lissom
