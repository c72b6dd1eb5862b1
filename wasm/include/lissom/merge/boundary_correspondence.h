#pragma once

#include "lissom/mesh/types.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lissom {

/// One vertex of the seam-to-be, in the order of the source loop.
struct SeamPoint {
    int source = -1;     ///< place in the source loop; −1: the source has no vertex here
    int target = -1;     ///< place in the target loop; −1: the target has no vertex here; at least one is set
    int source_edge = 0; ///< where source < 0: it lies on the edge from this place to the next …
    int target_edge = 0;
    double source_fraction = 0; ///< … at this fraction of its length
    double target_fraction = 0;
};

/// Two closed polylines matched point for point: by their keys, and by arc length between those (Fu 3.3.1).
///
/// The target loop runs backwards here, so that both have the source's surface to their left and the target's to their
/// right. Vertices that fall close together become one point: the source's moves to the target's.
struct LoopMatch {
    std::vector<int> source; ///< vertices, from the first key on
    std::vector<int> target; ///< vertices in the same direction, from the first key on
    std::vector<SeamPoint> points;
    /// Per source place: target edge and fraction by arc length alone, before vertices come together.
    std::vector<std::pair<int, double>> at_target;
};

/// Thrown as `keys-reversed`: the keys run around both loops in the same direction although the surfaces face the
/// same way, which is so where one of them is inside out.
inline constexpr const char* k_keys_reversed = "keys-reversed";

/// @param source_loop,target_loop  vertices, each with its own surface to the left
/// @param keys  (source vertex, target vertex): at least one; any order
/// @throws InvalidInput `no-key`, `key-not-on-boundary`, `key-repeated`, `keys-out-of-order`, `keys-reversed`
[[nodiscard]] LoopMatch match_loops(const Points& source, const std::vector<int>& source_loop, const Points& target,
                                    const std::vector<int>& target_loop, std::span<const std::pair<int, int>> keys);

/// Loops whose vertices are partners one by one: the first of both, then the source's in its order and the target's
/// backwards. Both have as many.
[[nodiscard]] LoopMatch match_one_by_one(const std::vector<int>& source_loop, const std::vector<int>& target_loop);

/// The key that lets the source loop fit the target loop best by a similarity, for users who give none. Arc length
/// decides the partners; at most 512 places of the target are tried.
[[nodiscard]] std::pair<int, int> best_key(const Points& source, const std::vector<int>& source_loop, const Points& target,
                                           const std::vector<int>& target_loop);

} // namespace lissom
