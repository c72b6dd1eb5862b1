#include "lissom/curve/links.h"

#include "lissom/mesh/errors.h"

#include <string>

namespace lissom {

LinkOrder link_order(int curves, std::span<const CurveLink> links) {
    LinkOrder result;
    result.link.assign(curves, -1);
    result.linked.assign(curves, false);
    for (int k = 0; k < static_cast<int>(links.size()); ++k) {
        const auto& [child, parent, at] = links[k];
        const std::string which = "Link " + std::to_string(k);
        if (child < 0 || child >= curves || parent < 0 || parent >= curves || !(at >= 0 && at <= 1))
            throw InvalidInput("link-range", which + " joins curves that are not there, or at a place outside 0 to 1.");
        if (child == parent) throw InvalidInput("link-ring", which + " hangs a curve on itself. Choose another parent.");
        if (result.link[child] >= 0)
            throw InvalidInput("link-twice", which + " gives a second parent to curve " + std::to_string(child) + ". A curve hangs on one other.");
        result.link[child] = k;
        result.linked[child] = result.linked[parent] = true;
    }
    result.root.assign(curves, -1);
    std::vector<bool> placed(curves, false);
    for (int c = 0; c < curves; ++c) {
        std::vector<int> way; // up to a curve that is placed, or to a root
        for (int at = c; !placed[at]; at = links[result.link[at]].parent) {
            way.push_back(at);
            if (static_cast<int>(way.size()) > curves)
                throw InvalidInput("link-ring", "The links of curve " + std::to_string(c) + " close a ring. Take one of them away.");
            if (result.link[at] < 0) break;
        }
        for (auto at = way.rbegin(); at != way.rend(); ++at) {
            const int link = result.link[*at];
            result.root[*at] = link < 0 ? *at : result.root[links[link].parent];
            placed[*at] = true;
            result.order.push_back(*at);
        }
    }
    return result;
}

} // namespace lissom
